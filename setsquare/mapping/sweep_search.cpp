// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/sweep_search.hpp"

#include <cmath>
#include <utility>

#include "setsquare/tracking/deskew.hpp"

namespace setsquare {
namespace {

/// Whether a sweep was found to take as long as the log says, and the same way around.
bool is_as_stated(double found_s, double stated_s) {
  constexpr double kSame = 0.3;  // Drivers state a nominal rate.
  return std::abs(found_s - stated_s) <= kSame * std::abs(found_s);
}

}  // namespace

void SweepSearch::begin(const Scan& scan) {
  scanner_ = scan.scanner;
  report_.stated_s = sweep_time_s(scan);
  const bool is_tried = params_.deskew.is_on && params_.deskew.trial.is_on;
  if (is_tried && sees_all_around(scan)) {
    trial_.emplace(params_);
  } else if (report_.stated_s != 0.0) {
    report_.verdict = SweepVerdict::kStated;
    report_.sweep_s = report_.stated_s;
  }
}

void SweepSearch::add(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
  if (!scanner_) begin(scan);
  if (!trial_) return;
  inputs_.emplace_back(MapperScan{scan, T_wheels_base});
  if (scan.scanner == *scanner_) trial_->add(scan, T_wheels_base);
  if (!trial_->is_open()) settle();
}

void SweepSearch::add_turn_rate(Timestamp stamp, double turn_rad_per_s) {
  if (trial_) inputs_.emplace_back(MapperTurnRate{stamp, turn_rad_per_s});
}

void SweepSearch::settle() {
  report_.num_turns = trial_->num_turns();
  const std::optional<double> found_s = trial_->sweep_s();
  trial_.reset();
  if (found_s == 0.0) {
    report_.verdict = SweepVerdict::kAtOnce;
  } else if (found_s) {
    const bool is_stated = is_as_stated(*found_s, report_.stated_s);
    report_.verdict = is_stated ? SweepVerdict::kStated : SweepVerdict::kFound;
    report_.sweep_s = is_stated ? report_.stated_s : *found_s;
  }
  must_map_again_ = report_.sweep_s != 0.0;
  if (!must_map_again_) inputs_ = {};
}

std::optional<Scan> SweepSearch::mended(const Scan& scan) const {
  const bool is_mended = scan.scanner == scanner_ && report_.sweep_s != report_.stated_s;
  if (!is_mended || scan.num_beams() < 2) return std::nullopt;
  Scan mended = scan;
  mended.time_increment_s = report_.sweep_s / static_cast<double>(scan.num_beams() - 1);
  return mended;
}

std::vector<MapperInput> SweepSearch::take_to_map_again() {
  if (!std::exchange(must_map_again_, false)) return {};
  return std::exchange(inputs_, {});
}

}  // namespace setsquare
