// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/pipeline/chosen_scans.hpp"

#include <cmath>
#include <cstddef>
#include <sstream>

namespace setsquare {
namespace {

constexpr int kMinUnlike = 3;  ///< Scans of a sensor that repeat no other's before it is taken.

/// Whether both are one sweep: two scanners, or two sweeps of one that moves, never agree so.
bool is_same_sweep(const Scan& a, const Scan& b) {
  constexpr double kRounding_m = 0.011;  // Formats write millimetres or centimetres.
  constexpr double kMinSame = 0.8;
  constexpr std::size_t kMinCompared = 20;
  if (a.num_beams() != b.num_beams()) return false;
  std::size_t num_compared = 0;
  std::size_t num_same = 0;
  for (std::size_t i = 0; i < a.num_beams(); ++i) {
    if (a.outcome(i) != BeamOutcome::kReturn || b.outcome(i) != BeamOutcome::kReturn) continue;
    ++num_compared;
    num_same += std::abs(a.ranges_m[i] - b.ranges_m[i]) < kRounding_m ? 1 : 0;
  }
  return num_compared >= kMinCompared &&
         static_cast<double>(num_same) >= kMinSame * static_cast<double>(num_compared);
}

}  // namespace

bool names_several(const std::string& sensor) {
  return sensor == "all" || sensor.find(',') != std::string::npos;
}

bool ChosenScans::takes(const LogRecord& record, const std::string& front_sensor) {
  if (!names_several(wanted_)) return true;
  if (leader_.empty()) {
    leader_ = wanted_ == "all" ? front_sensor : wanted_.substr(0, wanted_.find(','));
  }
  has_leader_come_ = has_leader_come_ || record.sensor == leader_;
  find_repeated(record);
  last_[record.sensor] = record.scan;
  if (!has_leader_come_ || repeated_.contains(record.sensor)) return false;
  return record.sensor == leader_ || ++num_compared_[record.sensor] > kMinUnlike;
}

std::vector<std::string> ChosenScans::absent() const {
  std::vector<std::string> names;
  if (!names_several(wanted_) || wanted_ == "all") return names;
  std::istringstream list(wanted_);
  for (std::string name; std::getline(list, name, ',');) {
    if (!last_.contains(name)) names.push_back(name);
  }
  return names;
}

void ChosenScans::find_repeated(const LogRecord& record) {
  for (const auto& [name, scan] : last_) {
    if (name == record.sensor || repeated_.contains(name) || repeated_.contains(record.sensor) ||
        !is_same_sweep(scan, record.scan)) {
      continue;
    }
    if (record.sensor == leader_) {
      repeated_.emplace(name, leader_);
    } else {
      repeated_.emplace(record.sensor, name);
    }
  }
}

}  // namespace setsquare
