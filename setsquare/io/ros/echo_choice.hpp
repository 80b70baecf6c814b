// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "setsquare/io/ros/messages.hpp"

namespace setsquare::ros {

/// Which of a beam's echoes is its range.
enum class EchoChoice : std::uint8_t {
  kFirst,      ///< The nearest: what a scanner with one echo measures through no glass or rain.
  kStrongest,  ///< The brightest; the first where the message has no intensities.
};

/// Fills ranges_m from the echoes. A beam without an echo gives NaN: the message does not say
/// whether it met nothing.
void choose_echoes(MultiEchoLaserScan& message, EchoChoice choice);

}  // namespace setsquare::ros
