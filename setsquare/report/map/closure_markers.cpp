// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/map/closure_markers.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace setsquare {
namespace {

struct MarkerPart {
  std::string_view name;
  std::string_view fields;
};

constexpr std::array<MarkerPart, 12> kMarkerParts = {{
    {"visualization_msgs/Marker",
     "std_msgs/Header header\nstring ns\nint32 id\nint32 type\nint32 action\n"
     "geometry_msgs/Pose pose\ngeometry_msgs/Vector3 scale\nstd_msgs/ColorRGBA color\n"
     "builtin_interfaces/Duration lifetime\nbool frame_locked\ngeometry_msgs/Point[] points\n"
     "std_msgs/ColorRGBA[] colors\nstring texture_resource\nsensor_msgs/CompressedImage texture\n"
     "visualization_msgs/UVCoordinate[] uv_coordinates\nstring text\nstring mesh_resource\n"
     "visualization_msgs/MeshFile mesh_file\nbool mesh_use_embedded_materials\n"},
    {"std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id\n"},
    {"builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n"},
    {"builtin_interfaces/Duration", "int32 sec\nuint32 nanosec\n"},
    {"geometry_msgs/Pose", "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n"},
    {"geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n"},
    {"geometry_msgs/Quaternion", "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n"},
    {"geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n"},
    {"std_msgs/ColorRGBA", "float32 r\nfloat32 g\nfloat32 b\nfloat32 a\n"},
    {"sensor_msgs/CompressedImage", "std_msgs/Header header\nstring format\nuint8[] data\n"},
    {"visualization_msgs/UVCoordinate", "float32 u\nfloat32 v\n"},
    {"visualization_msgs/MeshFile", "string filename\nuint8[] data\n"},
}};

constexpr std::int32_t kLineList = 5;
constexpr std::array<float, 4> kBelieved = {0.13F, 0.40F, 0.85F, 0.9F};
constexpr std::array<float, 4> kOutvoted = {0.85F, 0.20F, 0.15F, 0.9F};
constexpr double kLineWidth_m = 0.04;

void write_header(Timestamp stamp, std::string_view frame, ros::CdrWriter& writer) {
  constexpr std::int64_t kNsPerSecond = 1'000'000'000;
  writer.write(static_cast<std::int32_t>(stamp.ns / kNsPerSecond));
  writer.write(static_cast<std::uint32_t>(stamp.ns % kNsPerSecond));
  writer.write_text(frame);
}

template <typename Value, std::size_t kCount>
void write_all(const std::array<Value, kCount>& values, ros::CdrWriter& writer) {
  for (const Value value : values) writer.write(value);
}

void write_lines(std::span<const ClosureLine> lines, ros::CdrWriter& writer) {
  writer.write_count(2 * lines.size());
  for (const ClosureLine& line : lines) {
    write_all(std::array{line.from_m.x(), line.from_m.y(), 0.0}, writer);
    write_all(std::array{line.to_m.x(), line.to_m.y(), 0.0}, writer);
  }
  writer.write_count(2 * lines.size());
  for (const ClosureLine& line : lines) {
    const auto& color = line.is_believed ? kBelieved : kOutvoted;
    write_all(color, writer);
    write_all(color, writer);
  }
}

/// A message without content, as the parts of a marker that lines do not have.
void write_no_texture_and_mesh(ros::CdrWriter& writer) {
  writer.write_text("");          // texture_resource
  write_header({}, "", writer);   // texture
  writer.write_text("");          // its format
  writer.write_count(0);          // its data
  writer.write_count(0);          // uv_coordinates
  writer.write_text("");          // text
  writer.write_text("");          // mesh_resource
  writer.write_text("");          // mesh_file's name
  writer.write_count(0);          // its data
  writer.write(std::uint8_t{0});  // mesh_use_embedded_materials
}

}  // namespace

void encode_closure_markers(std::span<const ClosureLine> lines,
                            Timestamp stamp,
                            ros::CdrWriter& writer) {
  writer.start();
  writer.write_count(1);
  write_header(stamp, "map", writer);
  writer.write_text("closures");
  writer.write(std::int32_t{0});  // id
  writer.write(kLineList);
  writer.write(std::int32_t{0});                                     // action: add
  write_all(std::array{0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}, writer);  // pose
  write_all(std::array{kLineWidth_m, kLineWidth_m, kLineWidth_m}, writer);
  write_all(kBelieved, writer);
  writer.write(std::int32_t{0});  // lifetime: for ever
  writer.write(std::uint32_t{0});
  writer.write(std::uint8_t{0});  // frame_locked
  write_lines(lines, writer);
  write_no_texture_and_mesh(writer);
}

std::string closure_marker_definition() {
  std::string text = "visualization_msgs/Marker[] markers\n";
  for (const MarkerPart& part : kMarkerParts) {
    text.append(80, '=').append("\nMSG: ").append(part.name).append("\n").append(part.fields);
  }
  return text;
}

}  // namespace setsquare
