// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/relation_error.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "setsquare/eval/pose_pairs.hpp"

namespace setsquare {
namespace {

constexpr double kLongTime_s = 60.0;

MeanAndDeviation mean_and_deviation(const std::vector<double>& values,
                                    const std::optional<BootstrapParams>& bootstrap) {
  if (values.empty()) return {};
  double sum = 0.0;
  for (const double value : values) sum += value;
  MeanAndDeviation found = {.mean = sum / static_cast<double>(values.size())};
  if (bootstrap) found.mean_bound = bootstrap_bounds(values, *bootstrap).mean;
  if (values.size() < 2) return found;
  double sum_of_squares = 0.0;
  for (const double value : values) sum_of_squares += (value - found.mean) * (value - found.mean);
  found.deviation = std::sqrt(sum_of_squares / static_cast<double>(values.size() - 1));
  return found;
}

std::vector<double> squared(std::vector<double> values) {
  for (double& value : values) value *= value;
  return values;
}

/// Those of the errors whose stamps are so far apart.
RelationErrors summarise(const RelationErrorSeries& series,
                         const std::function<bool(double seconds)>& is_included,
                         const std::optional<BootstrapParams>& bootstrap) {
  std::vector<double> translation_m;
  std::vector<double> rotation_rad;
  for (std::size_t i = 0; i < series.seconds.size(); ++i) {
    if (!is_included(series.seconds[i])) continue;
    translation_m.push_back(series.errors.translation_m[i]);
    rotation_rad.push_back(series.errors.rotation_rad[i]);
  }
  return {translation_m.size(),
          mean_and_deviation(translation_m, bootstrap),
          mean_and_deviation(squared(translation_m), bootstrap),
          mean_and_deviation(rotation_rad, bootstrap),
          mean_and_deviation(squared(rotation_rad), bootstrap)};
}

}  // namespace

RelationErrorSeries relation_errors(const Trajectory& trajectory,
                                    std::span<const Relation> relations) {
  std::vector<Relation> in_order(relations.begin(), relations.end());
  std::stable_sort(in_order.begin(), in_order.end(), [](const Relation& a, const Relation& b) {
    return a.reference_stamp < b.reference_stamp;
  });
  const PoseIndex poses(trajectory);
  RelationErrorSeries series;
  for (const Relation& relation : in_order) {
    const auto reference = poses.find(relation.reference_stamp);
    const auto current = poses.find(relation.current_stamp);
    if (!reference || !current) {
      ++series.num_missing;
      continue;
    }
    const Pose2 T_reference_current = reference->pose.inverse() * current->pose;
    const Pose2 error = T_reference_current * relation.T_reference_current.inverse();
    series.errors.stamps.push_back(relation.reference_stamp);
    series.errors.translation_m.push_back(std::hypot(error.x_m, error.y_m));
    series.errors.rotation_rad.push_back(std::abs(wrap_to_pi(error.theta_rad)));
    series.seconds.push_back(
        std::abs(seconds_between(relation.reference_stamp, relation.current_stamp)));
  }
  return series;
}

RelationErrorReport relation_error(const Trajectory& trajectory,
                                   std::span<const Relation> relations,
                                   const std::optional<BootstrapParams>& bootstrap) {
  const RelationErrorSeries series = relation_errors(trajectory, relations);
  const auto is_any = [](double) { return true; };
  const auto is_short = [](double seconds) { return seconds < kLongTime_s; };
  const auto is_long = [](double seconds) { return seconds >= kLongTime_s; };
  return {summarise(series, is_any, bootstrap),
          summarise(series, is_short, bootstrap),
          summarise(series, is_long, bootstrap),
          series.num_missing};
}

}  // namespace setsquare
