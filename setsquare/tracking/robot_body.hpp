// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/core/pose2.hpp"

namespace setsquare {

/// Where one scanner is mounted on the frame of the robot that tracking follows.
///
/// That frame, the body, is the scanner of the first scan: a robot with one scanner is tracked as
/// that scanner, to the last bit, and each further scanner stands where its mounting puts it.
class BodyMounting {
 public:
  BodyMounting() = default;
  /// Of a scanner at T_base_sensor, the body being at T_base_body.
  BodyMounting(const Pose2& T_base_body, const Pose2& T_base_sensor)
      : is_body_(T_base_body == T_base_sensor),
        T_body_sensor_(is_body_ ? Pose2{} : T_base_body.inverse() * T_base_sensor) {}

  /// The scanner's pose in a frame where the body's is known.
  [[nodiscard]] Pose2 sensor_of(const Pose2& T_any_body) const {
    return is_body_ ? T_any_body : T_any_body * T_body_sensor_;
  }
  /// The body's pose in a frame where the scanner's is known.
  [[nodiscard]] Pose2 body_of(const Pose2& T_any_sensor) const {
    return is_body_ ? T_any_sensor : T_any_sensor * T_body_sensor_.inverse();
  }

 private:
  bool is_body_ = true;
  Pose2 T_body_sensor_;
};

}  // namespace setsquare
