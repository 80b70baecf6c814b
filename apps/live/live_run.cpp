// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/live/live_run.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "apps/live/said_poses.hpp"
#include "apps/setsquare/audit/verdict_text.hpp"
#include "apps/setsquare/give_back_memory.hpp"
#include "apps/setsquare/localize/outputs.hpp"
#include "apps/setsquare/outputs/inputs.hpp"
#include "apps/setsquare/scans/log_options.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/core/joined.hpp"
#include "setsquare/core/save_file.hpp"
#include "setsquare/io/logs/bag/live_log.hpp"
#include "setsquare/io/logs/open_log.hpp"
#include "setsquare/io/map_file/map_file.hpp"
#include "setsquare/live/paced_log.hpp"
#include "setsquare/live/resumed_messages.hpp"
#include "setsquare/map/map_summary.hpp"
#include "setsquare/pipeline/run_sentences.hpp"
#include "setsquare/report/map/save_map.hpp"

namespace setsquare::live_app {
namespace {

/// Nodes of the root namespace may be named without its slash.
void make_absolute(std::string& topic) {
  if (!topic.empty() && !topic.starts_with('/')) topic.insert(0, "/");
}

/// Of a run that localises: nobody asks for poses that are not written.
std::size_t num_poses_to_keep(const LiveOptions& options) {
  if (options.output_path.empty()) return 0;
  const std::size_t num = options.live.max_known_poses;
  return num > 0 ? num : std::numeric_limits<std::size_t>::max();
}

}  // namespace

LiveRun::LiveRun(const LiveOptions& options, StopSignal& stop) : options_(options), stop_(stop) {
  options_.mapping.log.scans_only = false;  // The odometry is surveyed, turn rates are used.
  if (options_.is_of_network()) {
    open_network();
  } else {
    open_replayed_log();
  }
  if (options_.is_shown) {
    server_ = std::make_unique<foxglove::Server>(options_.server);
    viewers_ = std::make_unique<FoxgloveOutput>(*server_, options_.ros2.frames);
    outputs_.push_back(viewers_.get());
    std::cout << fmt::format(
                     "shown to Foxglove at ws://{}:{}", options_.server.address, server_->port())
              << std::endl;
  }
  make_session();
  if (options_.is_viewed) make_view();
  if (is_live_ && session_->last_map()) show_map(session_->last_map());
  if (!options_.is_ros2) return;
  node_ = std::make_unique<Ros2Node>(options_.ros2, *queue_);
  node_->serve(*session_, [this](const std::string& name) { return save_now(name); });
  outputs_.push_back(node_.get());
}

LiveRun::~LiveRun() { end_shows(); }

// --- Where scans come from -----------------------------------------------------------------------

void LiveRun::open_replayed_log() {
  name_ = options_.replayed_log;
  auto log = std::make_unique<PacedLog>(
      open_log(name_, options_.mapping.log), options_.speed, [this](Clock::time_point moment) {
        return stop_.wait_until(moment);
      });
  arrival_ = [paced = log.get()] { return paced->due(); };
  log_ = std::move(log);
  is_live_ = true;
}

void LiveRun::open_network() {
  for (std::string& topic : options_.ros2.scan_topics) make_absolute(topic);
  make_absolute(options_.ros2.odometry_topic);
  options_.mapping.log.sensor = joined(options_.ros2.scan_topics, ",");
  name_ = options_.is_ros2 ? "ROS 2" : options_.bridge;
  auto queue = std::make_unique<MessageQueue>(options_.is_ros2 ? "ROS 2" : "Foxglove WebSocket");
  queue_ = queue.get();
  stop_.on_stop([to = queue_] { to->close(); });
  arrival_ = [from = queue_] { return from->arrival(); };
  std::vector<std::string> kept;
  if (!options_.state_path.empty()) {
    kept = Journal::files_of(options_.state_path);
    journal_ = std::make_unique<Journal>(
        options_.state_path,
        [](const std::string& reason) {
          std::cerr << "what comes is not kept: " << reason << std::endl;
        },
        options_.state_period_s);
    queue->on_read([this](const MessageTopic& topic, const Message& message) {
      journal_->add(topic, message);
    });
    if (!kept.empty()) {
      std::cout << fmt::format(
                       "reading what was kept: {} files of {}", kept.size(), options_.state_path)
                << std::endl;
    }
  }
  log_ = open_live_log(std::make_unique<ResumedMessages>(
                           std::move(kept), std::move(queue), [this] { begin_live(); }),
                       name_,
                       options_.mapping.log);
}

void LiveRun::begin_live() {
  is_live_ = true;
  if (node_) {
    node_->listen();
  } else {
    bridge_ = std::make_unique<foxglove::Client>(options_.bridge, bridge_calls());
  }
  if (const LiveMapPtr map = session_->last_map()) show_map(map);
  std::cout << "waiting for scans on " << options_.mapping.log.sensor << std::endl;
}

foxglove::Client::Calls LiveRun::bridge_calls() {
  constexpr auto kSaidPose = std::numeric_limits<std::size_t>::max();
  std::map<std::pair<std::string, std::string>, std::size_t> wanted;  // by topic and type
  wanted[{kSaidPoseTopic, kSaidPoseType}] = kSaidPose;
  said_poses_ = std::make_shared<SaidPoses>(*session_, options_.ros2.frames.map);
  for (const auto& [topic, type] : topics_of(options_.ros2)) {
    wanted[{topic, type}] = queue_->add(
        {.name = topic, .type = type, .definition = {}, .encoding = MessageEncoding::kCdr});
  }
  return {.on_channel = [wanted = std::move(wanted)](
                            const foxglove::Channel& channel) -> std::optional<std::size_t> {
            const auto found = wanted.find({channel.topic, channel.schema_name});
            if (found == wanted.end() || channel.encoding != "cdr") return std::nullopt;
            return found->second;
          },
          .on_message =
              [to = queue_, poses = said_poses_](std::size_t number, std::string_view data) {
                if (number == kSaidPose) {
                  poses->take(data);
                } else {
                  to->push(number, world_time(), data);
                }
              },
          .on_state = [](const std::string& state) { std::cerr << state << std::endl; }};
}

// --- The session, and who is shown ---------------------------------------------------------------

void LiveRun::make_session() {
  if (!options_.known_map.empty()) {
    LocalizingSession::Options options{
        .localising = {.log = options_.mapping.log,
                       .uses_odometry = options_.mapping.uses_odometry,
                       .T_map_base_start = {},
                       .localisation = {}},
        .way_period_s = options_.live.map_period_s,
        .max_poses = num_poses_to_keep(options_),
        .behind = {.waits = !options_.is_of_network() && options_.speed == 0.0}};
    if (!options_.start.empty()) {
      options.localising.T_map_base_start =
          Pose2{options_.start[0], options_.start[1], wrap_to_pi(rad_from_deg(options_.start[2]))};
    }
    localising_ = std::make_unique<LocalizingSession>(
        name_, read_map_to_localise_in(options_.known_map), options, watcher());
    session_ = localising_.get();
    return;
  }
  if (!options_.continued_map.empty()) {
    const auto known = std::make_shared<const SavedMap>(load_map_file(options_.continued_map));
    options_.mapping.known_map = {known, &known->map};
    options_.mapping.known_map_name = options_.continued_map;
    refuse_known_map(options_.output_path);
  }
  mapping_ = std::make_unique<MappingSession>(name_, options_.mapping, options_.live, watcher());
  session_ = mapping_.get();
}

void LiveRun::make_view() {
  const bool is_taken = options_.is_shown && options_.view.port == server_->port();
  if (is_taken) ++options_.view.port;  // By Foxglove.
  const bool can_save = mapping_ && !options_.output_path.empty();
  view_ = std::make_unique<ViewOutput>(
      options_.view, *session_, can_save, [this](const std::string& name) {
        return save_now(name);
      });
  outputs_.push_back(view_.get());
  std::cout << fmt::format("shown at http://{}:{}", options_.view.address, view_->port())
            << std::endl;
}

LiveWatcher LiveRun::watcher() {
  return {
      .on_pose = [this](const LogRecord& record, const LivePose& pose) { show_pose(record, pose); },
      .on_map =
          [this](const LiveMapPtr& map) {
            show_map(map);
            show_way(way_of(map->map));
          },
      .on_way = [this](const Trajectory& way) { show_way(way); },
      .on_refused =
          [](const LogRecord& record, const std::string& reason) {
            std::cerr << record.sensor << ": " << reason << "\n";
          },
      .on_reset =
          [this] {
            if (journal_) journal_->clear();
          }};
}

void LiveRun::show_pose(const LogRecord& record, const LivePose& pose) {
  if (!is_live_) return;
  for (LiveOutput* output : outputs_) output->show_pose(record, pose);
  latencies_.add(std::chrono::duration<double>(Clock::now() - arrival_()).count());
}

void LiveRun::show_map(const LiveMapPtr& map) {
  app::give_back_memory();  // What making it took.
  const std::lock_guard lock(outputs_mutex_);
  if (!is_live_) return;
  for (LiveOutput* output : outputs_) output->show_map(map);
}

void LiveRun::show_way(const Trajectory& way) {
  const std::lock_guard lock(outputs_mutex_);
  if (!is_live_) return;
  for (LiveOutput* output : outputs_) output->show_way(way);
}

/// Behind it nobody is shown anything, whatever is still drawn; nobody asks the session any more.
void LiveRun::end_shows() {
  {
    const std::lock_guard lock(outputs_mutex_);
    outputs_.clear();
  }
  if (node_) {
    input_faults_ = node_->faults_of_input();
  } else if (bridge_) {
    input_faults_ = faults_of(*queue_);
    if (said_poses_->num_refused() > 0) {
      input_faults_.push_back(
          fmt::format("{}: {} messages left out", kSaidPoseTopic, said_poses_->num_refused()));
    }
  }
  bridge_.reset();
  node_.reset();
  view_.reset();
}

// --- What was found ------------------------------------------------------------------------------

void LiveRun::run() {
  if (localising_) {
    localize();
  } else {
    map();
  }
}

void LiveRun::map() {
  const MappedLog mapped = mapping_->run(*log_);
  end_shows();
  app::give_back_memory();
  tell(mapped);
  if (!options_.output_path.empty()) {
    std::cout << save(mapped, options_.output_path) << "\n";
  }
  app::tell_problems(mapped.name, mapped.problems);
}

void LiveRun::localize() {
  const LocalizedLog log = localising_->run(*log_);
  end_shows();
  tell_localised();
  if (log.left_out.num_scans() > 0 && !options_.output_path.empty()) {
    std::cout << fmt::format("forgotten: the poses of {} scans, the oldest; {} have theirs\n",
                             log.left_out.num_scans(),
                             log.poses.size());
  }
  if (!options_.output_path.empty()) std::cout << save(log, options_.output_path) << "\n";
  app::tell_problems(log.name, log.problems);
}

void LiveRun::refuse_known_map(const std::filesystem::path& folder) const {
  if (options_.continued_map.empty() || folder.empty()) return;
  app::refuse_input(map_file_at(folder.string()), {map_file_at(options_.continued_map)});
}

std::string LiveRun::save(const MappedLog& mapped, const std::filesystem::path& folder) const {
  refuse_known_map(folder);
  const std::vector<std::string> names = save_map(mapped.map, folder, save_options_of(mapped));
  return fmt::format("written: {}/{}", folder.string(), joined(names));
}

std::string LiveRun::save(const LocalizedLog& log, const std::filesystem::path& folder) const {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw FileError(folder.string(), "cannot be made: " + error.message());
  const std::vector<app::NamedBytes> outputs =
      app::localize_outputs(log, localising_->last_map()->grid, options_.known_map, PoseOf::kBase);
  std::vector<FileBytes> files;
  std::vector<std::string> names;
  for (const auto& [file, bytes] : outputs) {
    files.push_back({(folder / file).string(), bytes});
    names.push_back(file);
  }
  save_files(files);
  return fmt::format("written: {}/{}", folder.string(), joined(names));
}

std::string LiveRun::save_now(const std::string& name) {
  if (!mapping_) throw FileError("map", "the robot is localised in it: it does not change");
  if (options_.output_path.empty()) throw FileError("-o", "not given: there is no place for maps");
  if (name.find('/') != std::string::npos || name == "." || name == "..") {
    throw FileError(name, "a map's name has no '/': it is saved below the folder of -o");
  }
  const LiveMapPtr map = mapping_->request_map().get();
  if (!map) throw FileError("map", "there is none yet");
  const std::filesystem::path folder(options_.output_path);
  return save(mapping_->mapped_log_of(*map), name.empty() ? folder : folder / name);
}

void LiveRun::tell(const MappedLog& mapped) const {
  const LiveCounts counts = mapping_->counts();
  std::cout << app::verdict_text(mapped.map)
            << fmt::format(
                   "{} scans, {} lost; {} maps drawn on the way; all tracked again {} times\n",
                   counts.num_scans,
                   counts.num_lost,
                   counts.num_maps,
                   counts.num_again);
  for (const std::string& sentence : sentences_on_sessions(mapped.map)) {
    std::cout << sentence << "\n";
  }
  for (const std::string& sentence : sentences_on_forgotten(summary_of(mapped.map))) {
    std::cout << sentence << "\n";
  }
  tell_input();
}

void LiveRun::tell_localised() const {
  const LocalisationCounts counts = localising_->counts();
  std::cout << fmt::format("{} scans: localised {}, ambiguous {}, lost {}\n",
                           counts.num_localised + counts.num_ambiguous + counts.num_lost,
                           counts.num_localised,
                           counts.num_ambiguous,
                           counts.num_lost);
  tell_input();
}

void LiveRun::tell_input() const {
  if (latencies_.num() > 0) std::cout << "poses: " << latencies_.text() << " after the scan\n";
  for (const std::string& fault : input_faults_) std::cout << fault << "\n";
}

}  // namespace setsquare::live_app
