// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/pairs/study_sampling.hpp"

#include <algorithm>
#include <cmath>

#include "setsquare/core/angle.hpp"

namespace setsquare {

std::vector<double> study_times(const RobotPath& path, std::size_t num_scans, Random& random) {
  constexpr double kDistance_m = 0.4;
  constexpr double kAngle_rad = rad_from_deg(10.0);
  const std::vector<double> places = sample_times(path, kDistance_m, kAngle_rad);
  if (places.size() <= num_scans) return places;
  std::vector<std::size_t> chosen{0};
  while (chosen.size() < num_scans)
    chosen.push_back(chosen.back() + static_cast<std::size_t>(random.integer(5, 10)));
  const std::size_t last = places.size() - 1;
  std::size_t start = 0;
  if (chosen.back() <= last) {
    start = static_cast<std::size_t>(random.integer(0, static_cast<int>(last - chosen.back())));
  } else {
    // A short path: evenly over all of it.
    for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = i * last / (num_scans - 1);
  }
  std::vector<double> times;
  for (const std::size_t index : chosen) times.push_back(places[start + index]);
  return times;
}

}  // namespace setsquare
