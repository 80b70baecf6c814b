// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Writes MRPT objects byte by byte, for the tests of their reader.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/io/raw_bytes.hpp"

namespace setsquare::testing {

/// A whole object: header, body, end flag.
inline std::string mrpt_object(const std::string& class_name,
                               int version,
                               const std::string& body) {
  return static_cast<char>(0x80U | class_name.size()) + class_name + static_cast<char>(version) +
         body + '\x88';
}

/// Ticks of 100 ns since 1601 of a time in seconds since 1970.
inline std::uint64_t mrpt_ticks(double seconds) {
  return 116'444'736'000'000'000ULL + static_cast<std::uint64_t>(seconds * 1e7);
}

struct MrptScan {
  float aperture_rad = 3.0F;
  bool is_right_to_left = true;
  float max_range_m = 30.0F;
  double x_m = 0.25;
  double y_m = -0.5;
  bool is_upside_down = false;
  std::vector<float> ranges_m = {1.5F, 2.5F, 80.0F, 0.5F};
  std::string valid = std::string("\1\1\0\0", 4);
  double seconds = 1136100000.5;
  std::string label = "FRONT";
};

inline std::string mrpt_matrix(const std::string& class_name, const std::vector<double>& values) {
  std::string body = raw<std::uint32_t>(4) + raw<std::uint32_t>(4);
  for (const double value : values) {
    body += class_name == "CMatrixD" ? raw(value) : raw(static_cast<float>(value));
  }
  return mrpt_object(class_name, 0, body);
}

/// CPose3D of any version, without rotation but for the half turn about x.
inline std::string mrpt_pose3(int version, const MrptScan& scan) {
  const double up = scan.is_upside_down ? -1.0 : 1.0;
  const std::vector<double> matrix = {
      1, 0, 0, scan.x_m, 0, up, 0, scan.y_m, 0, 0, up, 0.3, 0, 0, 0, 1};
  if (version == 0) return mrpt_object("CPose3D", 0, mrpt_matrix("CMatrix", matrix));
  if (version == 1) return mrpt_object("CPose3D", 1, mrpt_matrix("CMatrixD", matrix));
  std::string body = raw(scan.x_m) + raw(scan.y_m) + raw(0.3);
  if (version == 2) {
    const double w = scan.is_upside_down ? 0.0 : 1.0;
    return mrpt_object("CPose3D", 2, body + raw(w) + raw(1.0 - w) + raw(0.0) + raw(0.0));
  }
  for (const double element : {1.0, 0.0, 0.0, 0.0, up, 0.0, 0.0, 0.0, up}) body += raw(element);
  return mrpt_object("CPose3D", 3, body);
}

/// CObservation2DRangeScan of any version, its pose of any version.
inline std::string mrpt_scan(int version, int pose_version, const MrptScan& scan) {
  std::string body = raw(scan.aperture_rad) + static_cast<char>(scan.is_right_to_left ? 1 : 0) +
                     raw(scan.max_range_m) + mrpt_pose3(pose_version, scan);
  if (version < 6) body += mrpt_matrix("CMatrix", std::vector<double>(16, 0.0));
  body += raw(static_cast<std::uint32_t>(scan.ranges_m.size()));
  for (const float range_m : scan.ranges_m) body += raw(range_m);
  if (version >= 1) body += scan.valid;
  if (version >= 2) body += raw(0.01F);
  if (version >= 3) body += raw(mrpt_ticks(scan.seconds));
  if (version >= 4) body += raw(0.004F);
  if (version >= 5) {
    body += raw(static_cast<std::uint32_t>(scan.label.size())) + scan.label + raw(0.0);
  }
  if (version >= 7) {
    body += '\1';
    for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) body += raw<std::int32_t>(7);
  }
  return mrpt_object("CObservation2DRangeScan", version, body);
}

inline std::string mrpt_pose2(int version, double x_m, double y_m, double theta_rad) {
  std::string body;
  for (const double value : {x_m, y_m, theta_rad}) {
    body += version == 0 ? raw(static_cast<float>(value)) : raw(value);
  }
  return mrpt_object("CPose2D", version, body);
}

/// CActionRobotMovement2D by odometry, versions 2 to 7.
inline std::string mrpt_movement(int version, double x_m, double y_m, double theta_rad) {
  const std::size_t model_bytes = version <= 3 ? 44 : version == 4 ? 48 : 56;
  std::string body =
      raw<std::int32_t>(0) + mrpt_pose2(1, x_m, y_m, theta_rad) + std::string(model_bytes, '\0');
  body += version < 7 ? '\1' + raw(0.5F) + raw(0.1F) : '\1' + raw(0.5) + raw(0.0) + raw(0.1);
  body += version < 7 ? '\0' + raw<std::int64_t>(0) : std::string(1, '\0');
  if (version >= 6) body += raw(mrpt_ticks(1136100000.25));
  return mrpt_object("CActionRobotMovement2D", version, body);
}

/// CObservationOdometry, versions 0 to 2.
inline std::string mrpt_odometry(int version, double x_m, double y_m, double theta_rad) {
  std::string body = mrpt_pose2(1, x_m, y_m, theta_rad) + raw<std::uint32_t>(3) + "ODO" +
                     raw(mrpt_ticks(1136100000.75));
  if (version == 1) body += '\0' + raw<std::int64_t>(0) + '\1' + raw(0.5F) + raw(0.25F);
  if (version == 2) body += '\0' + std::string("\1") + raw(0.5) + raw(0.0) + raw(0.25);
  return mrpt_object("CObservationOdometry", version, body);
}

/// CSensoryFrame (version 2) or CActionCollection (version 0) around objects.
inline std::string mrpt_container(const std::string& class_name,
                                  int version,
                                  const std::vector<std::string>& objects) {
  std::string body = raw(static_cast<std::uint32_t>(objects.size()));
  for (const std::string& object : objects) body += object;
  return mrpt_object(class_name, version, body);
}

}  // namespace setsquare::testing
