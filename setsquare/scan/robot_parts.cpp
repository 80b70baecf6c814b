// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/scan/robot_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "setsquare/core/angle.hpp"

namespace setsquare {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
/// Parts of a robot are nearer than its size to its scanner.
constexpr double kRobotSize_m = 1.0;
/// Ranges of a part differ by less: noise, and its own shape within a sector.
constexpr double kSame_m = 0.05;
/// Behind the edge of a part a scanner sees farther by this at least.
constexpr double kEdge_m = 0.15;
/// Scans that must show a part, each of a robot that has moved since the one before, ...
constexpr std::size_t kNumScans = 8;
/// ... and of these, how many may miss it.
constexpr std::size_t kMaxMissing = 1;
constexpr double kSectorWidth_rad = rad_from_deg(1.0);

}  // namespace

std::size_t RobotParts::sector_of(const Scan& scan, std::size_t beam) const {
  const double turns = scan.bearing_rad(beam) / kTwoPi;
  const auto num = static_cast<double>(sectors_.size());
  return std::min(static_cast<std::size_t>((turns - std::floor(turns)) * num), sectors_.size() - 1);
}

std::vector<double> RobotParts::nearest_m(const Scan& scan) const {
  std::vector<double> ranges_m(sectors_.size(), 0.0);
  for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
    const BeamOutcome outcome = scan.outcome(beam);
    if (outcome == BeamOutcome::kInvalid) continue;
    const double range_m = outcome == BeamOutcome::kReturn ? scan.ranges_m[beam] : kInfinite;
    double& nearest = ranges_m[sector_of(scan, beam)];
    nearest = nearest > 0.0 ? std::min(nearest, range_m) : range_m;
  }
  return ranges_m;
}

void RobotParts::begin(const Scan& scan) {
  const double width_rad = std::max(kSectorWidth_rad, 2.0 * std::abs(scan.bearing_step_rad));
  sectors_.resize(std::max<std::size_t>(1, static_cast<std::size_t>(kTwoPi / width_rad)));
  const std::vector<double> ranges_m = nearest_m(scan);
  for (std::size_t k = 0; k < sectors_.size(); ++k) {
    sectors_[k].range_m = sectors_[k].last_range_m = ranges_m[k];
  }
  num_scans_ = 1;
}

bool RobotParts::has_changed(const std::vector<double>& ranges_m) const {
  constexpr double kTolerance_m = 0.1;
  constexpr double kToleranceRatio = 0.03;
  constexpr double kLeastShare = 0.5;
  std::size_t num_compared = 0;
  std::size_t num_changed = 0;
  for (std::size_t k = 0; k < sectors_.size(); ++k) {
    const double last_m = sectors_[k].last_range_m;
    if (last_m == 0.0 || ranges_m[k] == 0.0 || last_m < kRobotSize_m) continue;
    ++num_compared;
    const bool is_same = ranges_m[k] == last_m ||
                         std::abs(ranges_m[k] - last_m) < kTolerance_m + kToleranceRatio * last_m;
    num_changed += is_same ? 0 : 1;
  }
  return num_compared > 0 &&
         static_cast<double>(num_changed) > kLeastShare * static_cast<double>(num_compared);
}

bool RobotParts::may_be_part(const Sector& sector) const {
  return sector.range_m > 0.0 && sector.range_m < kRobotSize_m && sector.num_missing <= kMaxMissing;
}

void RobotParts::add(const Scan& scan) {
  if (!is_open_ || scan.num_beams() == 0) return;
  if (sectors_.empty()) {
    begin(scan);
  } else {
    const std::vector<double> ranges_m = nearest_m(scan);
    if (!has_changed(ranges_m)) return;
    ++num_scans_;
    for (std::size_t k = 0; k < sectors_.size(); ++k) {
      Sector& sector = sectors_[k];
      sector.last_range_m = ranges_m[k];
      const bool is_seen = ranges_m[k] > 0.0;
      if (is_seen && std::abs(ranges_m[k] - sector.range_m) > kSame_m) ++sector.num_missing;
    }
  }
  const bool may_show_parts = std::any_of(
      sectors_.begin(), sectors_.end(), [&](const Sector& sector) { return may_be_part(sector); });
  if (!may_show_parts || num_scans_ == kNumScans) settle();
}

bool RobotParts::is_bounded(std::size_t sector) const {
  const std::size_t n = sectors_.size();
  const auto ends = [&](std::size_t step) {
    std::size_t at = sector;
    const auto is_behind = [&](std::size_t next) {
      const double next_m = sectors_[next].last_range_m;
      return next_m == 0.0 || next_m > sectors_[at].last_range_m + kEdge_m;
    };
    for (std::size_t i = 0; i < n; ++i, at = (at + step) % n) {
      const std::size_t next = (at + step) % n;
      if (is_behind(next)) return true;
      // The sector at the edge may show the part in some scans only.
      if (!may_be_part(sectors_[next])) return is_behind((next + step) % n);
    }
    return true;
  };
  return ends(1) && ends(n - 1);
}

void RobotParts::settle() {
  is_open_ = false;
  std::vector<bool> is_part(sectors_.size());
  for (std::size_t k = 0; k < sectors_.size(); ++k) {
    is_part[k] = num_scans_ == kNumScans && may_be_part(sectors_[k]) && is_bounded(k);
  }
  for (std::size_t k = 0; k < sectors_.size(); ++k) sectors_[k].is_part = is_part[k];
}

std::size_t RobotParts::num_sectors() const {
  return static_cast<std::size_t>(std::count_if(
      sectors_.begin(), sectors_.end(), [](const Sector& sector) { return sector.is_part; }));
}

double RobotParts::share_of_circle() const {
  if (sectors_.empty()) return 0.0;
  return static_cast<double>(num_sectors()) / static_cast<double>(sectors_.size());
}

bool RobotParts::shows_part(double range_m, std::size_t sector) const {
  const std::size_t n = sectors_.size();
  // The beams of a scanner that spins do not fall on the same bearings each time.
  for (const std::size_t k : {sector, (sector + 1) % n, (sector + n - 1) % n}) {
    if (sectors_[k].is_part && std::abs(range_m - sectors_[k].range_m) <= 2.0 * kSame_m) {
      return true;
    }
  }
  return false;
}

std::optional<Scan> RobotParts::without(const Scan& scan) const {
  if (num_sectors() == 0) return std::nullopt;
  const auto is_of_part = [&](std::size_t beam) {
    return scan.outcome(beam) == BeamOutcome::kReturn &&
           shows_part(scan.ranges_m[beam], sector_of(scan, beam));
  };
  std::size_t beam = 0;
  while (beam < scan.num_beams() && !is_of_part(beam)) ++beam;
  if (beam == scan.num_beams()) return std::nullopt;
  Scan without = scan;
  for (; beam < scan.num_beams(); ++beam) {
    if (is_of_part(beam)) without.ranges_m[beam] = 0.0;
  }
  return without;
}

}  // namespace setsquare
