// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/ros/message_definition.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "setsquare/io/ros/builtin_definitions.hpp"

namespace setsquare::message_definition_test {

using ros::builtin_definition;
using ros::FieldDefinition;
using ros::MessageDefinition;
using ros::Multiplicity;
using ros::parse_message_definition;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// "float32[9] covariance", as the parser understood it.
std::string to_text(const FieldDefinition& field) {
  const std::string count = field.multiplicity == Multiplicity::kOne ? ""
                            : field.multiplicity == Multiplicity::kSequence
                                ? "[]"
                                : "[" + std::to_string(field.array_size) + "]";
  return field.type + count + " " + field.name;
}

std::string only_field(const std::string& text) {
  const MessageDefinition definition = parse_message_definition("a/B", text);
  if (!definition.fault.empty()) return definition.fault;
  const auto& fields = definition.types.at(0).fields;
  return fields.size() == 1 ? to_text(fields[0]) : std::to_string(fields.size()) + " fields";
}

TEST(MessageDefinition, FieldsOfEveryForm) {
  EXPECT_EQ(only_field("float32 x"), "float32 x");
  EXPECT_EQ(only_field("\tfloat32 \t x\r\n"), "float32 x");
  EXPECT_EQ(only_field("# a comment\n\nfloat32 x # [m]"), "float32 x");
  EXPECT_EQ(only_field("float32[] ranges"), "float32[] ranges");
  EXPECT_EQ(only_field("float64[36] covariance"), "float64[36] covariance");
  EXPECT_EQ(only_field("float64[<=4] few"), "float64[] few");
  EXPECT_EQ(only_field("string<=10 name"), "string name");
  EXPECT_EQ(only_field("string<=10[<=5] names"), "string[] names");
  EXPECT_EQ(only_field("wstring<=10[2] names"), "wstring[2] names");
  EXPECT_EQ(only_field("geometry_msgs/msg/Pose[] poses"), "geometry_msgs/Pose[] poses");
  EXPECT_EQ(only_field("float32 speed 1.5"), "float32 speed");
  EXPECT_EQ(only_field("string name \"a # b\""), "string name");
  EXPECT_EQ(only_field("int32[] few [1, 2, 3]"), "int32[] few");
}

TEST(MessageDefinition, ConstantsAreNoFields) {
  for (const char* line : {"uint8 INT8=1",
                           "uint8 INT8 = 1",
                           "uint8 INT8 =1",
                           "uint8   INT8    =  1",
                           "string NAME=a # is part of it",
                           "string NAME='a=b'"}) {
    EXPECT_EQ(only_field(line), "0 fields") << line;
  }
}

TEST(MessageDefinition, WhatIsNoDefinitionIsToldByReason) {
  for (const char* line : {"float32",
                           "float32[ x",
                           "float32[-1] x",
                           "float32[99999999999] x",
                           "float32[a] x",
                           "float32 x-y",
                           "flo@t x",
                           "\x01\x02 x"}) {
    EXPECT_THAT(only_field(line), HasSubstr("a line that is no field")) << line;
  }
  EXPECT_THAT(only_field("module a {\n  module msg {"), HasSubstr("IDL"));
  EXPECT_THAT(only_field(std::string(80, '=') + "\nIDL: a/msg/B\nmodule a {"), HasSubstr("IDL"));
  EXPECT_THAT(only_field("// generated\n#include \"b.idl\"\nmodule a {"), HasSubstr("IDL"));
  EXPECT_THAT(only_field("int8 x\n" + std::string(80, '=') + "\nint8 y"), HasSubstr("MSG:"));
  EXPECT_THAT(only_field(std::string(200'000, '\n')), HasSubstr("too long"));
}

TEST(MessageDefinition, PartsAreFoundByFullNameByPackageAndHeaderEverywhere) {
  const std::string line = std::string(80, '=') + "\n";
  const auto definition = parse_message_definition(
      "a/msg/B",
      "Header header\nPart p\nother/Part q\n" + line + "MSG: std_msgs/Header\ntime stamp\n" + line +
          "MSG: a/Part\nint8 x\n" + line + "MSG: other/msg/Part\nint16 y\n");
  EXPECT_THAT(definition.fault, IsEmpty());
  ASSERT_THAT(definition.types, SizeIs(4));
  EXPECT_EQ(definition.types[0].name, "a/B");
  EXPECT_EQ(definition.find("Header", "a/B"), &definition.types[1]);
  EXPECT_EQ(definition.find("Part", "a/B"), &definition.types[2]);
  EXPECT_EQ(definition.find("other/Part", "a/B"), &definition.types[3]);
  EXPECT_EQ(definition.find("Part", "b/B"), nullptr);
  EXPECT_EQ(definition.find("Other", "a/B"), nullptr);
}

TEST(MessageDefinition, AHeaderOfRosBefore2010IsAHeader) {
  const std::string line = std::string(80, '=') + "\nMSG: ";
  const std::string text =
      "Header header\nfloat32 x\n" + line + "roslib/Header\nuint32 seq\ntime stamp\n";
  const auto old = parse_message_definition("a/B", text);
  EXPECT_EQ(old.find("Header", "a/B"), &old.types.at(1));
  const auto both = parse_message_definition("a/B", text + line + "std_msgs/Header\ntime stamp\n");
  EXPECT_EQ(both.find("Header", "a/B"), &both.types.at(2));
}

TEST(MessageDefinition, EveryWellKnownDefinitionIsCompleteInBothForms) {
  for (const char* type : {"sensor_msgs/LaserScan",
                           "sensor_msgs/MultiEchoLaserScan",
                           "sensor_msgs/PointCloud2",
                           "sensor_msgs/Imu",
                           "nav_msgs/Odometry",
                           "nav_msgs/Path",
                           "nav_msgs/OccupancyGrid",
                           "geometry_msgs/PoseStamped",
                           "geometry_msgs/PoseWithCovarianceStamped",
                           "tf2_msgs/TFMessage",
                           "tf/tfMessage"}) {
    for (const auto encoding : {MessageEncoding::kRos1, MessageEncoding::kCdr}) {
      const std::string text = builtin_definition(type, encoding);
      const auto definition = parse_message_definition(type, text);
      ASSERT_THAT(definition.fault, IsEmpty()) << type;
      for (const auto& part : definition.types) {
        EXPECT_THAT(part.fields, ::testing::Not(IsEmpty())) << part.name;
        for (const auto& field : part.fields) {
          EXPECT_TRUE(ros::primitive_by_name(field.type) ||
                      definition.find(field.type, part.name) != nullptr)
              << field.type;
        }
      }
      const bool is_ros1 = encoding == MessageEncoding::kRos1;
      EXPECT_EQ(text.find("uint32 seq") != std::string::npos, is_ros1) << type;
      EXPECT_EQ(text.find("builtin_interfaces/Time stamp") == std::string::npos, is_ros1) << type;
    }
  }
  EXPECT_EQ(builtin_definition("a/B", MessageEncoding::kCdr), "");
}

}  // namespace setsquare::message_definition_test
