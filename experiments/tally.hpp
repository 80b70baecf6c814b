// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/pairs.hpp"

namespace setsquare::experiments {

/// Mean and standard deviation of values that come one by one.
struct Spread {
  std::size_t count = 0;
  double sum = 0.0;
  double sum_of_squares = 0.0;
  double highest = 0.0;  ///< Of the values, none below 0.

  void add(double value);
  [[nodiscard]] double mean() const;   ///< NaN where there is no value.
  [[nodiscard]] double sigma() const;  ///< Of the values, not of their mean; NaN without any.
};

/// part / whole; NaN where the whole is 0.
[[nodiscard]] double share(std::size_t part, std::size_t whole);

/// The value below which half of the values lie; NaN without values.
[[nodiscard]] double median(const std::vector<double>& values);

/// Counts and errors of many answers.
struct Tally {
  std::size_t num_pairs = 0;
  std::size_t num_success = 0;          ///< Pose right, whatever the status.
  std::size_t num_matched = 0;          ///< Status `matched`.
  std::size_t num_matched_success = 0;  ///< Both.
  std::size_t num_wrong = 0;            ///< `matched` and further off than 0.2 m or 3 deg.
  Spread success_error_m;
  Spread success_error_rad;
  /// Of the answers `matched` with full rank: e^T Omega e, the wrong ones included ...
  Spread nees;
  std::size_t num_nees_inside = 0;  ///< Below kNees95.
  /// ... and of the right ones alone: of a wrong answer its size means nothing.
  Spread right_nees;
  std::size_t num_right_nees_inside = 0;

  void add(const PairAnswer& answer);
  [[nodiscard]] double success_share() const { return share(num_success, num_pairs); }
  [[nodiscard]] double matched_share() const { return share(num_matched, num_pairs); }
  [[nodiscard]] double wrong_share() const { return share(num_wrong, num_matched); }
  [[nodiscard]] double nees_inside_share() const { return share(num_nees_inside, nees.count); }
  [[nodiscard]] double right_nees_inside_share() const {
    return share(num_right_nees_inside, right_nees.count);
  }
};

/// Keys stay in the order in which they were written; NaN is written as null.
using Json = nlohmann::ordered_json;

/// {"mean": ..., "sigma": ..., "max": ..., "count": ...}, values times `unit`.
[[nodiscard]] Json json_from(const Spread& spread, double unit = 1.0);

/// Counts, shares and errors (m, deg) of a tally.
[[nodiscard]] Json json_from(const Tally& tally);

/// Status and error of one answer.
[[nodiscard]] Json json_from(const PairAnswer& answer);

}  // namespace setsquare::experiments
