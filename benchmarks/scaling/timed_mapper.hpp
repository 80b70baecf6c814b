// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "setsquare/mapping/mapper.hpp"
#include "setsquare/mapping/mapper_params.hpp"

namespace setsquare {

/// Where the time of a mapping went: processor time of all threads, in s. It depends less than wall
/// time on what else the machine does.
struct MapperTimes {
  double tracking_s = 0.0;
  double closing_s = 0.0;  ///< Scans at which loops were looked for, their tracking included.
  double finishing_s = 0.0;
  double wall_s = 0.0;  ///< Wall time of it all.

  [[nodiscard]] double all_s() const { return tracking_s + closing_s + finishing_s; }
};

/// A mapper with a stopwatch.
class TimedMapper {
 public:
  explicit TimedMapper(const MapperParams& params) : params_(params), mapper_(params) {}

  void add(const Scan& scan, const std::optional<Pose2>& T_wheels_base);
  [[nodiscard]] Map finish();
  [[nodiscard]] const MapperTimes& times() const { return times_; }
  [[nodiscard]] std::size_t num_keyframes() const { return num_keyframes_; }

 private:
  /// Whether the keyframe that was just added is one at which Mapper looks for loops.
  [[nodiscard]] bool is_closing() const;

  MapperParams params_;
  Mapper mapper_;
  MapperTimes times_;
  std::size_t num_keyframes_ = 0;
  std::size_t num_closed_ = 0;
};

}  // namespace setsquare
