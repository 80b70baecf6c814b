// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/scaling/timed_mapper.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>

namespace setsquare {
namespace {

/// Processor time and wall time since it was made.
class Stopwatch {
 public:
  [[nodiscard]] double processor_s() const {
    return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC;
  }
  [[nodiscard]] double wall_s() const {
    return std::chrono::duration<double>(Clock::now() - wall_start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::clock_t start_ = std::clock();
  Clock::time_point wall_start_ = Clock::now();
};

}  // namespace

void TimedMapper::add(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
  const Stopwatch stopwatch;
  const bool is_keyframe = mapper_.add(scan, T_wheels_base).is_keyframe;
  const double elapsed_s = stopwatch.processor_s();
  times_.wall_s += stopwatch.wall_s();
  num_keyframes_ += is_keyframe;
  if (is_keyframe && is_closing()) {
    times_.closing_s += elapsed_s;
    num_closed_ = num_keyframes_;
  } else {
    times_.tracking_s += elapsed_s;
  }
}

Map TimedMapper::finish() {
  const Stopwatch stopwatch;
  Map track = mapper_.finish();
  times_.finishing_s += stopwatch.processor_s();
  times_.wall_s += stopwatch.wall_s();
  return track;
}

bool TimedMapper::is_closing() const {
  const auto growth =
      static_cast<std::size_t>(params_.closing_growth * static_cast<double>(num_closed_));
  return num_keyframes_ >= num_closed_ + std::max(params_.min_closing_growth, growth);
}

}  // namespace setsquare
