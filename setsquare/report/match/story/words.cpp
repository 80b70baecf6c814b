// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/match/story/words.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "setsquare/drawing/text.hpp"

namespace setsquare {
namespace {

/// What the status of the default matcher means, in a sentence.
std::string words_of_status(const MatchResult& result) {
  switch (result.status) {
    case MatchStatus::kMatched:
      return "Matched: the scans determine the pose, and no other explains them as well.";
    case MatchStatus::kAmbiguous:
      return "Ambiguous: the pose does not stand alone.";
    case MatchStatus::kDegenerate:
      return "Degenerate: the scans do not determine the motion along one direction.";
    case MatchStatus::kNoOverlap:
      return "No overlap: no proposal explains enough of the scans.";
    case MatchStatus::kTooFewPoints:
      return "Too few points: a scan has too few returns to say anything.";
    case MatchStatus::kRejected:
      return "Rejected: the correlation did not reach the paper's threshold.";
  }
  return "";
}

std::string words_of_paper_status(const MatchResult& result) {
  switch (result.status) {
    case MatchStatus::kMatched:
      return "Matched: the correlation exceeds the paper's threshold; nothing else was checked.";
    case MatchStatus::kRejected:
      return "Rejected: the correlation does not reach the paper's threshold.";
    default:
      return words_of_status(result);
  }
}

std::string words_of_answer(const MatchResult& result) {
  if (!result.T_reference_current) return "There is no pose to report.";
  return fmt::format("Pose of the current sensor in the reference sensor's frame: {}.",
                     words_of_pose(*result.T_reference_current));
}

std::string words_of_precision(const MatchResult& result) {
  const std::optional<PoseSigmas> sigmas = marginal_sigmas(result);
  if (!sigmas) return "No marginal sigma: one direction of the pose is not determined at all.";
  return fmt::format(
      "Marginal sigma (standard deviation, the other two being unknown): "
      "x {} mm, y {} mm, rotation {} deg.",
      fixed(1000.0 * sigmas->x_m, 1),
      fixed(1000.0 * sigmas->y_m, 1),
      fixed(deg_from_rad(sigmas->theta_rad), 3));
}

std::string words_of_margin(const MatchResult& result) {
  if (!result.runner_up) return "No different pose was found that explains the scans.";
  const Pose2& answer = *result.T_reference_current;
  const Pose2& other = result.runner_up->T_reference_current;
  return fmt::format(
      "The best different pose (the runner-up) is {} m and {} deg away and scores {}: a margin of "
      "{}.",
      fixed((answer.translation() - other.translation()).norm(), 2),
      fixed(deg_from_rad(std::abs(wrap_to_pi(other.theta_rad - answer.theta_rad))), 1),
      fixed(result.runner_up->score, 3),
      fixed(result.score - result.runner_up->score, 3));
}

std::string words_of_alias(const Pose2& motion) {
  return fmt::format(
      "The place looks the same after a motion by {} m and {} deg in the reference's frame: moved "
      "by "
      "it, the answer is a pose that the scans do not contradict either.",
      fixed(motion.translation().norm(), 2),
      fixed(deg_from_rad(motion.theta_rad), 1));
}

std::string words_of_decision(const std::vector<VerdictRule>& rules) {
  const auto failed =
      std::find_if(rules.begin(), rules.end(), [](const VerdictRule& rule) { return !rule.holds; });
  if (failed == rules.end()) {
    return fmt::format("What decided: all {} rules of the verdict hold.", rules.size());
  }
  return fmt::format("What decided: the rule \"{}\" fails: {} where {} is asked.",
                     failed->name,
                     failed->found,
                     failed->asked);
}

}  // namespace

std::string words_of_pose(const Pose2& pose) {
  return fmt::format("x {} m, y {} m, rotation {} deg",
                     fixed(pose.x_m, 3),
                     fixed(pose.y_m, 3),
                     fixed(deg_from_rad(pose.theta_rad), 2));
}

std::string words_of_share(double share) { return fixed(100.0 * share, 1) + " %"; }

std::vector<std::string> evidence_in_words(const MatchResult& result,
                                           const std::vector<VerdictRule>& rules) {
  std::vector<std::string> words = {words_of_status(result), words_of_decision(rules)};
  words.push_back(words_of_answer(result));
  if (!result.T_reference_current) return words;
  words.push_back(words_of_precision(result));
  if (result.degenerate_direction_rad) {
    words.push_back(fmt::format("Not determined along {} deg in the reference's frame.",
                                fixed(deg_from_rad(*result.degenerate_direction_rad), 1)));
  }
  words.push_back(
      fmt::format("Agreement: {} of the compared wall lies on the other scan's surfaces. "
                  "Contradiction: {} lies where the other scan saw through.",
                  words_of_share(result.agreement),
                  words_of_share(result.contradiction)));
  words.push_back(
      fmt::format("Overlap: the reference explains {} of the current scan's wall. Score: "
                  "{}.",
                  words_of_share(result.overlap),
                  fixed(result.score, 3)));
  words.push_back(fmt::format("Probability that the pose is right (within 0.2 m and 3 deg): {}.",
                              fixed(result.probability, 4)));
  if (result.alias) words.push_back(words_of_alias(*result.alias));
  words.push_back(words_of_margin(result));
  return words;
}

std::vector<std::string> evidence_in_words(const MatchResult& result, const PaperParams& params) {
  std::vector<std::string> words = {words_of_paper_status(result), words_of_answer(result)};
  if (!result.T_reference_current) return words;
  words.push_back(
      fmt::format("ZNCC of the profiles along x' {}, along y' {}, product {}; the paper "
                  "asks for more than {} (section 4.4.1).",
                  fixed(result.zncc_x, 3),
                  fixed(result.zncc_y, 3),
                  fixed(result.zncc_x * result.zncc_y, 3),
                  fixed(params.min_zncc_product, 2)));
  return words;
}

}  // namespace setsquare
