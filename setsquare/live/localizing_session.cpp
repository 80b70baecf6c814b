// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/live/localizing_session.hpp"

#include <fmt/core.h>

#include <iterator>
#include <utility>
#include <vector>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

/// A kilometre or more.
constexpr std::size_t kLongestWay = 10000;

/// As LiveReport has them.
std::vector<LikelyPlace> places_of(const LocalisedPose& place) {
  constexpr double kLeast = 0.01;
  const Pose2 T_sensor_base = place.T_map_sensor.inverse() * place.T_map_base;
  std::vector<LikelyPlace> places;
  if (place.status != LocalisationStatus::kLocalised && place.probability >= kLeast) {
    places.push_back({place.T_map_base, place.probability});
  }
  for (const PossiblePlace& other : place.alternatives) {
    if (other.probability < kLeast) continue;
    places.push_back({other.T_map_sensor * T_sensor_base, other.probability});
  }
  return places;
}

/// Whether a pose that is known to about 1 m may be in a map.
bool is_near(const OccupancyGrid& grid, const Pose2& T_map_base) {
  constexpr double kKnownTo_m = 1.0;
  const Eigen::Array2d p_m = (grid.T_map_grid().inverse() * T_map_base.translation()).array();
  const Eigen::Array2d size_m =
      grid.resolution_m() * Eigen::Array2d(grid.num_columns(), grid.num_rows());
  return (p_m >= -kKnownTo_m).all() && (p_m <= size_m + kKnownTo_m).all();
}

}  // namespace

LocalizingSession::LocalizingSession(std::string name,
                                     MapToLocaliseIn map,
                                     const Options& options,
                                     LiveWatcher watcher)
    : LiveSession(options.localising.uses_odometry, std::move(watcher)),
      name_(std::move(name)),
      options_(options),
      known_map_(std::move(map.known)),
      chosen_(options.localising.log.sensor),
      way_(kLongestWay) {
  if (names_several(options.localising.log.sensor)) {
    throw ParameterError("sensor", "scans of one scanner are localised");
  }
  require_something_to_find(*known_map_);
  map_ =
      std::make_shared<const LiveMap>(LiveMap{.number = 1, .map = {}, .grid = std::move(map.grid)});
  localizer_ = made_localizer();
}

std::shared_ptr<LiveLocalizer> LocalizingSession::made_localizer() {
  const LocalizeLogOptions& localising = options_.localising;
  auto localizer = std::make_shared<LiveLocalizer>(
      known_map_,
      localising.localisation,
      [this](const LocalisedPose& place) { take(place); },
      options_.behind);
  if (localising.T_map_base_start) localizer->set_pose(*localising.T_map_base_start);
  return localizer;
}

std::shared_ptr<LiveLocalizer> LocalizingSession::localizer() const {
  const std::lock_guard lock(mutex_);
  return localizer_;
}

LocalizedLog LocalizingSession::run(LogReader& reader) {
  read(reader);
  localizer()->finish();
  const std::size_t num_left_out = this->num_left_out();
  const std::lock_guard lock(mutex_);
  LocalizedLog log;
  log.poses.assign(std::make_move_iterator(poses_.begin()), std::make_move_iterator(poses_.end()));
  log.left_out = left_out_;
  log.name = name_;
  tell_log(reader, options_.localising, log);
  if (num_left_out > 0) {
    log.problems.remarks.push_back(std::to_string(num_left_out) +
                                   " scans were not searched for: they came faster");
  }
  if (num_scans_ == 0) throw FileError(name_, "has no scan to localise");
  return log;
}

bool LocalizingSession::takes(const LogRecord& record, const LogReader& reader) {
  if (record.kind != RecordKind::kScan || !chosen_.takes(record, reader.front_sensor())) {
    return false;
  }
  if (!scanner_) scanner_ = record.scan.scanner;
  return record.scan.scanner == *scanner_;
}

LivePose LocalizingSession::add_scan(const LogRecord& record) {
  const LivePose pose = localizer()->add(record.scan, wheels_of(record));
  const std::lock_guard lock(mutex_);
  ++num_scans_;
  return pose;
}

/// The old one's thread has placed all that came, and rests, before the new one's begins.
void LocalizingSession::begin_again() {
  const std::shared_ptr<LiveLocalizer> old = localizer();
  old->finish();
  way_ = DrivenWay(kLongestWay);
  options_.localising.T_map_base_start.reset();
  std::shared_ptr<LiveLocalizer> fresh = made_localizer();
  const std::lock_guard lock(mutex_);
  num_left_out_before_ += old->num_left_out();
  localizer_.swap(fresh);
}

void LocalizingSession::take(const LocalisedPose& place) {
  const auto now = std::chrono::steady_clock::now();
  const bool is_localised = place.status == LocalisationStatus::kLocalised;
  if (is_localised && way_.add({place.stamp, place.T_map_base}) && now >= next_way_ &&
      watcher().on_way) {
    watcher().on_way(way_.poses());
    next_way_ = now + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                          std::chrono::duration<double>(options_.way_period_s));
  }
  const std::lock_guard lock(mutex_);
  count(place, counts_);
  poses_.push_back(place);
  if (poses_.size() <= options_.max_poses) return;
  count(poses_.front(), left_out_);
  poses_.pop_front();
}

std::size_t LocalizingSession::num_left_out() const {
  const std::lock_guard lock(mutex_);
  return num_left_out_before_ + localizer_->num_left_out();
}

bool LocalizingSession::set_pose(const Pose2& T_map_base) {
  if (!is_near(map_->grid, T_map_base)) {
    throw ParameterError("T_map_base", "is outside of the map");
  }
  localizer()->set_pose(T_map_base);
  return true;
}

LocalisationCounts LocalizingSession::counts() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

LiveReport LocalizingSession::report() const {
  const std::shared_ptr<LiveLocalizer> localizer = this->localizer();
  const std::optional<LocalisedPose> place = localizer->last_place();
  const LocalisationCounts counts = this->counts();
  LiveReport report{.task = "localisation",
                    .doing = place ? to_string(place->status) : "waiting",
                    .warnings = {},
                    .values = {{"localised", std::to_string(counts.num_localised)},
                               {"ambiguous", std::to_string(counts.num_ambiguous)},
                               {"lost", std::to_string(counts.num_lost)},
                               {"scans behind", std::to_string(localizer->num_behind())}}};
  const std::size_t num_left_out = this->num_left_out();
  report.values.emplace_back("scans left out", std::to_string(num_left_out));
  if (num_left_out > 0) {
    report.warnings.push_back(std::to_string(num_left_out) +
                              " scans were not searched for: they came faster");
  }
  if (!place) return report;
  report.values.emplace_back("status", to_string(place->status));
  report.values.emplace_back("probability", fmt::format("{:.4f}", place->probability));
  report.values.emplace_back("other places", std::to_string(place->alternatives.size()));
  report.values.emplace_back("way since a scan agreed with the map",
                             fmt::format("{:.1f} m", place->unconfirmed_m));
  report.places = places_of(*place);
  if (place->status != LocalisationStatus::kLocalised) {
    report.warnings.emplace_back(to_string(place->status));
  }
  return report;
}

}  // namespace setsquare
