// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "setsquare/io/logs/faults/checks.hpp"

namespace setsquare {
namespace {

/// The share of the decided comparisons that a reading won; 0 where too few were decided.
double share_of_votes(const MotionSurvey& motion, ScanReading reading) {
  constexpr std::uint64_t kLeastDecided = 5;
  const std::uint64_t num_decided = motion.num_decided();
  if (num_decided < kLeastDecided) return 0.0;
  return static_cast<double>(motion.num_votes(reading)) / static_cast<double>(num_decided);
}

/// Votes for a wrong reading are scattered: a majority of three in five is none by chance.
constexpr double kClearMajority = 0.6;

double share_of_scans(const SensorSurvey& sensor, std::uint64_t count) {
  return static_cast<double>(count) /
         static_cast<double>(std::max<std::uint64_t>(1, sensor.stamps.num_stamps));
}

}  // namespace

std::optional<LogFinding> check_field_of_view(const CheckedLaser& laser) {
  struct Candidate {
    ScanReading reading;
    int degrees;
  };
  constexpr std::array<Candidate, 3> kCandidates = {{{ScanReading::kFieldOf240, 240},
                                                     {ScanReading::kFieldOf270, 270},
                                                     {ScanReading::kFieldOf360, 360}}};
  if (!laser.sensor.has_assumed_bearings) return std::nullopt;
  const MotionSurvey& motion = laser.sensor.motion;
  double share = 0.0;
  for (const Candidate& candidate : kCandidates) share += share_of_votes(motion, candidate.reading);
  if (share < kClearMajority) return std::nullopt;
  const auto likeliest = std::ranges::max_element(kCandidates, {}, [&](const Candidate& candidate) {
    return motion.num_votes(candidate.reading);
  });
  return LogFinding{
      .kind = FindingKind::kFieldOfView,
      .sentence = fmt::format("{}: the log states no angles; 180 degrees are assumed, and {} of {} "
                              "comparisons with the odometry fit more, most of them {} degrees",
                              laser.name,
                              percent(share),
                              motion.num_decided(),
                              likeliest->degrees),
      .share = share,
      .option = fmt::format("--field-of-view {}", likeliest->degrees)};
}

std::optional<LogFinding> check_mirrored(const CheckedLaser& laser) {
  const double share = share_of_votes(laser.sensor.motion, ScanReading::kMirrored);
  if (share < kClearMajority) return std::nullopt;
  return LogFinding{
      .kind = FindingKind::kMirrored,
      .sentence = fmt::format("{}: the scans turn against the odometry in {} of {} comparisons: "
                              "mounted upside down, or beams counted clockwise?",
                              laser.name,
                              percent(share),
                              laser.sensor.motion.num_decided()),
      .share = share,
      .option = "--mirror-scans"};
}

std::optional<LogFinding> check_scans_repeated(const CheckedLaser& laser) {
  const std::uint64_t num_unchanged = laser.sensor.num_unchanged;
  if (num_unchanged == 0) return std::nullopt;
  const double share = share_of_scans(laser.sensor, num_unchanged);
  return LogFinding{
      .kind = FindingKind::kScansRepeated,
      .sentence = fmt::format("{}: {} scans ({}) repeat the one before, range by range; where the "
                              "odometry moves they measure nothing and are not used",
                              laser.name,
                              num_unchanged,
                              percent(share)),
      .share = share};
}

std::optional<LogFinding> check_scans_stand(const CheckedLaser& laser) {
  const double share = share_of_votes(laser.sensor.motion, ScanReading::kNotMoved);
  if (share < kClearMajority) return std::nullopt;
  return LogFinding{
      .kind = FindingKind::kScansStand,
      .sentence = fmt::format("{}: the scans stay as they were in {} of {} comparisons over which "
                              "the odometry moves",
                              laser.name,
                              percent(share),
                              laser.sensor.motion.num_decided()),
      .share = share,
      .option = "--no-odometry"};
}

std::optional<LogFinding> check_odometry_constant(const CheckedLaser& laser) {
  constexpr double kLeastMovedOfAll = 0.1;
  constexpr double kLeastMoved = 0.5;
  constexpr double kLeastAtRest = 0.5;
  constexpr std::uint64_t kLeastCompared = 3;
  const OdometrySurvey& odometry = laser.odometry;
  const MotionSurvey& motion = laser.sensor.motion;
  if (odometry.num_poses < 2 || motion.num_at_rest() == 0) return std::nullopt;
  const double at_rest =
      static_cast<double>(odometry.num_still) / static_cast<double>(odometry.num_poses - 1);
  const double moved =
      static_cast<double>(motion.num_moved_at_rest()) / static_cast<double>(motion.num_at_rest());
  const bool never_moves = at_rest == 1.0 && moved >= kLeastMovedOfAll;
  const bool rarely_moves =
      at_rest >= kLeastAtRest && moved >= kLeastMoved && motion.num_at_rest() >= kLeastCompared;
  if (!never_moves && !rarely_moves) return std::nullopt;
  return LogFinding{
      .kind = FindingKind::kOdometryConstant,
      .sentence = fmt::format("{}: {} of the odometry poses are the same as the one before while "
                              "the scans move: no odometry",
                              laser.name,
                              percent(at_rest)),
      .share = at_rest,
      .option = "--no-odometry"};
}

}  // namespace setsquare
