// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/relation_error.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace setsquare {
namespace {

constexpr std::int64_t kStampTolerance_ns = 12'000;
constexpr double kLongTime_s = 60.0;

struct RelationError {
  double seconds = 0.0;
  double translation_m = 0.0;
  double rotation_rad = 0.0;
};

/// Poses by stamp.
class PoseIndex {
 public:
  explicit PoseIndex(const Trajectory& trajectory) : poses_(trajectory) {
    std::stable_sort(poses_.begin(), poses_.end(), is_earlier);
  }

  [[nodiscard]] std::optional<Pose2> find(Timestamp stamp) const {
    const auto after =
        std::lower_bound(poses_.begin(), poses_.end(), StampedPose{stamp, {}}, is_earlier);
    std::optional<Pose2> nearest;
    std::int64_t nearest_ns = kStampTolerance_ns + 1;
    for (auto candidate = after == poses_.begin() ? after : after - 1;
         candidate != poses_.end() && candidate <= after;
         ++candidate) {
      const std::int64_t distance_ns = std::abs(candidate->stamp.ns - stamp.ns);
      if (distance_ns >= nearest_ns) continue;
      nearest_ns = distance_ns;
      nearest = candidate->pose;
    }
    return nearest;
  }

 private:
  static bool is_earlier(const StampedPose& a, const StampedPose& b) { return a.stamp < b.stamp; }

  Trajectory poses_;
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
    const auto T_map_reference = poses.find(relation.reference_stamp);
    const auto T_map_current = poses.find(relation.current_stamp);
    if (!T_map_reference || !T_map_current) {
      ++report.num_missing;
      continue;
    }
    const Pose2 T_reference_current = T_map_reference->inverse() * *T_map_current;
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
