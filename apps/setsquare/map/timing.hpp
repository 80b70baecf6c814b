// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace setsquare::app {

/// A part of the work, and how long it took by the clock on the wall.
struct StageTime {
  std::string stage;
  double wall_s = 0.0;
};

/// Where the time of a run goes: one stage after the other.
///
///   StageClock clock;
///   clock.begin("track");
///   ...
///   clock.begin("grid");     // ends the stage before
///   ...
///   timing_json({clock.stages(), ...});
class StageClock {
 public:
  /// Ends the stage that runs and begins this one; one that was there before goes on.
  void begin(const std::string& stage);
  /// Ends the stage that runs, if one does.
  void end();

  /// The stages that have ended, in the order of their first beginnings.
  [[nodiscard]] const std::vector<StageTime>& stages() const { return stages_; }

 private:
  using Clock = std::chrono::steady_clock;

  std::vector<StageTime> stages_;
  std::size_t running_ = kNone;
  Clock::time_point start_;

  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
};

/// What timing.json reports of a run.
struct MapTiming {
  std::vector<StageTime> stages;
  std::size_t num_scans = 0;
  int num_threads = 1;
};

/// The content of timing.json: the stages and their sum, the time per scan, the threads, the
/// process's peak memory so far, the machine and the build. Of all outputs it alone differs from
/// run to run.
[[nodiscard]] std::string timing_json(const MapTiming& timing);

/// The most memory that the process has had so far, in bytes; 0 where the system does not report
/// it.
[[nodiscard]] std::uint64_t peak_memory_bytes();

}  // namespace setsquare::app
