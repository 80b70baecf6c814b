// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Input: a letter for the message's type, "1" or "2" for ROS 1 or CDR, a definition (empty for the
// well-known one), a zero, the message.
#include "fuzz/fuzz_target.hpp"
#include "setsquare/io/ros/echo_choice.hpp"
#include "setsquare/io/ros/laser_scan_to_scan.hpp"
#include "setsquare/io/ros/message_decoder.hpp"
#include "setsquare/io/ros/message_encoder.hpp"
#include "setsquare/io/ros/mounting.hpp"
#include "setsquare/io/ros/point_slice.hpp"
#include "setsquare/io/ros/transform_tree.hpp"

namespace setsquare::fuzz {
namespace {

struct Input {
  MessageTopic topic;
  std::string_view message;
};

/// What comes of a decoded message keeps its laws.
void use(ros::LaserScan& message) {
  Scan scan;
  if (!scan_from_laser_scan(ros::LaserScan(message), scan).fault.empty()) return;
  require(scan.num_beams() > 0);
  scan.validate();
  const Eigen::Isometry3d tilted(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()));
  ros::MountedScans().mount(ros::mounting_from_transform(tilted), scan);
  scan.validate();
}

void use(ros::MultiEchoLaserScan& message) {
  choose_echoes(message, ros::EchoChoice::kStrongest);
  use(static_cast<ros::LaserScan&>(message));
}

void use(ros::PointCloud2& message) {
  for (const auto kind : {ros::SliceKind::kAuto, ros::SliceKind::kRing, ros::SliceKind::kHeights}) {
    ros::SliceParams params;
    params.kind = kind;
    ros::PointSlicer slicer(params);
    Scan scan;
    if (slicer.slice(message, Eigen::Isometry3d::Identity(), scan).empty()) scan.validate();
  }
}

void use(ros::TfMessage& message) {
  ros::TransformTree tree;
  for (std::size_t i = 0; i < message.transforms.size(); ++i) {
    const auto& transform = message.transforms[i];
    static_cast<void>(i % 2 == 0 ? tree.add(transform) : tree.add_static(transform));
  }
  if (message.transforms.empty()) return;
  const auto& first = message.transforms.front();
  const auto& last = message.transforms.back();
  const auto lookup = tree.look_up(first.frame_id, last.child_frame_id, last.stamp, 1.0);
  require(lookup.is_found() == lookup.reason.empty());
}

template <typename MessageType>
void use(MessageType&) {}

/// What was decoded can be written, and reads back without a fault.
template <typename MessageType>
void write_and_read_back(const std::string& type, const MessageType& message) {
  if constexpr (requires(ros::CdrWriter writer) { encode(message, writer); }) {
    ros::CdrWriter writer;
    encode(message, writer);
    MessageType back;
    ros::MessageDecoder<MessageType> decoder({"/topic", type, "", MessageEncoding::kCdr});
    require(decoder.decode(writer.message(), back).empty());
  }
}

template <typename MessageType>
void decode(Input input, const std::string& type) {
  input.topic.type = type;
  ros::MessageDecoder<MessageType> decoder(input.topic);
  MessageType message;
  const std::string fault(decoder.decode(input.message, message));
  require(fault == decoder.decode(input.message, message));
  if (!fault.empty()) return;
  write_and_read_back(type, message);
  use(message);
}

void decode(char letter, const Input& input) {
  switch (letter) {
    case 'L':
      return decode<ros::LaserScan>(input, "sensor_msgs/LaserScan");
    case 'M':
      return decode<ros::MultiEchoLaserScan>(input, "sensor_msgs/MultiEchoLaserScan");
    case 'C':
      return decode<ros::PointCloud2>(input, "sensor_msgs/PointCloud2");
    case 'O':
      return decode<ros::Odometry>(input, "nav_msgs/Odometry");
    case 'P':
      return decode<ros::PoseStamped>(input, "geometry_msgs/PoseStamped");
    case 'I':
      return decode<ros::Imu>(input, "sensor_msgs/Imu");
    case 'T':
      return decode<ros::TfMessage>(input, "tf2_msgs/TFMessage");
    case 'G':
      return decode<ros::OccupancyGrid>(input, "nav_msgs/OccupancyGrid");
    default:
      return decode<ros::Path>(input, "nav_msgs/Path");
  }
}

}  // namespace
}  // namespace setsquare::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace setsquare;
  const std::string bytes = fuzz::bytes_from(data, size);
  const std::size_t end_of_definition = bytes.find('\0', 2);
  if (size < 3 || end_of_definition == std::string::npos) return 0;
  fuzz::Input input;
  input.topic.encoding = bytes[1] == '1' ? MessageEncoding::kRos1 : MessageEncoding::kCdr;
  input.topic.definition = bytes.substr(2, end_of_definition - 2);
  input.message = std::string_view(bytes).substr(end_of_definition + 1);
  fuzz::decode(bytes[0], input);
  return 0;
}
