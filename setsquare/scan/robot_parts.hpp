// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// Finds what a scanner sees of its own robot: posts, wheels, a mast. Such returns stand still
/// whatever the robot does. In a bare corridor, where nothing else tells the way, they say that it
/// stands still, and they are seen again at every place.
///
/// The circle about the scanner is divided into sectors. Scans count that differ from the one that
/// counted before in most of their sectors: the robot has turned, or is elsewhere. A sector whose
/// nearest return is within a robot's size and the same in all of them but one shows a part of the
/// robot, if what it belongs to ends: beside a wall that a robot follows are other sectors of it.
class RobotParts {
 public:
  /// The next scan of one scanner.
  void add(const Scan& scan);

  /// Whether more scans are needed; false as soon as none of the near returns has stayed.
  [[nodiscard]] bool is_open() const { return is_open_; }

  /// How many sectors show a part; 0 while it is open.
  [[nodiscard]] std::size_t num_sectors() const;

  /// The share of the circle that they take.
  [[nodiscard]] double share_of_circle() const;

  /// The scan with the robot's parts made invalid; nothing where it sees none.
  [[nodiscard]] std::optional<Scan> without(const Scan& scan) const;

 private:
  struct Sector {
    double range_m = 0.0;  ///< Of the nearest return, in the scans that counted; 0 for none.
    double last_range_m = 0.0;
    std::size_t num_missing = 0;  ///< Of the scans that counted.
    bool is_part = false;
  };

  [[nodiscard]] std::size_t sector_of(const Scan& scan, std::size_t beam) const;
  /// The nearest return of each sector; infinite where beams met nothing, 0 where there are none.
  [[nodiscard]] std::vector<double> nearest_m(const Scan& scan) const;
  void begin(const Scan& scan);
  [[nodiscard]] bool has_changed(const std::vector<double>& ranges_m) const;
  [[nodiscard]] bool may_be_part(const Sector& sector) const;
  [[nodiscard]] bool shows_part(double range_m, std::size_t sector) const;
  /// Whether what a sector belongs to ends on either side, in the last scan.
  [[nodiscard]] bool is_bounded(std::size_t sector) const;
  void settle();

  bool is_open_ = true;
  std::size_t num_scans_ = 0;  ///< That counted.
  std::vector<Sector> sectors_;
};

}  // namespace setsquare
