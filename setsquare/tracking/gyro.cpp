// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/gyro.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/median.hpp"
#include "setsquare/core/parameter_checks.hpp"

namespace setsquare {
namespace {

constexpr double kClockSetBack_s = 1.0;
constexpr std::size_t kMinAtRest = 5;

/// Whether a ratio is a scale, within a factor.
bool is_near(double ratio, double scale, double factor) {
  return ratio > scale / factor && ratio < scale * factor;
}

GyroVerdict verdict_on(double scale, double deviation, const GyroParams& params) {
  if (!std::isfinite(scale) || deviation > params.max_deviation * std::abs(scale)) {
    return GyroVerdict::kUnlike;
  }
  if (is_near(scale, 1.0, params.scale_factor)) return GyroVerdict::kBelieved;
  if (is_near(-scale, 1.0, params.scale_factor)) return GyroVerdict::kMirrored;
  if (is_near(std::abs(scale), rad_from_deg(1.0), params.scale_factor)) {
    return GyroVerdict::kDegrees;
  }
  return GyroVerdict::kUnlike;
}

}  // namespace

void GyroParams::validate() const {
  require_positive(max_pause_s, "gyro.max_pause_s");
  require_positive(stretch_s, "gyro.stretch_s");
  require_at_least_one(num_stretches, "gyro.num_stretches");
  require_at_least_one(min_turns, "gyro.min_turns");
  require_positive(min_turn_rad, "gyro.min_turn_rad");
  require_positive(max_rest_rad, "gyro.max_rest_rad");
  require_positive(max_deviation, "gyro.max_deviation");
  if (!(scale_factor > 1.0)) throw ParameterError("gyro.scale_factor", "must be above 1");
}

void Gyro::add(Timestamp stamp, double turn_rad_per_s) {
  if (!std::isfinite(turn_rad_per_s)) return;
  ++report_.num_samples;
  if (samples_.empty()) {
    samples_.push_back({stamp, turn_rad_per_s, 0.0});
    return;
  }
  const Sample& last = samples_.back();
  const double pause_s = seconds_between(last.stamp, stamp);
  if (pause_s <= 0.0 && pause_s > -kClockSetBack_s) return;
  if (pause_s <= 0.0 || pause_s > params_.max_pause_s) {
    samples_.clear();
    samples_.push_back({stamp, turn_rad_per_s, 0.0});
    return;
  }
  samples_.push_back(
      {stamp, turn_rad_per_s, last.angle_rad + 0.5 * pause_s * (last.rad_per_s + turn_rad_per_s)});
  constexpr double kKept_s = 5.0;
  while (seconds_between(samples_.front().stamp, stamp) > kKept_s) samples_.pop_front();
}

std::optional<double> Gyro::angle_rad(Timestamp stamp) const {
  if (samples_.empty() || stamp < samples_.front().stamp) return std::nullopt;
  const auto after = std::upper_bound(
      samples_.begin(), samples_.end(), stamp, [](Timestamp value, const Sample& sample) {
        return value < sample.stamp;
      });
  const Sample& before = *(after - 1);
  const double since_s = seconds_between(before.stamp, stamp);
  if (after == samples_.end()) {  // The next sample comes behind the scan.
    if (since_s > params_.max_pause_s) return std::nullopt;
    return before.angle_rad + since_s * before.rad_per_s;
  }
  const double share = since_s / seconds_between(before.stamp, after->stamp);
  const double rad_per_s = before.rad_per_s + share * (after->rad_per_s - before.rad_per_s);
  return before.angle_rad + 0.5 * since_s * (before.rad_per_s + rad_per_s);
}

std::optional<double> Gyro::shown_rad(Timestamp from, Timestamp to) const {
  const auto begin_rad = angle_rad(from);
  const auto end_rad = angle_rad(to);
  if (!begin_rad || !end_rad) return std::nullopt;
  return *end_rad - *begin_rad;
}

std::optional<double> Gyro::turn_rad(Timestamp from, Timestamp to) const {
  if (report_.verdict != GyroVerdict::kBelieved) return std::nullopt;
  const auto shown = shown_rad(from, to);
  if (!shown) return std::nullopt;
  return report_.scale * (*shown - report_.bias_rad_per_s * seconds_between(from, to));
}

void Gyro::compare(Timestamp from, Timestamp to, double matched_rad) {
  const auto shown = shown_rad(from, to);
  if (!shown || to < from) {
    growing_.reset();
    return;
  }
  if (!growing_ || growing_->to != from) growing_ = Stretch(from);
  growing_->to = to;
  growing_->matched_rad += matched_rad;
  growing_->gyro_rad[kNoOffset] += *shown;
  if (growing_->duration_s() < params_.stretch_s) return;
  if (!stretches_.empty()) show_at_other_times(stretches_.back());
  stretches_.push_back(*std::exchange(growing_, std::nullopt));
  if (stretches_.size() > params_.num_stretches) stretches_.pop_front();
  judge();
}

Gyro::Stretch::Stretch(Timestamp begin) : from(begin), to(begin) {
  gyro_rad.fill(std::numeric_limits<double>::quiet_NaN());
  gyro_rad[kNoOffset] = 0.0;
}

double Gyro::scans_late_s(std::size_t offset) {
  return kOffsetStep_s * (static_cast<double>(offset) - static_cast<double>(kNoOffset));
}

void Gyro::show_at_other_times(Stretch& stretch) const {
  for (std::size_t k = 0; k < kNumOffsets; ++k) {
    if (k == kNoOffset) continue;
    const std::int64_t late_ns = timestamp_from_seconds(scans_late_s(k)).ns;
    const auto shown = shown_rad({stretch.from.ns - late_ns}, {stretch.to.ns - late_ns});
    if (shown) stretch.gyro_rad[k] = *shown;
  }
}

double Gyro::rest_rad_per_s(std::size_t offset) const {
  std::vector<double> shown_rad_per_s;
  for (const Stretch& stretch : stretches_) {
    const double gyro_rad = stretch.gyro_rad[offset];
    if (std::isnan(gyro_rad) || std::abs(stretch.matched_rad) > params_.max_rest_rad) continue;
    shown_rad_per_s.push_back(gyro_rad / stretch.duration_s());
  }
  return shown_rad_per_s.size() < kMinAtRest ? 0.0 : median(std::move(shown_rad_per_s));
}

Gyro::Fit Gyro::fit_at(std::size_t offset) const {
  const double rest = rest_rad_per_s(offset);
  std::vector<double> ratios;
  for (const Stretch& stretch : stretches_) {
    const double shown_rad = stretch.gyro_rad[offset];
    if (std::isnan(shown_rad) || std::abs(stretch.matched_rad) < params_.min_turn_rad) continue;
    ratios.push_back(stretch.matched_rad / (shown_rad - rest * stretch.duration_s()));
  }
  Fit fit{.num_turns = ratios.size()};
  if (ratios.size() < params_.min_turns) return fit;
  fit.scale = median(ratios);
  for (double& ratio : ratios) ratio = std::abs(ratio - fit.scale);
  fit.deviation = median(std::move(ratios));
  return fit;
}

void Gyro::judge() {
  const Fit fit = fit_at(kNoOffset);
  report_.num_turns = fit.num_turns;
  if (fit.num_turns < params_.min_turns) return;
  report_.scale = fit.scale;
  report_.scans_late_s = 0.0;
  report_.verdict = verdict_on(fit.scale, fit.deviation, params_);
  if (report_.verdict == GyroVerdict::kUnlike) judge_at_other_times();
  if (report_.verdict != GyroVerdict::kBelieved) return;
  std::vector<double> beyond_rad_per_s;
  for (const Stretch& stretch : stretches_) {
    beyond_rad_per_s.push_back((stretch.gyro_rad[kNoOffset] - stretch.matched_rad / report_.scale) /
                               stretch.duration_s());
  }
  report_.bias_rad_per_s = median(std::move(beyond_rad_per_s));
}

void Gyro::judge_at_other_times() {
  constexpr double kClearlyBetter = 0.5;
  Fit best;
  double best_share = std::numeric_limits<double>::infinity();
  std::size_t best_offset = kNoOffset;
  std::array<double, 2> least_share;  // By the scale's sign.
  least_share.fill(best_share);
  for (std::size_t k = 0; k < kNumOffsets; ++k) {
    const Fit fit = fit_at(k);
    const double share = fit.deviation / std::abs(fit.scale);
    if (std::isnan(share)) continue;  // Too few turns.
    double& least = least_share[fit.scale < 0.0 ? 1 : 0];
    least = std::min(least, share);
    if (share >= best_share) continue;
    best_share = share;
    best = fit;
    best_offset = k;
  }
  // To who swings to and fro evenly, half a swing later is the other way round.
  const double other_way_share = least_share[best.scale < 0.0 ? 0 : 1];
  if (best_offset == kNoOffset || best_share > kClearlyBetter * other_way_share) return;
  const GyroVerdict verdict = verdict_on(best.scale, best.deviation, params_);
  if (verdict == GyroVerdict::kUnlike) return;
  report_.verdict = verdict == GyroVerdict::kBelieved ? GyroVerdict::kOffTime : verdict;
  report_.num_turns = best.num_turns;
  report_.scale = best.scale;
  report_.scans_late_s = scans_late_s(best_offset);
}

}  // namespace setsquare
