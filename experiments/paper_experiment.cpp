// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper_experiment.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>

#include "experiments/goals.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/core/joined.hpp"

namespace setsquare::experiments {
namespace {

void check_sections(const std::vector<std::string>& sections) {
  const std::vector<std::string>& known = paper_section_names();
  for (const std::string& name : sections) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw ParameterError("only",
                         fmt::format("no section \"{}\"; there are {}", name, joined(known)));
  }
}

/// Runs sections one after the other and keeps their times.
class SectionRunner {
 public:
  SectionRunner(const PaperExperimentParams& params, const SectionProgress& progress)
      : params_(params), progress_(progress) {}

  template <typename Result, typename Study>
  void run(const std::string& name, std::optional<Result>& result, const Study& study) {
    const auto& wanted = params_.sections;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), name) == wanted.end()) return;
    const auto start = std::chrono::steady_clock::now();
    result = study([&](std::size_t num_done, std::size_t num_tasks) {
      if (progress_) progress_(name, num_done, num_tasks);
    });
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    timing_[name + "_s"] = elapsed.count();
    all_s_ += elapsed.count();
  }

  /// Wall time of each section and of all, in s.
  [[nodiscard]] Json timing() const {
    Json timing = timing_;
    timing["all_s"] = all_s_;
    return timing;
  }

 private:
  const PaperExperimentParams& params_;
  const SectionProgress& progress_;
  Json timing_ = Json::object();
  double all_s_ = 0.0;
};

}  // namespace

const std::vector<std::string>& paper_section_names() {
  static const std::vector<std::string> names = {
      "section_5_1", "buildings", "factors", "section_5_2", "honesty"};
  return names;
}

PaperExperiment run_paper_experiment(const PaperExperimentParams& params,
                                     const SectionProgress& progress) {
  check_sections(params.sections);
  const auto num_seeds = [&](std::size_t full, std::size_t quick) {
    return params.is_quick ? quick : full;
  };
  const std::size_t num_threads = params.num_threads;
  PaperExperiment experiment;
  SectionRunner runner(params, progress);
  runner.run("section_5_1", experiment.hallways, [&](const Progress& progressed) {
    HallwayStudyParams hallways;
    hallways.num_seeds = num_seeds(20, 2);
    return study_hallways(hallways, params.icp, num_threads, progressed);
  });
  runner.run("buildings", experiment.buildings, [&](const Progress& progressed) {
    return study_buildings({num_seeds(40, 4), {}, {}}, num_threads, progressed);
  });
  runner.run("factors", experiment.factors, [&](const Progress& progressed) {
    return study_factors(num_seeds(40, 4), num_threads, progressed);
  });
  runner.run("section_5_2", experiment.circuits, [&](const Progress& progressed) {
    CircuitStudyParams circuits;
    circuits.num_seeds = num_seeds(20, 1);
    return study_circuits(circuits, num_threads, progressed);
  });
  runner.run("honesty", experiment.honesty, [&](const Progress& progressed) {
    return study_honesty({num_seeds(20, 2), 9}, num_threads, progressed);
  });
  experiment.timing = runner.timing();
  if (experiment.hallways) {
    experiment.timing["a_match"] = json_from(experiment.hallways->times);
  }
  return experiment;
}

std::string paper_json(const PaperExperiment& experiment) {
  Json json;
  json["goals"] = json_from(goals_of(experiment));
  if (experiment.hallways) json["section_5_1"] = json_from(*experiment.hallways);
  if (experiment.buildings) json["buildings"] = json_from(*experiment.buildings);
  if (experiment.factors) json["factors"] = json_from(*experiment.factors);
  if (experiment.circuits) json["section_5_2"] = json_from(*experiment.circuits);
  if (experiment.honesty) json["honesty"] = json_from(*experiment.honesty);
  json["timing"] = experiment.timing;
  return json.dump(1) + "\n";
}

}  // namespace setsquare::experiments
