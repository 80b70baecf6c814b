// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/live/mapping_session.hpp"

#include <chrono>
#include <utility>

#include "setsquare/core/error.hpp"

namespace setsquare {

MappingSession::MappingSession(std::string name,
                               const MapLogOptions& options,
                               const LiveMapperParams& params,
                               LiveWatcher watcher)
    : LiveSession(options.uses_odometry, std::move(watcher)),
      name_(std::move(name)),
      options_(options),
      params_(params),
      intake_(options) {
  if (options.preset != Preset::kDefault) {
    throw ParameterError("preset", "live mapping has the default one");
  }
  params_.mapper = mapper_params_of(options);
  params_.known_map = options.known_map;
  told_.name = name_;
  told_.options = options_;
  mapper_ = made_mapper();
}

std::shared_ptr<LiveMapper> MappingSession::made_mapper() const {
  return std::make_shared<LiveMapper>(params_, watcher().on_map);
}

MappedLog MappingSession::run(LogReader& reader) {
  read(reader);
  tell(reader);
  MappedLog mapped;
  {
    const std::lock_guard lock(mutex_);
    mapped = told_;
  }
  mapped.map = finished_map(mapped);
  require_something_mapped(mapped);
  return mapped;
}

/// Where no map can be made of all that came, the last one that could be.
Map MappingSession::finished_map(MappedLog& mapped) {
  const std::shared_ptr<LiveMapper> mapper = this->mapper();
  try {
    return mapper->finish();
  } catch (const Error& error) {
    const LiveMapPtr last = mapper->last_map();
    if (!last) throw;
    mapped.problems.remarks.push_back("the map could not be finished (" +
                                      std::string(error.what()) + "): it is that of the first " +
                                      std::to_string(last->map.scans.size()) + " scans");
    return last->map;
  }
}

LivePose MappingSession::add_scan(const LogRecord& record) {
  return mapper()->add(record.scan, wheels_of(record));
}

void MappingSession::add_turn_rate(const LogRecord& record) {
  mapper()->add_turn_rate(record.stamp, record.turn_rad_per_s.value_or(0.0));
}

void MappingSession::begin_again() {
  std::shared_ptr<LiveMapper> fresh = made_mapper();
  {
    const std::lock_guard lock(mutex_);
    mapper_.swap(fresh);
  }
  intake_ = LogIntake(options_);
}

void MappingSession::after_record(const LogReader& reader) {
  if (must_tell_.exchange(false)) tell(reader);
}

void MappingSession::tell(const LogReader& reader) {
  {
    const std::lock_guard lock(mutex_);
    intake_.tell(reader, told_);
  }
  is_told_.notify_all();
}

std::shared_ptr<LiveMapper> MappingSession::mapper() const {
  const std::lock_guard lock(mutex_);
  return mapper_;
}

LiveReport MappingSession::report() const {
  const LiveCounts counts = this->counts();
  LiveReport report{.task = "mapping",
                    .doing = "mapping",
                    .warnings = {},
                    .values = {{"scans", std::to_string(counts.num_scans)},
                               {"lost", std::to_string(counts.num_lost)},
                               {"maps", std::to_string(counts.num_maps)},
                               {"scans behind the map", std::to_string(counts.num_behind)},
                               {"tracked again", std::to_string(counts.num_again)}}};
  if (!counts.is_placed) report.warnings.emplace_back("the place in the map is not yet found");
  if (counts.num_undrawn > 0) {
    report.warnings.push_back(std::to_string(counts.num_undrawn) +
                              " maps could not be made of what came");
  }
  return report;
}

MappedLog MappingSession::mapped_log_of(const LiveMap& map) {
  constexpr std::chrono::seconds kLongestWait(1);
  std::unique_lock lock(mutex_);
  must_tell_ = true;
  is_told_.wait_for(lock, kLongestWait, [this] { return !must_tell_; });
  MappedLog mapped = told_;
  lock.unlock();
  mapped.map = map.map;
  return mapped;
}

}  // namespace setsquare
