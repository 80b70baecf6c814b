// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/building_study.hpp"
#include "experiments/circuit_study.hpp"
#include "experiments/factor_study.hpp"
#include "experiments/hallway_study.hpp"
#include "experiments/honesty_study.hpp"

namespace setsquare::experiments {

/// What to run, on how many threads.
struct PaperExperimentParams {
  std::vector<std::string> sections = {};  ///< Of paper_section_names; empty for all.
  std::size_t num_threads = 2;
  PeerMatcher icp = {};   ///< The ICP compared with ours in section 5.1; may be empty.
  bool is_quick = false;  ///< A few seeds of everything, to see whether it works.
};

/// "section_5_1", "buildings", "factors", "section_5_2", "honesty": the order of the page.
[[nodiscard]] const std::vector<std::string>& paper_section_names();

/// Called as a section goes on: its name, tasks done, tasks in all.
using SectionProgress = std::function<void(std::string_view, std::size_t, std::size_t)>;

/// What was run; what was not is empty.
struct PaperExperiment {
  std::optional<HallwayStudy> hallways;
  std::optional<BuildingStudy> buildings;
  std::optional<FactorStudy> factors;
  std::optional<CircuitStudy> circuits;
  std::optional<HonestyStudy> honesty;
  /// Wall time of each section and of all, median times of a match; everything else depends on
  /// nothing but the seeds.
  Json timing;
};

/// Runs the sections. Throws ParameterError where a name is not in paper_section_names.
[[nodiscard]] PaperExperiment run_paper_experiment(const PaperExperimentParams& params,
                                                   const SectionProgress& progress = {});

/// All numbers; "timing" is the only part that differs from run to run.
[[nodiscard]] std::string paper_json(const PaperExperiment& experiment);
/// The page of web/ with these numbers in it: one file that needs no other, nor a network.
[[nodiscard]] std::string paper_html(const PaperExperiment& experiment);
/// The main tables for a terminal.
[[nodiscard]] std::string paper_text(const PaperExperiment& experiment);

}  // namespace setsquare::experiments
