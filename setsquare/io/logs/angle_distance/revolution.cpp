// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/angle_distance/revolution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/median.hpp"
#include "setsquare/io/logs/record_stream.hpp"

namespace setsquare {
namespace {

constexpr double kSameBearing_rad = 1e-9;

/// The distances between neighbouring bearings; equal ones count once.
std::vector<double> spacings_of(const std::vector<BearingRange>& sorted) {
  std::vector<double> spacings_rad;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const double spacing_rad = sorted[i].bearing_rad - sorted[i - 1].bearing_rad;
    if (spacing_rad > kSameBearing_rad) spacings_rad.push_back(spacing_rad);
  }
  return spacings_rad;
}

/// Turns the beams around so that the first one follows the widest gap; bearings go on beyond pi.
void begin_behind_widest_gap(std::vector<BearingRange>& sorted) {
  std::size_t first = 0;
  double widest_rad = sorted.front().bearing_rad + kTwoPi - sorted.back().bearing_rad;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const double gap_rad = sorted[i].bearing_rad - sorted[i - 1].bearing_rad;
    if (gap_rad > widest_rad) {
      widest_rad = gap_rad;
      first = i;
    }
  }
  for (std::size_t i = 0; i < first; ++i) sorted[i].bearing_rad += kTwoPi;
  std::rotate(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(first), sorted.end());
}

}  // namespace

bool resample(std::vector<BearingRange>& beams, Scan& scan) {
  if (beams.empty()) return false;
  std::ranges::sort(beams, {}, &BearingRange::bearing_rad);
  begin_behind_widest_gap(beams);
  std::vector<double> spacings_rad = spacings_of(beams);
  if (spacings_rad.empty()) return false;
  const double first_rad = beams.front().bearing_rad;
  const double sweep_rad = beams.back().bearing_rad - first_rad;
  const double step_rad = std::max(upper_median(std::move(spacings_rad)),
                                   sweep_rad / static_cast<double>(kMaxBeams - 1));
  const auto beam_at = [&](double bearing_rad) {
    return static_cast<std::size_t>(std::lround((bearing_rad - first_rad) / step_rad));
  };
  scan.first_bearing_rad = first_rad;
  scan.bearing_step_rad = step_rad;
  scan.ranges_m.assign(beam_at(beams.back().bearing_rad) + 1,
                       std::numeric_limits<double>::quiet_NaN());
  for (const BearingRange& beam : beams) {
    double& range_m = scan.ranges_m[beam_at(beam.bearing_rad)];
    if (beam.range_m > 0.0 && !(beam.range_m >= range_m)) range_m = beam.range_m;
  }
  return true;
}

}  // namespace setsquare
