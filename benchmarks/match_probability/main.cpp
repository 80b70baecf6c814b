// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The probability of a match (matching/probability): its fit on simulated buildings, and how far it
// and the verdict are to be believed on others.
//
//   match_probability fit            the figures of matching/probability.cpp
//   match_probability fit-place      the figures of matching/same_place.cpp
//   match_probability check [DATA]   reliability; DATA is the folder of the public logs
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <string>
#include <vector>

#include "benchmarks/match_probability/known_pairs.hpp"
#include "experiments/pairs.hpp"
#include "setsquare/matching/answer.hpp"
#include "setsquare/matching/probability.hpp"
#include "setsquare/matching/same_place.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/matching/trace.hpp"

namespace setsquare::experiments {
namespace {

bool is_right(const MatchResult& result, const KnownPair& pair) {
  if (!pair.T_reference_current || !result.T_reference_current) return false;
  const Eigen::Vector3d error = pose_error(*result.T_reference_current, *pair.T_reference_current);
  return error.head<2>().norm() <= kWrong_m && std::abs(error.z()) <= kWrong_rad;
}

/// Features of best answers, and which were right.
struct Examples {
  std::vector<std::vector<double>> features;
  std::vector<double> is_right;
};

/// The best answer of one search.
void add_search(const KnownPair& pair,
                std::span<const RotationProposal> rotations,
                const SearchParams& search,
                Examples& examples) {
  const MatchParams params;
  const CorrelationGrid grid(pair.reference.points(), pair.reference.image());
  const auto candidates =
      search_candidates(pair.reference, pair.current, grid, rotations, search, params, nullptr);
  MatchTrace trace;
  const MatchResult result = answer(pair.reference, pair.current, candidates, params, &trace);
  if (!trace.verdict) return;
  const ProbabilityFeatures features = probability_features(trace.verdict->probability);
  examples.features.emplace_back(features.begin(), features.end());
  examples.is_right.push_back(is_right(result, pair));
}

/// The best answers of both searches.
void add_example(const KnownPair& pair, Examples& examples) {
  const MatchParams params;
  if (std::min(pair.reference.points().size(), pair.current.points().size()) <
      params.answer.min_points) {
    return;
  }
  const auto rotations = propose_rotations(
      pair.reference.histogram, pair.current.histogram, params.quick.num_rotations);
  add_search(pair, rotations, params.quick, examples);
  std::vector<RotationProposal> circle(params.thorough.num_rotations);
  for (std::size_t i = 0; i < circle.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(circle.size());
    circle[i].rotation_rad = wrap_to_pi(share * kTwoPi);
  }
  add_search(pair, circle, params.thorough, examples);
}

/// Weights and, last, the constant of a logistic regression: Newton's steps on the likelihood of
/// standardised features, held a little towards zero.
Eigen::VectorXd fit_log_odds(const std::vector<std::vector<double>>& features,
                             const std::vector<double>& is_right) {
  constexpr double kHold = 1e-5;  // Per example.
  const auto n = static_cast<Eigen::Index>(features.size());
  const auto d = static_cast<Eigen::Index>(features.front().size());
  Eigen::MatrixXd X(n, d + 1);
  for (Eigen::Index i = 0; i < n; ++i) {
    X.row(i).head(d) = Eigen::Map<const Eigen::RowVectorXd>(features[i].data(), d);
  }
  X.col(d).setOnes();
  const Eigen::RowVectorXd mean = X.leftCols(d).colwise().mean();
  X.leftCols(d).rowwise() -= mean;
  const Eigen::RowVectorXd sigma =
      (X.leftCols(d).colwise().squaredNorm() / static_cast<double>(n)).cwiseSqrt();
  X.leftCols(d).array().rowwise() /= sigma.array();
  const Eigen::Map<const Eigen::VectorXd> y(is_right.data(), n);
  Eigen::VectorXd hold = Eigen::VectorXd::Constant(d + 1, kHold * static_cast<double>(n));
  hold(d) = 0.0;
  Eigen::VectorXd w = Eigen::VectorXd::Zero(d + 1);
  for (int step = 0; step < 40; ++step) {
    const Eigen::VectorXd p = (1.0 + (-(X * w).array().max(-40.0).min(40.0)).exp()).inverse();
    const Eigen::VectorXd gradient = X.transpose() * (y - p) - hold.cwiseProduct(w);
    Eigen::MatrixXd H = X.transpose() * (p.array() * (1.0 - p.array())).matrix().asDiagonal() * X;
    H.diagonal() += hold;
    const Eigen::VectorXd change = H.ldlt().solve(gradient);
    w += change * std::min(1.0, 5.0 / change.cwiseAbs().maxCoeff());
  }
  Eigen::VectorXd weights = w;
  weights.head(d) = w.head(d).cwiseQuotient(sigma.transpose());
  weights(d) = w(d) - mean.dot(weights.head(d));
  return weights;
}

/// The weights: of answers of both searches, so that poor ones are among them, too.
Eigen::VectorXd fit_weights() {
  Examples examples;
  const VisitPair add = [&](const KnownPair& pair) { add_example(pair, examples); };
  visit_buildings(utm_30lx(), {2001, 40}, add);
  visit_buildings(half_turn_scanner(0.01), {2001, 16}, add);
  visit_buildings(half_turn_scanner(0.03), {2017, 12}, add);
  visit_buildings(low_cost_360(), {2001, 16}, add);
  visit_strangers(utm_30lx(), {2001, 6}, add);
  std::printf("weights: of %zu answers\n", examples.features.size());
  return fit_log_odds(examples.features, examples.is_right);
}

/// The map of the log odds: of answers as matches give them, as many buildings of each field of
/// view.
Eigen::VectorXd fit_map(const Eigen::VectorXd& weights) {
  constexpr double kKnee = 2.0;
  std::vector<std::vector<double>> log_odds;
  std::vector<double> is_right_answer;
  const VisitPair add = [&](const KnownPair& pair) {
    MatchTrace trace;
    const MatchResult result = match(pair.reference, pair.current, {}, &trace);
    if (!trace.verdict) return;
    const ProbabilityFeatures features = probability_features(trace.verdict->probability);
    double sum = weights(weights.size() - 1);
    for (std::size_t i = 0; i < features.size(); ++i) {
      sum += weights(static_cast<Eigen::Index>(i)) * features[i];
    }
    log_odds.push_back({sum, std::max(0.0, sum - kKnee)});
    is_right_answer.push_back(is_right(result, pair));
  };
  visit_buildings(utm_30lx(), {2001, 40}, add);
  visit_buildings(half_turn_scanner(0.01), {2001, 20}, add);
  visit_buildings(half_turn_scanner(0.03), {2021, 20}, add);
  visit_buildings(low_cost_360(), {2001, 40}, add);
  std::printf("map: of %zu answers\n", log_odds.size());
  return fit_log_odds(log_odds, is_right_answer);
}

/// The weights of "one place at all": of answers that may stand, as matches give them. Different
/// buildings are what must not be taken for one. That they are right where little overlaps is not
/// asked: such pairs have as little in common as different buildings.
Eigen::VectorXd fit_place() {
  constexpr double kProbable = 0.88;  // Log odds of 2: what is less probable never stands.
  const MatchParams params;
  Examples examples;
  const VisitPair add = [&](const KnownPair& pair) {
    MatchTrace trace;
    const MatchResult result = match(pair.reference, pair.current, params, &trace);
    if (!trace.verdict || !(result.probability > kProbable)) return;
    if (!(result.probability < params.answer.sure_probability)) return;
    const bool is_stranger = !pair.T_reference_current;
    constexpr double kHighOverlap = 0.45;
    const bool is_sound = pair.is_determined && pair.overlap >= kHighOverlap;
    if (!is_stranger && !(is_sound && is_right(result, pair))) return;
    const PlaceFeatures features = place_features(place_evidence(
        pair.reference, pair.current, *result.T_reference_current, trace.verdict->probability));
    examples.features.emplace_back(features.begin(), features.end());
    examples.is_right.push_back(is_stranger ? 0.0 : 1.0);
  };
  visit_buildings(utm_30lx(), {2001, 8}, add);
  visit_buildings(half_turn_scanner(0.01), {2001, 8}, add);
  visit_buildings(low_cost_360(), {2001, 8}, add);
  visit_many_strangers(utm_30lx(), {7001, 20}, add);
  visit_many_strangers(half_turn_scanner(0.01), {7001, 30}, add);
  visit_many_strangers(half_turn_scanner(0.03), {7001, 30}, add);
  visit_many_strangers(low_cost_360(), {7001, 20}, add);
  std::printf("place: of %zu answers\n", examples.features.size());
  return fit_log_odds(examples.features, examples.is_right);
}

void run_fit_place() {
  const Eigen::VectorXd weights = fit_place();
  std::printf("weights of the place:");
  for (Eigen::Index i = 0; i + 1 < weights.size(); ++i) std::printf(" %.6g,", weights(i));
  std::printf("\nconstant: %.6g\n", weights(weights.size() - 1));
}

void run_fit() {
  const Eigen::VectorXd weights = fit_weights();
  std::printf("weights:");
  for (Eigen::Index i = 0; i + 1 < weights.size(); ++i) std::printf(" %.6g,", weights(i));
  std::printf("\nconstant: %.6g\n", weights(weights.size() - 1));
  std::fflush(stdout);
  const Eigen::VectorXd map = fit_map(weights);
  std::printf("slope: %.6g\nslope above the knee: %.6g\noffset: %.6g\n", map(0), map(1), map(2));
}

/// How often answers of a set are right, against what they claim.
class Reliability {
 public:
  void add(const KnownPair& pair) {
    MatchParams params;
    params.answer.min_place_log_odds = kOnePlaceLogOdds;  // Some are of different buildings.
    const MatchResult result = match(pair.reference, pair.current, params);
    const bool right = is_right(result, pair);
    const bool is_matched = result.status == MatchStatus::kMatched;
    ++num_pairs_;
    num_matched_ += is_matched;
    num_wrong_ += is_matched && !right;
    constexpr double kHighOverlap = 0.45;
    if (right && pair.is_determined && pair.overlap >= kHighOverlap) {
      ++num_high_;
      num_high_matched_ += is_matched;
    }
    if (!(result.probability >= 0.0)) return;
    Bin& bin = bins_[static_cast<std::size_t>(std::min(9.0, 10.0 * result.probability))];
    ++bin.count;
    bin.claimed += result.probability;
    bin.right += right;
  }

  void tell(const char* name) const {
    double calibration_error = 0.0;
    for (const Bin& bin : bins_) {
      calibration_error += std::abs(bin.claimed - bin.right) / std::max(1, num_pairs_);
    }
    std::printf("| %s | %d | %d | %d | %d of %d | %.4f |",
                name,
                num_pairs_,
                num_matched_,
                num_wrong_,
                num_high_matched_,
                num_high_,
                calibration_error);
    for (const Bin& bin : bins_) {
      if (bin.count > 0) std::printf(" %.3f:%.3f", bin.claimed / bin.count, bin.right / bin.count);
    }
    std::printf("\n");
    std::fflush(stdout);
  }

 private:
  struct Bin {
    int count = 0;
    double claimed = 0.0;
    double right = 0.0;
  };
  int num_pairs_ = 0;
  int num_matched_ = 0;
  int num_wrong_ = 0;
  int num_high_ = 0;
  int num_high_matched_ = 0;
  std::array<Bin, 10> bins_{};
};

void run_check(const std::string& data_folder) {
  std::printf(
      "| pairs | number | matched | wrong | of right ones, overlap 45 %% and more | "
      "calibration error | claimed:right by tenth |\n");
  const auto check = [](const char* name, const auto& visit_all) {
    Reliability reliability;
    visit_all([&](const KnownPair& pair) { reliability.add(pair); });
    reliability.tell(name);
  };
  check("niches every 2 m", [](const VisitPair& visit) {
    visit_world(SmallWorld::kNiches, {1, 20}, visit);
  });
  check("ends of corridors, of two and of one",
        [](const VisitPair& visit) { visit_corridor_ends(2, 1000, visit); });
  check("furnished rooms, 180 deg", [](const VisitPair& visit) { visit_rooms(1, 400, visit); });
  if (!data_folder.empty()) {
    check("loops of real logs",
          [&](const VisitPair& visit) { visit_real_loops(data_folder, visit); });
    check("different real buildings",
          [&](const VisitPair& visit) { visit_real_strangers(data_folder, 4500, visit); });
  }
  check("buildings, 270 deg", [](const VisitPair& visit) {
    visit_buildings(utm_30lx(), {1, 40}, visit);
  });
  check("buildings, 180 deg", [](const VisitPair& visit) {
    visit_buildings(half_turn_scanner(0.01), {1, 16}, visit);
  });
  check("buildings, 360 deg", [](const VisitPair& visit) {
    visit_buildings(low_cost_360(), {1, 16}, visit);
  });
  check("different buildings", [](const VisitPair& visit) {
    visit_strangers(utm_30lx(), {1, 10}, visit);
  });
  check("different buildings, 180 deg", [](const VisitPair& visit) {
    visit_strangers(half_turn_scanner(0.01), {1, 10}, visit);
  });
}

}  // namespace
}  // namespace setsquare::experiments

int main(int argc, char** argv) {
  const std::string task = argc > 1 ? argv[1] : "";
  if (task == "fit-place") {
    setsquare::experiments::run_fit_place();
  } else if (task == "fit") {
    setsquare::experiments::run_fit();
  } else if (task == "check") {
    setsquare::experiments::run_check(argc > 2 ? argv[2] : "");
  } else {
    std::fputs("match_probability fit | fit-place | check [FOLDER OF THE PUBLIC LOGS]\n", stderr);
    return 2;
  }
  return 0;
}
