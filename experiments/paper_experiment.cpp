// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper_experiment.hpp"

#include <algorithm>
#include <chrono>

#include "experiments/building_report.hpp"
#include "experiments/building_summary.hpp"
#include "experiments/page_elements.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/drawing/text.hpp"

namespace setsquare::experiments {
namespace {

void check_sections(const std::vector<std::string>& sections) {
  const std::vector<std::string>& known = paper_section_names();
  for (const std::string& name : sections) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    std::string all;
    for (const std::string& one : known) all += (all.empty() ? "" : ", ") + one;
    throw ParameterError("only", "no section \"" + name + "\"; there are " + all);
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
    timing_[name] = {{"wall_s", elapsed.count()}};
  }

  [[nodiscard]] Json& timing() { return timing_; }

 private:
  const PaperExperimentParams& params_;
  const SectionProgress& progress_;
  Json timing_ = Json::object();
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
  PaperExperiment experiment;
  SectionRunner runner(params, progress);
  runner.run("buildings", experiment.buildings, [&](const Progress& tell) {
    return study_buildings({num_seeds(40, 4), {}, {}}, params.num_threads, tell);
  });
  experiment.timing = runner.timing();
  return experiment;
}

std::string paper_json(const PaperExperiment& experiment) {
  Json json;
  if (experiment.buildings) json["buildings"] = json_from(*experiment.buildings);
  json["timing"] = experiment.timing;
  return json.dump(1) + "\n";
}

std::string paper_html(const PaperExperiment& experiment) {
  std::vector<PageSection> sections;
  if (experiment.buildings) {
    sections.push_back(
        {"buildings", "Two hundred buildings", building_html(*experiment.buildings)});
  }
  return page_html("The paper's experiments, reproduced", "", sections);
}

std::string paper_text(const PaperExperiment& experiment) {
  std::string text;
  if (experiment.buildings) text += summary_text(*experiment.buildings);
  return text;
}

}  // namespace setsquare::experiments
