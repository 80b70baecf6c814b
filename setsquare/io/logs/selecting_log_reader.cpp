// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/selecting_log_reader.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tuple>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/core/median.hpp"

namespace setsquare {
namespace {

constexpr std::size_t kMaxHeadRecords = 4096;

/// Smaller is more nearly the front laser. RAWLASERn repeats another message, without a mounting.
auto front_rank(const std::string& sensor, const Pose2& T_base_sensor) {
  const bool is_raw = sensor.starts_with("RAWLASER");
  const double turn_deg = std::round(std::abs(deg_from_rad(wrap_to_pi(T_base_sensor.theta_rad))));
  return std::tuple(is_raw, turn_deg, sensor);
}

constexpr double kFinestUnit_m = 1e-4;
constexpr double kFinestUnit_rad = 1e-6;

double settle(double value, double rounding, double finest_unit) {
  if (rounding <= 0.0) return value;
  const double unit = std::max(rounding, finest_unit);
  if (std::abs(value) <= 1.5 * unit) return 0.0;
  return std::round(value / unit) * unit;
}

/// The one mounting behind many: each is a difference of two rounded poses, so each is off by up to
/// the rounding. Per coordinate: the median, rounded to the log's own unit, and zero where it is
/// within the rounding. `rounding` in m and rad; 0 where the mountings are exact.
Pose2 settle_mounting(std::vector<Pose2> mountings, double rounding) {
  if (mountings.empty()) return {};
  std::vector<double> x_m;
  std::vector<double> y_m;
  std::vector<double> turn_rad;  // from the first: no wrapping between values around pi
  const double reference_rad = mountings.front().theta_rad;
  for (const Pose2& mounting : mountings) {
    x_m.push_back(mounting.x_m);
    y_m.push_back(mounting.y_m);
    turn_rad.push_back(wrap_to_pi(mounting.theta_rad - reference_rad));
  }
  const double heading_rad = wrap_to_pi(reference_rad + upper_median(std::move(turn_rad)));
  return {settle(upper_median(std::move(x_m)), rounding, kFinestUnit_m),
          settle(upper_median(std::move(y_m)), rounding, kFinestUnit_m),
          settle(heading_rad, rounding, kFinestUnit_rad)};
}

/// Whether mountings differ by more than rounding explains (5 cm or 2 degrees beyond it): then the
/// log's laser poses are not the robot's plus a mounting, but for instance corrected poses.
bool is_mounting_varying(const Pose2& settled, const Pose2& measured, double rounding) {
  constexpr double kMaxDistance_m = 0.05;
  constexpr double kMaxTurn_rad = 0.035;
  const double slack = 3.0 * rounding;
  return std::hypot(measured.x_m - settled.x_m, measured.y_m - settled.y_m) >
             kMaxDistance_m + slack ||
         std::abs(wrap_to_pi(measured.theta_rad - settled.theta_rad)) > kMaxTurn_rad + slack;
}

/// Sensors are on the robot. The largest robots that carry scanners are lorries and cranes.
constexpr double kLargestRobot_m = 20.0;

bool is_on_robot(const Pose2& T_base_sensor) {
  return std::hypot(T_base_sensor.x_m, T_base_sensor.y_m) < kLargestRobot_m;  // false for NaN
}

/// The larger of the way and the turn from a pose to another, in m and rad.
double motion_between(const Pose2& a, const Pose2& b) {
  return std::max(std::hypot(a.x_m - b.x_m, a.y_m - b.y_m),
                  std::abs(wrap_to_pi(a.theta_rad - b.theta_rad)));
}

/// What a laser pose that never changes says of the mounting: the difference of the first poses
/// where both began at the same place, else itself where a converter wrote the mounting.
Pose2 mounting_of_constant_pose(const Pose2& T_odom_base, const Pose2& T_odom_sensor) {
  constexpr double kUsualReach_m = 1.0;
  const auto is_near = [](const Pose2& pose) {
    return std::hypot(pose.x_m, pose.y_m) < kUsualReach_m;
  };
  const Pose2 T_base_sensor = T_odom_base.inverse() * T_odom_sensor;
  if (is_near(T_base_sensor)) return T_base_sensor;
  return is_near(T_odom_sensor) ? T_odom_sensor : Pose2{};
}

/// The ranges as the options say that they are meant.
void apply_options(const LogOptions& options, Scan& scan) {
  constexpr double kHalfUnit_m = 0.0005;
  constexpr double kShortestReach_m = 1.0;
  if (options.range_scale != 1.0) {
    for (double& range : scan.ranges_m) range *= options.range_scale;
    if (scan.max_range_m * options.range_scale >= kShortestReach_m) {
      scan.max_range_m *= options.range_scale;
      scan.min_range_m *= options.range_scale;
    }
  }
  for (const double ignored_m : options.ignored_ranges_m) {
    for (double& range_m : scan.ranges_m) {
      if (std::abs(range_m - ignored_m) <= kHalfUnit_m) range_m = 0.0;
    }
  }
  if (options.mirrors_scans) {
    scan.first_bearing_rad = -scan.first_bearing_rad;
    scan.bearing_step_rad = -scan.bearing_step_rad;
  }
  if (options.max_range_m) scan.max_range_m = *options.max_range_m;
  if (options.sweep_time_s && scan.num_beams() > 1) {
    scan.time_increment_s = *options.sweep_time_s / static_cast<double>(scan.num_beams() - 1);
  }
}

}  // namespace

SelectingLogReader::SelectingLogReader(std::unique_ptr<RecordStream> stream,
                                       std::string name,
                                       const LogOptions& options,
                                       std::size_t num_head_scans)
    : stream_(std::move(stream)),
      name_(std::move(name)),
      options_(options),
      num_head_scans_(num_head_scans) {
  if (options_.sensor.empty() || options_.sensor == "all") return;
  std::istringstream names(options_.sensor);
  for (std::string sensor; std::getline(names, sensor, ',');) wanted_.insert(sensor);
}

void SelectingLogReader::read_head() {
  is_head_read_ = true;
  std::map<std::string, std::vector<Pose2>> measured;
  std::map<std::string, double> rounding;
  std::size_t num_scans = 0;
  LogRecord record;
  while (num_scans < num_head_scans_ && head_.size() < kMaxHeadRecords && stream_->read(record)) {
    if (record.kind == RecordKind::kScan) {
      ++num_scans;
      measured[record.sensor].push_back(record.scan.T_base_sensor);
      rounding[record.sensor] = stream_->mounting_rounding();
    }
    head_.push_back(record);
  }
  for (LogRecord& early : head_) {
    const bool is_before_first_motion = stream_->is_odometry_summed() && !early.T_odom_base;
    if (is_before_first_motion) early.T_odom_base = Pose2{};
  }
  settle_mountings(measured, rounding);
  for (const LogRecord& early : head_) {
    if (early.kind == RecordKind::kScan) watch_laser_pose(mountings_.at(early.sensor), early);
  }
  for (const auto& [sensor, mounting] : mountings_) {
    const bool is_first = front_sensor_.empty();
    if (is_first || front_rank(sensor, mounting.T_base_sensor) <
                        front_rank(front_sensor_, mountings_.at(front_sensor_).T_base_sensor)) {
      front_sensor_ = sensor;
    }
  }
}

void SelectingLogReader::settle_mountings(const std::map<std::string, std::vector<Pose2>>& measured,
                                          const std::map<std::string, double>& rounding) {
  for (const auto& [sensor, poses] : measured) {
    Mounting mounting;
    mounting.rounding = rounding.at(sensor);
    const auto given = options_.mountings.find(sensor);
    mounting.T_base_sensor = given != options_.mountings.end()
                                 ? given->second
                                 : settle_mounting(poses, mounting.rounding);
    if (given == options_.mountings.end()) check_distance(sensor, mounting);
    mountings_.emplace(sensor, mounting);
  }
}

bool SelectingLogReader::is_laser_standing(const Mounting& mounting, const LogRecord& record) {
  constexpr double kStanding = 0.001;  // m or rad
  if (!mounting.T_odom_base || !record.T_odom_base) return false;
  const Pose2 T_odom_sensor = *record.T_odom_base * record.scan.T_base_sensor;
  return motion_between(mounting.T_odom_sensor, T_odom_sensor) <= kStanding;
}

void SelectingLogReader::watch_laser_pose(Mounting& mounting, const LogRecord& record) {
  constexpr double kMoved = 0.2;  // m or rad
  if (!record.T_odom_base || mounting.rounding == 0.0 || mounting.is_judged) return;
  const Pose2 T_odom_sensor = *record.T_odom_base * record.scan.T_base_sensor;
  if (!mounting.T_odom_base) {
    mounting.T_odom_base = record.T_odom_base;
    mounting.T_odom_sensor = T_odom_sensor;
  }
  if (motion_between(*mounting.T_odom_base, *record.T_odom_base) < kMoved) return;
  mounting.is_judged = true;
  if (!is_laser_standing(mounting, record)) return;
  mounting.is_of_constant_pose = true;
  mounting.T_base_sensor = mounting_of_constant_pose(*mounting.T_odom_base, T_odom_sensor);
  stream_->problems().remarks.push_back(fmt::format(
      "{}: the laser's pose stays the same while the robot's changes (record {}); taken "
      "as mounted at x {:.3f} m, y {:.3f} m",
      record.sensor,
      record.position,
      mounting.T_base_sensor.x_m,
      mounting.T_base_sensor.y_m));
}

void SelectingLogReader::check_distance(const std::string& sensor, Mounting& mounting) {
  if (is_on_robot(mounting.T_base_sensor)) return;
  stream_->problems().remarks.push_back(fmt::format(
      "{}: the laser's pose is {:.3g} m from the robot's, on no robot; taken as mounted "
      "at the robot's centre",
      sensor,
      std::hypot(mounting.T_base_sensor.x_m, mounting.T_base_sensor.y_m)));
  mounting.T_base_sensor = {};
  mounting.is_varying = true;  // remarked
}

bool SelectingLogReader::is_wanted(const LogRecord& record) const {
  if (record.kind == RecordKind::kTurnRate && options_.turn_rates) return true;
  if (record.kind != RecordKind::kScan) return !options_.scans_only;
  if (options_.sensor == "all") return true;
  return wanted_.empty() ? record.sensor == front_sensor_ : wanted_.contains(record.sensor);
}

void SelectingLogReader::remark_varying(Mounting& mounting, const LogRecord& record) {
  mounting.is_varying = true;
  stream_->problems().remarks.push_back(
      fmt::format("{}: the laser's pose on the robot is not constant (record {}); the one from the "
                  "log's beginning is used",
                  record.sensor,
                  record.position));
}

void SelectingLogReader::apply_mounting(LogRecord& record) {
  Pose2& T_base_sensor = record.scan.T_base_sensor;
  const auto given = options_.mountings.find(record.sensor);
  if (given != options_.mountings.end()) {
    T_base_sensor = given->second;
    return;
  }
  const auto found = mountings_.find(record.sensor);
  if (found == mountings_.end()) {
    const double rounding = stream_->mounting_rounding();
    T_base_sensor = settle_mounting({T_base_sensor}, rounding);
    Mounting mounting{T_base_sensor, rounding, false};
    check_distance(record.sensor, mounting);
    T_base_sensor = mounting.T_base_sensor;
    mountings_.emplace(record.sensor, mounting);
    return;
  }
  Mounting& mounting = found->second;
  if (mounting.rounding == 0.0) {
    if (!is_on_robot(T_base_sensor)) T_base_sensor = mounting.T_base_sensor;
    return;
  }
  watch_laser_pose(mounting, record);
  if (!mounting.is_varying && !is_laser_standing(mounting, record) &&
      is_mounting_varying(mounting.T_base_sensor, T_base_sensor, mounting.rounding)) {
    remark_varying(mounting, record);
  }
  T_base_sensor = mounting.T_base_sensor;
}

void SelectingLogReader::number_scanner(LogRecord& record) {
  const auto next = static_cast<std::uint32_t>(numbers_.size());
  record.scan.scanner = numbers_.try_emplace(record.sensor, next).first->second;
}

const LogRecord* SelectingLogReader::finish() {
  const std::string damage_of_bytes = stream_->damage();
  if (!is_end_reported_ && !damage_of_bytes.empty()) {
    stream_->problems().remarks.push_back(damage_of_bytes + "; the log was read up to there");
  }
  is_end_reported_ = true;
  const bool is_one_wanted = !options_.sensor.empty() && options_.sensor != "all";
  if (num_scans_handed_on_ > 0) return nullptr;
  std::string reason =
      is_one_wanted ? "no scan of sensor " + options_.sensor : std::string("no scan in this log");
  if (is_one_wanted && !mountings_.empty()) {
    reason += "; it has";
    for (const auto& entry : mountings_) {
      reason += " " + (entry.first.empty() ? std::string("(unnamed)") : entry.first);
    }
  }
  if (!stream_->overview().empty() && !is_one_wanted) {
    reason = "no topic with scans in this recording; setsquare info lists its topics";
  }
  const std::string damage = summary(stream_->problems());
  throw FormatError(name_, "", damage.empty() ? reason : reason + " (" + damage + ")");
}

const LogRecord* SelectingLogReader::next() {
  if (!is_head_read_) read_head();
  for (;;) {
    if (!head_.empty()) {
      std::swap(current_, head_.front());
      head_.pop_front();
    } else if (!stream_->read(current_)) {
      return finish();
    }
    const bool is_scan = current_.kind == RecordKind::kScan;
    if (is_scan && front_sensor_.empty()) front_sensor_ = current_.sensor;
    if (is_scan) apply_mounting(current_);
    if (!is_wanted(current_)) continue;
    if (is_scan) {
      ++num_scans_handed_on_;
      number_scanner(current_);
      apply_options(options_, current_.scan);
    }
    return &current_;
  }
}

}  // namespace setsquare
