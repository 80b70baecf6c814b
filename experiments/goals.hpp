// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/paper_experiment.hpp"

namespace setsquare::experiments {

/// One goal of the experiments. Not on the page: the tests and `--check-goals` use it.
struct Goal {
  std::string what;
  std::string paper;  ///< The paper's own figure, or a dash.
  std::string must;
  std::string aim;
  std::string reached;  ///< A dash where the section was not run.
  bool is_known = false;
  bool meets_must = false;
  bool meets_aim = false;
};

/// The goals, each computed from what was run.
[[nodiscard]] std::vector<Goal> goals_of(const PaperExperiment& experiment);

/// The wall time and its goal, where all sections were run.
[[nodiscard]] Goal time_goal(const PaperExperiment& experiment);

[[nodiscard]] Json json_from(const std::vector<Goal>& goals);

}  // namespace setsquare::experiments
