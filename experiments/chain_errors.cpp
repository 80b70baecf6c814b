// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/chain_errors.hpp"

#include <algorithm>
#include <cmath>

namespace setsquare::experiments {
namespace {

/// Sums for a line through points.
struct LineFit {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;

  void add(double px, double py) {
    n += 1.0;
    x += px;
    y += py;
    xx += px * px;
    xy += px * py;
  }
  [[nodiscard]] double slope() const { return (n * xy - x * y) / (n * xx - x * x); }
};

}  // namespace

double axis_of_plan(const FloorPlan& plan) {
  // Four times the angle makes the directions of a square one.
  double cos_sum = 0.0;
  double sin_sum = 0.0;
  for (const PlanSegment& segment : plan.segments) {
    if (segment.material != Material::kWall) continue;
    const Eigen::Vector2d wall_m = segment.end_m - segment.start_m;
    const double angle_rad = 4.0 * std::atan2(wall_m.y(), wall_m.x());
    cos_sum += wall_m.norm() * std::cos(angle_rad);
    sin_sum += wall_m.norm() * std::sin(angle_rad);
  }
  return 0.25 * std::atan2(sin_sum, cos_sum);
}

std::vector<Pose2> placed_at_truth(std::span<const Pose2> chain,
                                   std::span<const Pose2> truth,
                                   double axis_rad) {
  constexpr double kQuarter = 0.5 * kPi;
  const double difference_rad = truth.front().theta_rad - chain.front().theta_rad;
  const double turn_rad = axis_rad + kQuarter * std::round((difference_rad - axis_rad) / kQuarter);
  const Pose2 turn{0.0, 0.0, turn_rad};
  const Eigen::Vector2d start = turn * chain.front().translation();
  const Pose2 move{truth.front().x_m - start.x(), truth.front().y_m - start.y(), turn_rad};
  std::vector<Pose2> placed;
  placed.reserve(chain.size());
  for (const Pose2& pose : chain) placed.push_back(move * pose);
  return placed;
}

std::vector<double> travelled_m(std::span<const Pose2> poses) {
  std::vector<double> path_m(poses.size(), 0.0);
  for (std::size_t k = 1; k < poses.size(); ++k) {
    path_m[k] = path_m[k - 1] + (poses[k].translation() - poses[k - 1].translation()).norm();
  }
  return path_m;
}

HeadingErrors heading_errors(std::span<const Pose2> chain, std::span<const Pose2> truth) {
  const std::vector<double> path_m = travelled_m(truth);
  HeadingErrors errors;
  LineFit fit;
  LineFit square_fit;
  double sum_rad = 0.0;
  double square_sum_rad = 0.0;
  double previous_rad = 0.0;
  for (std::size_t k = 0; k < chain.size(); ++k) {
    const double error_rad = wrap_to_pi(chain[k].theta_rad - truth[k].theta_rad);
    const double square_rad = wrap_to_period(error_rad, 0.5 * kPi);
    const double step_rad = wrap_to_pi(error_rad - previous_rad);
    errors.num_wrong_turns += k > 0 && std::abs(step_rad) > 0.25 * kPi;
    errors.highest_rad = std::max(errors.highest_rad, std::abs(error_rad));
    fit.add(path_m[k], error_rad);
    square_fit.add(path_m[k], square_rad);
    sum_rad += std::abs(error_rad);
    square_sum_rad += std::abs(square_rad);
    previous_rad = error_rad;
  }
  const auto num_scans = static_cast<double>(chain.size());
  errors.mean_rad = sum_rad / num_scans;
  errors.end_rad = std::abs(previous_rad);
  errors.slope_rad_per_100_m = 100.0 * fit.slope();
  errors.square_mean_rad = square_sum_rad / num_scans;
  errors.square_end_rad = std::abs(wrap_to_period(previous_rad, 0.5 * kPi));
  errors.square_slope_rad_per_100_m = 100.0 * square_fit.slope();
  return errors;
}

Eigen::Vector2d closure_error(std::span<const Pose2> chain,
                              std::span<const Pose2> truth,
                              std::size_t start,
                              std::size_t end) {
  const Pose2 answered = chain[start].inverse() * chain[end];
  const Pose2 correct = truth[start].inverse() * truth[end];
  const Pose2 heading{0.0, 0.0, truth[start].theta_rad};
  return heading * Eigen::Vector2d(answered.translation() - correct.translation());
}

}  // namespace setsquare::experiments
