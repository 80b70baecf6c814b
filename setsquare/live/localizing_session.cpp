// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/live/localizing_session.hpp"

#include <fmt/format.h>

#include <utility>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

/// A kilometre or more.
constexpr std::size_t kLongestWay = 10000;

}  // namespace

LocalizingSession::LocalizingSession(std::string name,
                                     OccupancyGrid grid,
                                     const Options& options,
                                     LiveWatcher watcher)
    : LiveSession(options.localising.uses_odometry, std::move(watcher)),
      name_(std::move(name)),
      options_(options),
      known_map_(std::make_shared<const KnownMap>(grid)),
      chosen_(options.localising.log.sensor),
      way_(kLongestWay) {
  if (names_several(options.localising.log.sensor)) {
    throw ParameterError("sensor", "scans of one scanner are localised");
  }
  require_something_to_find(*known_map_);
  map_ = std::make_shared<const LiveMap>(LiveMap{.number = 1, .map = {}, .grid = std::move(grid)});
  localizer_ = made_localizer();
}

std::shared_ptr<LiveLocalizer> LocalizingSession::made_localizer() {
  const LocalizeLogOptions& localising = options_.localising;
  auto localizer = std::make_shared<LiveLocalizer>(
      known_map_, localising.localisation, [this](const LocalisedPose& place) { take(place); });
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
  const std::lock_guard lock(mutex_);
  LocalizedLog log = std::move(log_);
  log.name = name_;
  tell_log(reader, options_.localising, log);
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
  if (options_.keeps_poses) log_.poses.push_back(place);
}

bool LocalizingSession::set_pose(const Pose2& T_map_base) {
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
  if (!place) return report;
  report.values.emplace_back("status", to_string(place->status));
  report.values.emplace_back("probability", fmt::format("{:.4f}", place->probability));
  report.values.emplace_back("other places", std::to_string(place->alternatives.size()));
  report.values.emplace_back("way since a scan agreed with the map",
                             fmt::format("{:.1f} m", place->unconfirmed_m));
  if (place->status != LocalisationStatus::kLocalised) {
    report.warnings.emplace_back(to_string(place->status));
  }
  return report;
}

}  // namespace setsquare
