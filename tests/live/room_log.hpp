// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A log for the tests of sessions.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "setsquare/io/logs/log_reader.hpp"
#include "tests/support/simulated_drive.hpp"
#include "tests/support/walled_world.hpp"

namespace setsquare::live_test {

/// Scans around the room with the wheels' truth; `before` is called before each.
class RoomLog final : public LogReader {
 public:
  explicit RoomLog(std::function<void(std::size_t)> before = {},
                   const std::vector<Eigen::Vector2d>& way = testing::way_around_the_room())
      : truth_(testing::drive(way, 0.1, rad_from_deg(6.0))),
        scans_(testing::scans_on_drive(testing::l_shaped_room(), truth_, 0.01)),
        before_(std::move(before)) {}

  const LogRecord* next() override {
    if (num_read_ == scans_.size()) return nullptr;
    if (before_) before_(num_read_);
    record_.sensor = "LASER";
    record_.scan = scans_[num_read_];
    record_.stamp = record_.scan.stamp;
    record_.T_odom_base = truth_[num_read_++];
    return &record_;
  }
  [[nodiscard]] const LogProblems& problems() const override { return problems_; }
  [[nodiscard]] std::string front_sensor() const override { return "LASER"; }
  [[nodiscard]] std::string format() const override { return "room"; }
  [[nodiscard]] std::optional<double> fraction_read() const override { return std::nullopt; }
  [[nodiscard]] std::size_t num_scans() const { return scans_.size(); }
  [[nodiscard]] const std::vector<Pose2>& truth() const { return truth_; }

 private:
  std::vector<Pose2> truth_;
  std::vector<Scan> scans_;
  std::function<void(std::size_t)> before_;
  std::size_t num_read_ = 0;
  LogRecord record_;
  LogProblems problems_;
};

}  // namespace setsquare::live_test
