// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/survey/motion_survey.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace setsquare {
namespace {

constexpr double kLongStep_m = 0.5;
constexpr double kWideTurn_rad = rad_from_deg(15.0);
/// Beyond these too little of the one scan is in the other.
constexpr double kLongestStep_m = 2.0;
constexpr double kWidestTurn_rad = rad_from_deg(60.0);
constexpr std::uint64_t kScansAtRest = 10;

/// The bearings of a scan read in some way: `factor` times those given.
double bearing_factor(ScanReading reading) {
  switch (reading) {
    case ScanReading::kMirrored:
      return -1.0;
    case ScanReading::kFieldOf240:
      return 240.0 / 180.0;
    case ScanReading::kFieldOf270:
      return 270.0 / 180.0;
    case ScanReading::kFieldOf360:
      return 2.0;
    case ScanReading::kAsGiven:
    case ScanReading::kNotMoved:
      break;
  }
  return 1.0;
}

/// Fields of view differ less from each other than from anything else: they are no rivals.
bool are_rivals(ScanReading a, ScanReading b) {
  const auto is_field = [](ScanReading reading) {
    return reading == ScanReading::kFieldOf240 || reading == ScanReading::kFieldOf270 ||
           reading == ScanReading::kFieldOf360;
  };
  return !(is_field(a) && is_field(b));
}

bool is_near(double range_m, double expected_m) {
  constexpr double kTolerance_m = 0.1;
  constexpr double kToleranceRatio = 0.03;
  return std::abs(range_m - expected_m) < kTolerance_m + kToleranceRatio * expected_m;
}

/// The beam of a scan that points there, bearings taken `factor` times; nothing where none does.
std::optional<std::size_t> beam_towards(const Scan& scan, double bearing_rad, double factor) {
  const double turns = kTwoPi / std::abs(factor * scan.bearing_step_rad);
  double beam = (bearing_rad / factor - scan.first_bearing_rad) / scan.bearing_step_rad;
  if (beam < -0.5) beam += turns;
  beam = std::round(beam >= turns ? beam - turns : beam);
  if (!(beam >= 0.0 && beam < static_cast<double>(scan.num_beams()))) return std::nullopt;
  return static_cast<std::size_t>(beam);
}

/// Share of the returns of `before` that `after` sees where the motion takes them; nothing where
/// too few can be compared.
std::optional<double> explained_share(const Scan& before,
                                      const Scan& after,
                                      const Pose2& T_before_after,
                                      double factor) {
  constexpr std::size_t kNumLooks = 60;
  constexpr std::size_t kLeastCompared = 20;
  const Pose2 T_after_before = T_before_after.inverse();
  const std::size_t stride = std::max<std::size_t>(1, before.num_beams() / kNumLooks);
  std::size_t num_compared = 0;
  std::size_t num_explained = 0;
  for (std::size_t beam = 0; beam < before.num_beams(); beam += stride) {
    if (before.outcome(beam) != BeamOutcome::kReturn) continue;
    const double bearing_rad = factor * before.bearing_rad(beam);
    const double range_m = before.ranges_m[beam];
    const Eigen::Vector2d p_after =
        T_after_before *
        Eigen::Vector2d{range_m * std::cos(bearing_rad), range_m * std::sin(bearing_rad)};
    const auto seen = beam_towards(after, std::atan2(p_after.y(), p_after.x()), factor);
    if (!seen || after.outcome(*seen) != BeamOutcome::kReturn) continue;
    ++num_compared;
    num_explained += is_near(after.ranges_m[*seen], p_after.norm()) ? 1 : 0;
  }
  if (num_compared < kLeastCompared) return std::nullopt;
  return static_cast<double>(num_explained) / static_cast<double>(num_compared);
}

bool is_possible(ScanReading reading, const Scan& scan) {
  constexpr double kSlack_rad = rad_from_deg(2.0);
  return std::abs(bearing_factor(reading)) * scan.field_of_view_rad() <= kTwoPi + kSlack_rad;
}

}  // namespace

void MotionSurvey::keep(const Scan& scan, const Pose2& T_odom_base) {
  if (!reference_) reference_.emplace();
  reference_->scan = scan;  // its vector is used again
  reference_->T_odom_base = T_odom_base;
  num_since_ = 0;
}

/// All of the first hundred, then one of eight: they take most of a survey's time.
bool MotionSurvey::is_to_be_compared() {
  constexpr std::uint64_t kFirstMotions = 100;
  constexpr std::uint64_t kMotionsPerComparison = 8;
  ++num_motions_;
  return num_motions_ <= kFirstMotions || num_motions_ % kMotionsPerComparison == 0;
}

std::uint64_t MotionSurvey::num_decided() const {
  return std::accumulate(num_votes_.begin(), num_votes_.end(), std::uint64_t{0});
}

void MotionSurvey::add(const Scan& scan, const Pose2& T_odom_base) {
  const bool is_at_rest = T_odom_last_ && *T_odom_last_ == T_odom_base;
  T_odom_last_ = T_odom_base;
  ++num_since_;
  if (!reference_) {
    keep(scan, T_odom_base);
    return;
  }
  const Pose2 T_before_after = reference_->T_odom_base.inverse() * T_odom_base;
  const double step_m = std::hypot(T_before_after.x_m, T_before_after.y_m);
  const double turn_rad = std::abs(T_before_after.theta_rad);
  const bool is_far = !(step_m < kLongestStep_m && turn_rad < kWidestTurn_rad);
  if (is_far) {
    keep(scan, T_odom_base);
  } else if (step_m > kLongStep_m || turn_rad > kWideTurn_rad) {
    const Pose2& T_base_sensor = scan.T_base_sensor;
    if (is_to_be_compared())
      compare(scan, T_base_sensor.inverse() * T_before_after * T_base_sensor);
    keep(scan, T_odom_base);
  } else if (is_at_rest && T_odom_base == reference_->T_odom_base) {
    if (num_since_ % kScansAtRest == 0) compare_at_rest(scan);
  } else if (is_at_rest) {
    keep(scan, T_odom_base);  // the rest begins here
  }
}

void MotionSurvey::compare(const Scan& scan, const Pose2& T_before_after) {
  constexpr double kLeastExplained = 0.5;
  constexpr double kClearMargin = 0.15;
  ++num_compared_;
  std::array<double, kNumScanReadings> shares{};
  for (std::size_t i = 0; i < kNumScanReadings; ++i) {
    const auto reading = static_cast<ScanReading>(i);
    if (!is_possible(reading, scan)) continue;
    const Pose2 T = reading == ScanReading::kNotMoved ? Pose2{} : T_before_after;
    shares[i] = explained_share(reference_->scan, scan, T, bearing_factor(reading)).value_or(0.0);
  }
  const auto best = static_cast<std::size_t>(std::ranges::max_element(shares) - shares.begin());
  double rival = 0.0;
  for (std::size_t i = 0; i < kNumScanReadings; ++i) {
    const bool is_rival = are_rivals(static_cast<ScanReading>(i), static_cast<ScanReading>(best));
    if (i != best && is_rival) rival = std::max(rival, shares[i]);
  }
  if (shares[best] >= kLeastExplained && shares[best] - rival >= kClearMargin) ++num_votes_[best];
}

void MotionSurvey::compare_at_rest(const Scan& scan) {
  // People who pass by hide less than half of a scan.
  constexpr double kMostUnchanged = 0.5;
  const auto unchanged = explained_share(reference_->scan, scan, Pose2{}, 1.0);
  if (!unchanged) return;
  ++num_at_rest_;
  num_moved_at_rest_ += *unchanged < kMostUnchanged ? 1 : 0;
}

}  // namespace setsquare
