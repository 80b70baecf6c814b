// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/grid/beam_ends.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

/// A surface may miss one beam between two of its returns.
constexpr std::size_t kMaxBeamsApart = 2;

}  // namespace

void BeamEndParams::validate() const {
  if (!(max_return_range_m > 0.0)) throw ParameterError("max_return_range_m", "must be positive");
  if (!(max_no_return_range_m >= 0.0)) {
    throw ParameterError("max_no_return_range_m", "must not be negative");
  }
  if (min_neighbouring_no_returns < 1) {
    throw ParameterError("min_neighbouring_no_returns", "must be positive");
  }
  if (!(max_joint_m >= 0.0)) throw ParameterError("max_joint_m", "must not be negative");
}

BeamEndFinder::BeamEndFinder(const BeamEndParams& params) : params_(params) { params.validate(); }

void BeamEndFinder::set_directions(const Scan& scan) {
  if (directions_.size() == scan.num_beams() && first_bearing_rad_ == scan.first_bearing_rad &&
      bearing_step_rad_ == scan.bearing_step_rad) {
    return;
  }
  first_bearing_rad_ = scan.first_bearing_rad;
  bearing_step_rad_ = scan.bearing_step_rad;
  directions_.resize(scan.num_beams());
  for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
    const double bearing_rad = scan.bearing_rad(beam);
    directions_[beam] = {std::cos(bearing_rad), std::sin(bearing_rad)};
  }
}

void BeamEndFinder::set_words(const Scan& scan) {
  words_.assign(scan.num_beams(), Word::kNothing);
  for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
    const BeamOutcome outcome = scan.outcome(beam);
    if (outcome == BeamOutcome::kInvalid) continue;
    const bool is_near = scan.ranges_m[beam] <= params_.max_return_range_m;
    words_[beam] = outcome == BeamOutcome::kReturn && is_near ? Word::kReturn : Word::kNoReturn;
  }
}

void BeamEndFinder::drop_lone_no_returns() {
  const auto least = params_.min_neighbouring_no_returns;
  for (auto first = words_.begin(); first != words_.end();) {
    first = std::find(first, words_.end(), Word::kNoReturn);
    const auto end = std::find_if(first, words_.end(), [](Word w) { return w != Word::kNoReturn; });
    if (end - first < least) std::fill(first, end, Word::kNothing);
    first = end;
  }
}

const std::vector<BeamEnd>& BeamEndFinder::find(const Scan& scan) {
  set_directions(scan);
  set_words(scan);
  drop_lone_no_returns();
  ends_.clear();
  std::size_t last_return = scan.num_beams();
  Eigen::Vector2d p_last = Eigen::Vector2d::Zero();
  const double no_return_m = std::min(params_.max_no_return_range_m, scan.max_range_m);
  for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
    if (words_[beam] == Word::kNothing) continue;
    const bool is_return = words_[beam] == Word::kReturn;
    const Eigen::Vector2d p = (is_return ? scan.ranges_m[beam] : no_return_m) * directions_[beam];
    const bool is_joined = is_return && last_return < beam &&
                           beam - last_return <= kMaxBeamsApart &&
                           (p - p_last).squaredNorm() <= params_.max_joint_m * params_.max_joint_m;
    ends_.push_back({p.x(), p.y(), is_return, is_joined});
    if (!is_return) continue;
    last_return = beam;
    p_last = p;
  }
  return ends_;
}

std::vector<BeamEnd> beam_ends(const Scan& scan, const BeamEndParams& params) {
  return BeamEndFinder(params).find(scan);
}

}  // namespace setsquare
