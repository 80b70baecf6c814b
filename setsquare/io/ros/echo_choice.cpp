// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/ros/echo_choice.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace setsquare::ros {

void choose_echoes(MultiEchoLaserScan& message, EchoChoice choice) {
  const bool has_intensities = message.intensities.size() == message.echoes_m.size();
  std::vector<double> echoes_m;
  std::vector<double> intensities;
  message.ranges_m.clear();
  for (std::size_t beam = 0; beam < message.echoes_m.size(); ++beam) {
    message.echoes_m[beam].copy_to(echoes_m);
    std::size_t chosen = 0;
    if (choice == EchoChoice::kStrongest && has_intensities) {
      message.intensities[beam].copy_to(intensities);
      const auto strongest = std::max_element(intensities.begin(), intensities.end());
      if (intensities.size() == echoes_m.size()) {
        chosen = static_cast<std::size_t>(strongest - intensities.begin());
      }
    }
    message.ranges_m.push_back(echoes_m.empty() ? std::numeric_limits<double>::quiet_NaN()
                                                : echoes_m[chosen]);
  }
}

}  // namespace setsquare::ros
