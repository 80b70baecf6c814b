// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/pipeline/run_sentences.hpp"

#include <fmt/core.h>

#include <cmath>

#include "setsquare/core/angle.hpp"

namespace setsquare {
namespace {

std::string text_of(const Pose2& mounting) {
  return fmt::format(
      "{:.3f},{:.3f},{:.2f}", mounting.x_m, mounting.y_m, deg_from_rad(mounting.theta_rad));
}

/// How far the mounting that was seen is off the stated one.
std::string text_of_difference(const MappedScanner& scanner) {
  const Pose2 off = scanner.T_base_sensor.inverse() * scanner.T_base_seen;
  std::string text = fmt::format("turned by {:.1f} +- {:.1f} deg",
                                 deg_from_rad(off.theta_rad),
                                 deg_from_rad(scanner.sigma_rad));
  if (std::isfinite(scanner.sigma_m)) {
    text += fmt::format(
        " and moved by {:.2f} +- {:.2f} m", std::hypot(off.x_m, off.y_m), scanner.sigma_m);
  }
  return text + " against its stated mounting";
}

std::string sentence_on(const MappedScanner& scanner,
                        const std::string& name,
                        const std::string& reference) {
  switch (scanner.verdict) {
    case MountingVerdict::kReference:
      return fmt::format("sensor {}: leads; {} scans mapped", name, scanner.num_mapped);
    case MountingVerdict::kConfirmed:
      return fmt::format("sensor {}: its mounting fits what {} saw ({}); {} of its {} scans mapped",
                         name,
                         reference,
                         text_of_difference(scanner),
                         scanner.num_mapped,
                         scanner.num_scans);
    case MountingVerdict::kRefuted:
      return fmt::format(
          "sensor {} is {}, by what {} saw; --mounting {}={} would mend it; its {} scans are left "
          "out",
          name,
          text_of_difference(scanner),
          reference,
          name,
          text_of(scanner.T_base_seen),
          scanner.num_scans);
    case MountingVerdict::kUnfit:
      return fmt::format(
          "sensor {}: most of its scans fit nowhere in what {} saw; its {} scans are "
          "left out",
          name,
          reference,
          scanner.num_scans);
    case MountingVerdict::kOpen:
      return fmt::format(
          "sensor {}: too few of its scans could be compared with what {} saw; its {} "
          "scans are left out",
          name,
          reference,
          scanner.num_scans);
  }
  return {};
}

/// What became of odometry.
std::string text_of_verdict(const OdometryReport& odometry) {
  switch (odometry.verdict) {
    case OdometryVerdict::kOpen:
      return "not compared with the scans, which did not show enough motion";
    case OdometryVerdict::kBelieved:
      return fmt::format("moves as the scans do (ways by {:.2f}, turns by {:.2f})",
                         odometry.way.scale,
                         odometry.turn.scale);
    case OdometryVerdict::kScaled:
      return fmt::format(
          "its ways are multiplied by {:.3g}, its turns by {:.3g}, as the scans show",
          odometry.way.scale,
          odometry.turn.scale);
    case OdometryVerdict::kStill:
      return "ignored, it does not move while the scans do";
    case OdometryVerdict::kMirrored:
      return "ignored, it turns against the scans: is the scanner mounted upside down? "
             "(--mirror-scans)";
    case OdometryVerdict::kUnlike:
      return "ignored, it does not move as the scans show";
  }
  return {};
}

}  // namespace

std::vector<std::string> sentences_on(const std::vector<MappedScanner>& scanners,
                                      const std::map<std::uint32_t, std::string>& names) {
  std::vector<std::string> sentences;
  if (scanners.size() < 2) return sentences;
  const std::string& reference = names.at(scanners.front().scanner);
  for (const MappedScanner& scanner : scanners) {
    sentences.push_back(sentence_on(scanner, names.at(scanner.scanner), reference));
  }
  return sentences;
}

std::string sentence_on(const GyroReport& gyro) {
  constexpr auto kOtherWay =
      "it turns the other way: it or the scanner is mounted upside down (--mirror-scans)";
  const std::string offset = gyro.scans_late_s == 0.0
                                 ? ""
                                 : fmt::format("; the scans are stamped about {:.2f} s too {}",
                                               std::abs(gyro.scans_late_s),
                                               gyro.scans_late_s > 0.0 ? "late" : "early");
  switch (gyro.verdict) {
    case GyroVerdict::kOpen:
      return "gyro: not used, the robot did not turn enough to judge it";
    case GyroVerdict::kBelieved:
      return fmt::format("gyro: turns as the scans do (scale {:.3f}, bias {:.2f} deg/s)",
                         gyro.scale,
                         deg_from_rad(gyro.bias_rad_per_s));
    case GyroVerdict::kMirrored:
      return fmt::format("gyro: ignored, {}{}", kOtherWay, offset);
    case GyroVerdict::kDegrees:
      return fmt::format("gyro: ignored, its rates are degrees per second{}{}{}",
                         gyro.scale < 0.0 ? ", and " : "",
                         gyro.scale < 0.0 ? kOtherWay : "",
                         offset);
    case GyroVerdict::kOffTime:
      return fmt::format("gyro: ignored, it turns as the scans do, but at other times{}", offset);
    case GyroVerdict::kUnlike:
      return "gyro: ignored, it does not turn as the scans show";
  }
  return {};
}

std::string sentence_on(const OdometryReport& odometry) {
  std::string text = "odometry: " + text_of_verdict(odometry);
  const bool is_ignored_at_end = odometry.verdict == OdometryVerdict::kStill ||
                                 odometry.verdict == OdometryVerdict::kMirrored ||
                                 odometry.verdict == OdometryVerdict::kUnlike;
  if (odometry.num_ignored > 0) {
    text += fmt::format(
        "{} {} scans", is_ignored_at_end ? ", in" : "; ignored in", odometry.num_ignored);
  }
  if (odometry.num_jumps > 0) {
    text += fmt::format(", {} of them after a step that no robot makes", odometry.num_jumps);
  }
  if (odometry.num_carried > 0) {
    text +=
        fmt::format("; {} the scans changed while the wheels stood still: was the robot carried?",
                    odometry.num_carried == 1 ? std::string("once")
                                              : fmt::format("{} times", odometry.num_carried));
  }
  return text;
}

std::string reason_apart(const SessionSearch& search) {
  constexpr std::size_t kFewest = 3;  // PieceJoiningParams::min_agreeing
  if (search.num_pairs == 0) return "its way is too short to be looked for";
  if (search.num_matched == 0) {
    return fmt::format("no place of it was found again: of {} pairs of places none match",
                       search.num_pairs);
  }
  const std::string found =
      fmt::format("of {} pairs of places {} match, and {} {} on where it lies",
                  search.num_pairs,
                  search.num_matched,
                  search.num_agreeing,
                  search.num_agreeing == 1 ? "place agrees" : "places agree");
  return found + (search.num_agreeing < kFewest
                      ? ": too few"
                      : ": not enough to tell them from places that look alike");
}

std::vector<std::string> sentences_on_sessions(const Map& map) {
  std::vector<std::string> sentences;
  for (std::size_t s = 1; s < map.sessions.size(); ++s) {
    const MapSession& session = map.sessions[s];
    const std::string name =
        fmt::format("session {} of {}, {} scans", s + 1, map.sessions.size(), session.num_scans);
    sentences.push_back(is_joined(map, session)
                            ? fmt::format("{}: joined to the map; {} places agree on where it lies",
                                          name,
                                          session.search.num_agreeing)
                            : fmt::format("{}: kept apart until it can be joined: {}",
                                          name,
                                          reason_apart(session.search)));
  }
  return sentences;
}

std::vector<std::string> sentences_on_forgotten(const MapSummary& summary) {
  std::vector<std::string> sentences;
  if (summary.num_forgotten > 0) {
    sentences.push_back(fmt::format(
        "forgotten: {} keyframes of places that were covered before, and showed nothing new",
        summary.num_forgotten));
  }
  if (summary.num_forgotten_poses > 0) {
    sentences.push_back(
        fmt::format("forgotten: the poses of {} scans there, the oldest; the {} scans of the map "
                    "have theirs",
                    summary.num_forgotten_poses,
                    summary.num_scans));
  }
  return sentences;
}

std::string sentence_on(const SweepReport& sweep) {
  const std::string length = fmt::format("{:.3f} s from a scan's {} beam to its {}",
                                         std::abs(sweep.sweep_s),
                                         sweep.sweep_s < 0.0 ? "last" : "first",
                                         sweep.sweep_s < 0.0 ? "first" : "last");
  const bool is_stated = sweep.stated_s != 0.0;
  switch (sweep.verdict) {
    case SweepVerdict::kUnknown:
      return is_stated ? "sweep: what the log states was not confirmed, for the robot hardly "
                         "turned; scans are not deskewed"
                       : "";
    case SweepVerdict::kStated:
      return fmt::format("sweep: {}, as stated; scans are deskewed", length);
    case SweepVerdict::kFound:
      return fmt::format("sweep: {}, found by the walls in {} scans of turns{}; scans are deskewed",
                         length,
                         sweep.num_turns,
                         is_stated ? ", against what the log states" : "");
    case SweepVerdict::kAtOnce:
      return fmt::format("sweep: the walls show no skew in {} scans of turns{}",
                         sweep.num_turns,
                         is_stated ? ", against what the log states" : "");
  }
  return {};
}

}  // namespace setsquare
