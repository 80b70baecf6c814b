// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "setsquare/io/ros/messages.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare::ros {

/// What is odd about a LaserScan. Each is mended or refused as its description says.
enum class ScanOddity : std::uint8_t {
  kNoStamp,
  kAngleMaxOneBeamOff,
  kAngleMaxOff,
  kNoIncrement,
  kClockwise,
  kRepeatedBeam,
  kMoreThanOneTurn,
  kNoRangeMax,
  kNoRangeMin,
  kRangeLimitsReversed,
  kRangesBeyondMax,
  kNoBeams,
  kNoAngles,
  kEndlessSweep,
};
inline constexpr std::size_t kNumScanOddities = 14;

/// The oddities of one scan.
class ScanOddities {
 public:
  void add(ScanOddity oddity) { set_.set(static_cast<std::size_t>(oddity)); }
  [[nodiscard]] bool has(ScanOddity oddity) const { return set_[static_cast<std::size_t>(oddity)]; }
  [[nodiscard]] bool empty() const { return set_.none(); }
  bool operator==(const ScanOddities&) const = default;

 private:
  std::bitset<kNumScanOddities> set_;
};

/// An oddity in words, for a report that counts it.
struct OddityText {
  std::string_view what;    ///< "angle_max is not the last beam's: ...".
  std::string_view remedy;  ///< What was done, or what the user can do.
};
[[nodiscard]] OddityText describe(ScanOddity oddity);

struct ScanConversion {
  std::string_view fault;  ///< Why the message is no scan; empty if it is.
  ScanOddities oddities;
};

/// Makes a LaserScan (or a MultiEchoLaserScan whose echoes were chosen) into a scan in the sensor's
/// frame; the mounting is left as it is. The ranges are moved, and the message gets the scan's old
/// memory for its next ones. On a fault the scan is half filled.
///
/// angle_increment and the number of beams win over angle_max, which many drivers get wrong, where
/// the beams stay within one turn; else angle_min and angle_max win where they span one turn. Of a
/// full turn's last beam that points where the first did, the last is left out. Ranges are taken as
/// they are: Scan::outcome judges them as REP 117 asks (-Inf too near, +Inf nothing within reach,
/// NaN nothing known). A sweep of more than kLongestSweep_s is none.
[[nodiscard]] ScanConversion scan_from_laser_scan(LaserScan&& message, Scan& scan);

}  // namespace setsquare::ros
