// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/ros/builtin_definitions.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "setsquare/io/ros/message_definition.hpp"

namespace setsquare::ros {
namespace {

struct KnownType {
  std::string_view name;
  std::string_view fields;
};

/// What ROS 1 writes otherwise than ROS 2.
constexpr std::array<KnownType, 2> kRos1Types = {{
    {"std_msgs/Header", "uint32 seq\ntime stamp\nstring frame_id\n"},
    {"nav_msgs/MapMetaData",
     "time map_load_time\nfloat32 resolution\nuint32 width\nuint32 height\n"
     "geometry_msgs/Pose origin\n"},
}};

constexpr std::array<KnownType, 28> kKnownTypes = {{
    {"builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n"},
    {"std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id\n"},
    {"geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n"},
    {"geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n"},
    {"geometry_msgs/Quaternion", "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n"},
    {"geometry_msgs/Pose", "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n"},
    {"geometry_msgs/Twist", "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n"},
    {"geometry_msgs/Transform",
     "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n"},
    {"geometry_msgs/PoseWithCovariance", "geometry_msgs/Pose pose\nfloat64[36] covariance\n"},
    {"geometry_msgs/TwistWithCovariance", "geometry_msgs/Twist twist\nfloat64[36] covariance\n"},
    {"geometry_msgs/PoseStamped", "std_msgs/Header header\ngeometry_msgs/Pose pose\n"},
    {"geometry_msgs/PoseWithCovarianceStamped",
     "std_msgs/Header header\ngeometry_msgs/PoseWithCovariance pose\n"},
    {"geometry_msgs/TransformStamped",
     "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n"},
    {"sensor_msgs/LaserScan",
     "std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max\nfloat32 angle_increment\n"
     "float32 time_increment\nfloat32 scan_time\nfloat32 range_min\nfloat32 range_max\n"
     "float32[] ranges\nfloat32[] intensities\n"},
    {"sensor_msgs/LaserEcho", "float32[] echoes\n"},
    {"sensor_msgs/MultiEchoLaserScan",
     "std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max\nfloat32 angle_increment\n"
     "float32 time_increment\nfloat32 scan_time\nfloat32 range_min\nfloat32 range_max\n"
     "sensor_msgs/LaserEcho[] ranges\nsensor_msgs/LaserEcho[] intensities\n"},
    {"sensor_msgs/PointField", "string name\nuint32 offset\nuint8 datatype\nuint32 count\n"},
    {"sensor_msgs/PointCloud2",
     "std_msgs/Header header\nuint32 height\nuint32 width\nsensor_msgs/PointField[] fields\n"
     "bool is_bigendian\nuint32 point_step\nuint32 row_step\nuint8[] data\nbool is_dense\n"},
    {"sensor_msgs/Imu",
     "std_msgs/Header header\ngeometry_msgs/Quaternion orientation\n"
     "float64[9] orientation_covariance\ngeometry_msgs/Vector3 angular_velocity\n"
     "float64[9] angular_velocity_covariance\ngeometry_msgs/Vector3 linear_acceleration\n"
     "float64[9] linear_acceleration_covariance\n"},
    {"nav_msgs/Odometry",
     "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/PoseWithCovariance pose\n"
     "geometry_msgs/TwistWithCovariance twist\n"},
    {"nav_msgs/Path", "std_msgs/Header header\ngeometry_msgs/PoseStamped[] poses\n"},
    {"nav_msgs/MapMetaData",
     "builtin_interfaces/Time map_load_time\nfloat32 resolution\nuint32 width\nuint32 height\n"
     "geometry_msgs/Pose origin\n"},
    {"nav_msgs/OccupancyGrid", "std_msgs/Header header\nnav_msgs/MapMetaData info\nint8[] data\n"},
    {"tf2_msgs/TFMessage", "geometry_msgs/TransformStamped[] transforms\n"},
    {"diagnostic_msgs/KeyValue", "string key\nstring value\n"},
    {"diagnostic_msgs/DiagnosticStatus",
     "byte level\nstring name\nstring message\nstring hardware_id\n"
     "diagnostic_msgs/KeyValue[] values\n"},
    {"diagnostic_msgs/DiagnosticArray",
     "std_msgs/Header header\ndiagnostic_msgs/DiagnosticStatus[] status\n"},
    {"tf/tfMessage", "geometry_msgs/TransformStamped[] transforms\n"},
}};

const KnownType* find_known(std::span<const KnownType> types, std::string_view name) {
  const auto found = std::find_if(
      types.begin(), types.end(), [name](const KnownType& type) { return type.name == name; });
  return found == types.end() ? nullptr : &*found;
}

const KnownType* find_known(std::string_view name, MessageEncoding encoding) {
  const KnownType* ros1 = find_known(kRos1Types, name);
  return encoding == MessageEncoding::kRos1 && ros1 != nullptr ? ros1
                                                               : find_known(kKnownTypes, name);
}

/// Appends the known types that this one's fields name and that are not in the list yet.
void add_parts(std::vector<const KnownType*>& types,
               const KnownType& owner,
               MessageEncoding encoding) {
  const MessageDefinition definition = parse_message_definition(owner.name, owner.fields);
  for (const FieldDefinition& field : definition.types.front().fields) {
    const KnownType* part = find_known(field.type, encoding);
    if (part == nullptr || std::find(types.begin(), types.end(), part) != types.end()) continue;
    types.push_back(part);
    add_parts(types, *part, encoding);
  }
}

}  // namespace

std::string builtin_definition(std::string_view type, MessageEncoding encoding) {
  const KnownType* own = find_known(plain_type_name(type), encoding);
  if (own == nullptr) return {};
  std::vector<const KnownType*> types = {own};
  add_parts(types, *own, encoding);
  std::string text(own->fields);
  for (std::size_t i = 1; i < types.size(); ++i) {
    text.append(80, '=').append("\nMSG: ").append(types[i]->name).append("\n");
    text.append(types[i]->fields);
  }
  return text;
}

}  // namespace setsquare::ros
