// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/scan_chain.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>

#include "setsquare/headings/fusion.hpp"
#include "setsquare/headings/proposals.hpp"
#include "setsquare/mapping/mapper.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/mapping/paper_mapper.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare::experiments {
namespace {

void count(ChainCounts& counts, MatchStatus status) {
  switch (status) {
    case MatchStatus::kMatched:
      ++counts.num_matched;
      return;
    case MatchStatus::kDegenerate:
      ++counts.num_degenerate;
      return;
    case MatchStatus::kAmbiguous:
      ++counts.num_ambiguous;
      return;
    case MatchStatus::kNoOverlap:
    case MatchStatus::kTooFewPoints:
    case MatchStatus::kRejected:
      ++counts.num_unmatched;
      return;
  }
}

/// A match with the scan before, and the motion that the chain takes from it.
struct Link {
  MatchResult result;
  Pose2 motion;
};

std::vector<Link> link_scans(std::span<const SimulatedScan> scans) {
  std::vector<Link> links(scans.size());
  PreparedScan previous = prepare(scans.front().scan);
  for (std::size_t k = 1; k < scans.size(); ++k) {
    PreparedScan current = prepare(scans[k].scan);
    links[k].result = match(previous, current);
    links[k].motion = motion_from(links[k].result, links[k - 1].motion);
    previous = std::move(current);
  }
  return links;
}

/// What Mapper gives the fusion for each keyframe, here for every scan.
std::vector<HeadingEvidence> heading_evidence(std::span<const SimulatedScan> scans,
                                              const std::vector<Link>& links) {
  const MapperParams params;
  std::vector<HeadingEvidence> evidence(scans.size());
  double tracked_rad = 0.0;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const double turn_rad = links[k].motion.theta_rad;
    const bool is_turn_known = links[k].result.status == MatchStatus::kMatched ||
                               links[k].result.status == MatchStatus::kDegenerate;
    tracked_rad += turn_rad;
    evidence[k].tracked_heading_rad = tracked_rad;
    evidence[k].step_sigma_rad =
        std::hypot(params.motion.step_sigma_rad + params.motion.sigma_per_turn * std::abs(turn_rad),
                   is_turn_known ? 0.0 : params.motion.lost_sigma_rad);
    evidence[k].proposals =
        heading_proposals(scans[k].scan, params.direction, params.confident_margin);
  }
  return evidence;
}

}  // namespace

ChainCounts& ChainCounts::operator+=(const ChainCounts& other) {
  num_matched += other.num_matched;
  num_degenerate += other.num_degenerate;
  num_ambiguous += other.num_ambiguous;
  num_unmatched += other.num_unmatched;
  return *this;
}

Pose2 motion_from(const MatchResult& result, const Pose2& last_motion) {
  if (!result.T_reference_current) return last_motion;
  const Pose2& answered = *result.T_reference_current;
  if (result.status == MatchStatus::kMatched) return answered;
  if (result.degenerate_direction_rad) {
    const Eigen::Vector2d along(std::cos(*result.degenerate_direction_rad),
                                std::sin(*result.degenerate_direction_rad));
    const Eigen::Vector2d open = last_motion.translation() - answered.translation();
    const Eigen::Vector2d p = answered.translation() + along * along.dot(open);
    return {p.x(), p.y(), answered.theta_rad};
  }
  if (result.status != MatchStatus::kAmbiguous || !result.runner_up) return last_motion;
  const Pose2& other = result.runner_up->T_reference_current;
  const auto distance = [&last_motion](const Pose2& pose) {
    return (pose.translation() - last_motion.translation()).norm() +
           std::abs(wrap_to_pi(pose.theta_rad - last_motion.theta_rad));
  };
  return distance(other) < distance(answered) ? other : answered;
}

Eigen::Vector2d translation_given_turn(const MatchResult& result,
                                       const Pose2& answered,
                                       double turn_rad) {
  const Eigen::Matrix2d binding = result.information.topLeftCorner<2, 2>();
  const Eigen::FullPivLU<Eigen::Matrix2d> solver(binding);
  if (result.status != MatchStatus::kMatched || !solver.isInvertible()) {
    return answered.translation();
  }
  const double change_rad = wrap_to_pi(turn_rad - answered.theta_rad);
  const Eigen::Vector2d pull = result.information.topRightCorner<2, 1>() * change_rad;
  return answered.translation() - solver.solve(pull);
}

ScanChain chain_by_default_matcher(std::span<const SimulatedScan> scans) {
  ScanChain chain;
  if (scans.empty()) return chain;
  const std::vector<Link> links = link_scans(scans);
  const std::vector<double> heading_rad = fuse_headings(heading_evidence(scans, links)).heading_rad;
  chain.T_map_base.push_back({0.0, 0.0, wrap_to_pi(heading_rad[0])});
  for (std::size_t k = 1; k < scans.size(); ++k) {
    const double turn_rad = heading_rad[k] - heading_rad[k - 1];
    const Eigen::Vector2d step = translation_given_turn(links[k].result, links[k].motion, turn_rad);
    chain.T_map_base.push_back(chain.T_map_base.back() * Pose2{step.x(), step.y(), turn_rad});
    count(chain.counts, links[k].result.status);
  }
  return chain;
}

ScanChain chain_from(const Map& track) {
  ScanChain chain;
  for (const MappedScan& placed : track.scans) {
    chain.T_map_base.push_back(placed.T_map_base);
    if (placed.status == TrackStatus::kLost) {
      ++chain.counts.num_unmatched;
    } else if (chain.T_map_base.size() > 1) {
      ++chain.counts.num_matched;
    }
  }
  return chain;
}

PaperChains chains_by_paper(std::span<const SimulatedScan> scans) {
  // Any motion makes a keyframe: each scan's reference is the last one that was placed.
  PaperMapperParams params;
  params.keyframe_distance_m = 1e-9;
  params.keyframe_turn_rad = 1e-9;
  // Neighbours are 10 deg apart: within four scans the robot turns by less than the limit.
  params.max_rejected = 4;
  PaperMapper in_sequence(params);
  params.matcher.max_rotation_rad = kPi;
  PaperMapper literal(params);
  for (const SimulatedScan& simulated : scans) {
    const PreparedPaperScan prepared = prepare_paper(simulated.scan, params.matcher);
    static_cast<void>(in_sequence.add(simulated.scan, prepared));
    static_cast<void>(literal.add(simulated.scan, prepared));
  }
  return {chain_from(literal.finish()), chain_from(in_sequence.finish())};
}

}  // namespace setsquare::experiments
