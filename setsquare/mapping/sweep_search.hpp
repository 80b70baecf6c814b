// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from mapper, its only caller: which sweep time a log's scans have is a question of its own.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "setsquare/map/sweep_report.hpp"
#include "setsquare/scan/scan.hpp"
#include "setsquare/tracking/sweep_trial.hpp"

namespace setsquare {

/// A scan as it came, with the odometry's pose.
struct MapperScan {
  Scan scan;
  std::optional<Pose2> T_wheels_base;
};
struct MapperTurnRate {
  Timestamp stamp;
  double turn_rad_per_s = 0.0;
};
using MapperInput = std::variant<MapperScan, MapperTurnRate>;

/// Puts the sweep time of the leading scanner, if it spins, on trial (SweepTrial), and keeps what
/// came meanwhile. Until the walls show a sweep its scans are taken as measured at once, whatever
/// the log states: drivers of cheap scanners turn the order of the beams around and leave the times
/// as they were. Then all that came is to be mapped again. What other scanners state is believed.
class SweepSearch {
 public:
  explicit SweepSearch(const ScanTrackerParams& params) : params_(params) {}

  /// What came, before it is mapped.
  void add(const Scan& scan, const std::optional<Pose2>& T_wheels_base);
  void add_turn_rate(Timestamp stamp, double turn_rad_per_s);

  /// The scan with the sweep time that was found; nothing where it is as it came.
  [[nodiscard]] std::optional<Scan> mended(const Scan& scan) const;

  /// All that came so far, once: where it is to be mapped again with mended scans. Else empty.
  [[nodiscard]] std::vector<MapperInput> take_to_map_again();

  [[nodiscard]] const SweepReport& report() const { return report_; }

 private:
  void begin(const Scan& scan);
  void settle();

  ScanTrackerParams params_;
  std::optional<std::uint32_t> scanner_;  ///< The leading one.
  std::optional<SweepTrial> trial_;
  std::vector<MapperInput> inputs_;  ///< While the trial lasts.
  bool must_map_again_ = false;
  SweepReport report_;
};

}  // namespace setsquare
