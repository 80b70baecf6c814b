// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/match/story/words.hpp"

#include <cmath>
#include <Eigen/Eigenvalues>

#include "setsquare/drawing/text.hpp"

namespace setsquare {
namespace {

/// What the status of the default matcher means, in a sentence.
std::string words_of_status(const MatchResult& result) {
  switch (result.status) {
    case MatchStatus::kMatched:
      return "Matched: the scans determine the pose, and no other explains them as well.";
    case MatchStatus::kAmbiguous:
      return "Ambiguous: another pose explains the scans almost as well, or none explains them "
             "well.";
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

std::string percent(double share) { return joined({fixed(100.0 * share, 1), " %"}); }

std::string words_of_zncc(const MatchResult& result) {
  return joined({"ZNCC of the profiles along x' ",
                 fixed(result.zncc_x, 3),
                 ", along y' ",
                 fixed(result.zncc_y, 3),
                 ", product ",
                 fixed(result.zncc_x * result.zncc_y, 3)});
}

std::string words_of_answer(const MatchResult& result) {
  if (!result.T_reference_current) return "There is no pose to report.";
  return joined({"Pose of the current sensor in the reference sensor's frame: ",
                 words_of_pose(*result.T_reference_current),
                 "."});
}

/// Standard deviations from the information, where it has an inverse.
std::string words_of_precision(const MatchResult& result) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(result.information);
  const double largest = solver.eigenvalues()(2);
  if (!(largest > 0.0)) return "";
  if (solver.eigenvalues()(0) < 1e-9 * largest)
    return "One direction of the pose is not determined at all.";
  const Eigen::Matrix3d covariance = result.information.inverse();
  return joined({"Standard deviations from the information matrix: x ",
                 fixed(1000.0 * std::sqrt(covariance(0, 0)), 1),
                 " mm, y ",
                 fixed(1000.0 * std::sqrt(covariance(1, 1)), 1),
                 " mm, rotation ",
                 fixed(deg_from_rad(std::sqrt(covariance(2, 2))), 3),
                 " deg."});
}

std::string words_of_margin(const MatchResult& result, const AnswerParams& params) {
  if (!result.runner_up) return "No different pose was found that explains the scans.";
  return joined(
      {"The best different pose (the runner-up) is ",
       words_of_difference(*result.T_reference_current, result.runner_up->T_reference_current),
       " and scores ",
       fixed(result.runner_up->score, 3),
       ": a margin of ",
       fixed(result.score - result.runner_up->score, 3),
       ", where ",
       fixed(params.min_margin, 2),
       " is asked (",
       fixed(params.min_margin_alone, 2),
       " of a low score)."});
}

}  // namespace

std::string words_of_pose(const Pose2& pose) {
  return joined({"x ",
                 fixed(pose.x_m, 3),
                 " m, y ",
                 fixed(pose.y_m, 3),
                 " m, rotation ",
                 fixed(deg_from_rad(pose.theta_rad), 2),
                 " deg"});
}

std::string words_of_difference(const Pose2& from, const Pose2& to) {
  return joined({fixed((from.translation() - to.translation()).norm(), 2),
                 " m and ",
                 fixed(deg_from_rad(std::abs(wrap_to_pi(to.theta_rad - from.theta_rad))), 1),
                 " deg away"});
}

std::vector<std::string> evidence_in_words(const MatchResult& result, const MatchParams& params) {
  std::vector<std::string> words = {words_of_status(result), words_of_answer(result)};
  if (!result.T_reference_current) return words;
  words.push_back(
      joined({"Agreement: ",
              percent(result.agreement),
              " of the compared wall lies on the other scan's surfaces. Contradiction: ",
              percent(result.contradiction),
              " lies where the other scan saw through."}));
  words.push_back(joined({"Overlap: the reference explains ",
                          percent(result.overlap),
                          " of the current scan's wall. Score ",
                          fixed(result.score, 3),
                          " (at least ",
                          fixed(params.answer.min_score, 2),
                          " is asked, or ",
                          fixed(params.answer.min_score_alone, 2),
                          " with a wide margin)."}));
  words.push_back(words_of_margin(result, params.answer));
  if (result.degenerate_direction_rad) {
    words.push_back(joined({"Not determined along ",
                            fixed(deg_from_rad(*result.degenerate_direction_rad), 1),
                            " deg in the reference's frame."}));
  }
  words.push_back(words_of_precision(result));
  words.push_back(words_of_zncc(result) + ".");
  std::erase(words, "");
  return words;
}

std::vector<std::string> evidence_in_words(const MatchResult& result, const PaperParams& params) {
  std::vector<std::string> words = {words_of_paper_status(result), words_of_answer(result)};
  if (!result.T_reference_current) return words;
  words.push_back(joined({words_of_zncc(result),
                          "; the paper asks for more than ",
                          fixed(params.min_zncc_product, 2),
                          " (section 4.4.1)."}));
  return words;
}

}  // namespace setsquare
