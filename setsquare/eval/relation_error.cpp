// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/relation_error.hpp"

#include <cmath>
#include <vector>

#include "setsquare/eval/pose_pairs.hpp"

namespace setsquare {
namespace {

constexpr double kLongTime_s = 60.0;

struct RelationError {
  double seconds = 0.0;
  double translation_m = 0.0;
  double rotation_rad = 0.0;
};

MeanAndDeviation mean_and_deviation(const std::vector<double>& values) {
  if (values.empty()) return {};
  double sum = 0.0;
  for (const double value : values) sum += value;
  const double mean = sum / static_cast<double>(values.size());
  if (values.size() < 2) return {mean, 0.0};
  double sum_of_squares = 0.0;
  for (const double value : values) sum_of_squares += (value - mean) * (value - mean);
  return {mean, std::sqrt(sum_of_squares / static_cast<double>(values.size() - 1))};
}

template <typename IsIncluded>
RelationErrors summarise(const std::vector<RelationError>& errors, const IsIncluded& is_included) {
  std::vector<double> translation_m;
  std::vector<double> squared_translation_m2;
  std::vector<double> rotation_rad;
  std::vector<double> squared_rotation_rad2;
  for (const RelationError& error : errors) {
    if (!is_included(error)) continue;
    translation_m.push_back(error.translation_m);
    squared_translation_m2.push_back(error.translation_m * error.translation_m);
    rotation_rad.push_back(error.rotation_rad);
    squared_rotation_rad2.push_back(error.rotation_rad * error.rotation_rad);
  }
  return {translation_m.size(),
          mean_and_deviation(translation_m),
          mean_and_deviation(squared_translation_m2),
          mean_and_deviation(rotation_rad),
          mean_and_deviation(squared_rotation_rad2)};
}

}  // namespace

RelationErrorReport relation_error(const Trajectory& trajectory,
                                   std::span<const Relation> relations) {
  const PoseIndex poses(trajectory);
  RelationErrorReport report;
  std::vector<RelationError> errors;
  for (const Relation& relation : relations) {
    const auto reference = poses.find(relation.reference_stamp);
    const auto current = poses.find(relation.current_stamp);
    if (!reference || !current) {
      ++report.num_missing;
      continue;
    }
    const Pose2 T_reference_current = reference->pose.inverse() * current->pose;
    const Pose2 error = T_reference_current * relation.T_reference_current.inverse();
    errors.push_back({std::abs(seconds_between(relation.reference_stamp, relation.current_stamp)),
                      std::hypot(error.x_m, error.y_m),
                      std::abs(wrap_to_pi(error.theta_rad))});
  }
  report.all = summarise(errors, [](const RelationError&) { return true; });
  report.under_60_s =
      summarise(errors, [](const RelationError& error) { return error.seconds < kLongTime_s; });
  report.from_60_s =
      summarise(errors, [](const RelationError& error) { return error.seconds >= kLongTime_s; });
  return report;
}

}  // namespace setsquare
