// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/live/view_output.hpp"

#include <array>
#include <chrono>
#include <exception>
#include <utility>

#include "apps/live/view_messages.hpp"
#include "setsquare/report/page_template.hpp"
#include "setsquare/view/command.hpp"
#include "setsquare/view/page_web.hpp"

namespace setsquare::live_app {
namespace {

std::string view_page() {
  const std::array<PageMark, 2> marks = {{{"@STYLE@", live_style()}, {"@SCRIPT@", live_script()}}};
  return filled_page(live_page(), marks);
}

}  // namespace

ViewOutput::ViewOutput(const view::ServerOptions& options,
                       LiveSession& session,
                       bool can_save,
                       Save save)
    : session_(session),
      can_save_(can_save),
      save_(std::move(save)),
      server_(options, view_page(), [this](const std::string& text) { return carry_out(text); }) {
  teller_ = std::thread([this] { tell_until_end(); });
}

ViewOutput::~ViewOutput() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
  }
  is_ending_told_.notify_all();
  teller_.join();
}

void ViewOutput::show_pose(const LogRecord& record, const LivePose& pose) {
  const std::lock_guard lock(mutex_);
  pose_ = pose;
  scan_ = record.scan;
  has_new_pose_ = true;
}

void ViewOutput::show_map(const LiveMapPtr& map) {
  const std::lock_guard lock(mutex_);
  map_ = map;
}

void ViewOutput::show_way(const Trajectory& way) {
  const std::lock_guard lock(mutex_);
  way_ = way;
}

void ViewOutput::tell_until_end() {
  constexpr std::chrono::milliseconds kPeriod(100);  // More than eyes can follow is not sent.
  std::unique_lock lock(mutex_);
  while (!is_ending_told_.wait_for(lock, kPeriod, [this] { return is_ending_; })) {
    if (server_.num_clients() == 0) continue;
    const LiveMapPtr map = std::exchange(map_, nullptr);
    const std::optional<Trajectory> way = std::exchange(way_, std::nullopt);
    std::optional<std::pair<LivePose, Scan>> seen;
    if (std::exchange(has_new_pose_, false)) seen.emplace(pose_, scan_);
    lock.unlock();
    if (seen) server_.show(view::Shown::kPose, view_pose(seen->first, seen->second));
    server_.show(view::Shown::kReport, view_report(session_, can_save_));
    if (map) {
      if (std::string text = view_map(*map); !text.empty()) {
        server_.show(view::Shown::kMap, std::move(text));
      }
    }
    if (way) server_.show(view::Shown::kWay, view_way(*way));
    lock.lock();
  }
}

std::string ViewOutput::carry_out(const std::string& text) {
  const std::optional<view::Command> command = view::parse_command(text);
  if (!command) return view_answer(false, "not understood");
  try {
    switch (command->kind) {
      case view::Command::Kind::kSave:
        return view_answer(true, save_(""));
      case view::Command::Kind::kPause:
        session_.pause(command->is_on);
        return view_answer(true, command->is_on ? "paused" : "going on");
      case view::Command::Kind::kSetPose:
        if (session_.set_pose(command->T_map_base)) return view_answer(true, "the pose is tried");
        return view_answer(false, "a pose has no meaning while a map is made");
    }
  } catch (const std::exception& error) {
    return view_answer(false, error.what());
  }
  return view_answer(false, "not understood");
}

}  // namespace setsquare::live_app
