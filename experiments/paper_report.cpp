// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "experiments/building_report.hpp"
#include "experiments/building_summary.hpp"
#include "experiments/circuit_report.hpp"
#include "experiments/factor_report.hpp"
#include "experiments/goals.hpp"
#include "experiments/hallway_report.hpp"
#include "experiments/honesty_report.hpp"
#include "experiments/page_elements.hpp"
#include "experiments/paper_experiment.hpp"
#include "setsquare/drawing/text.hpp"

namespace setsquare::experiments {
namespace {

constexpr std::string_view kTitle =
    "Scan matching in the dominant direction: the experiments again";

Cell verdict(const Goal& goal) {
  if (!goal.is_known) return {"not run", "faint"};
  if (goal.meets_aim) return {"aim", "good"};
  return goal.meets_must ? Cell{"must", "good"} : Cell{"missed", "bad"};
}

std::string introduction_html(const PaperExperiment& experiment) {
  std::string html = paragraph(
      "Section 5 of Bando, Tsubouchi and Yuta, Scan matching method using projection in dominant "
      "direction of indoor environment (Advanced Robotics 28(18), 2014), in simulated buildings: "
      "their method, ICP, and Setsquare's default matcher, side by side. Every figure comes from "
      "seeds; the matchers never see the simulator, and the floor plan alone decides what a pair "
      "of scans can tell. All numbers are in paper.json.");
  html += command_line("setsquare experiment paper -o out");
  Table table{"What was to be reached, and what was",
              {"", "the paper states", "must", "aim", "reached", ""},
              {}};
  std::vector<Goal> goals = goals_of(experiment);
  goals.push_back(time_goal(experiment));
  for (const Goal& goal : goals) {
    table.rows.push_back({{goal.what},
                          {goal.paper, "faint"},
                          {goal.must},
                          {goal.aim},
                          {goal.reached},
                          verdict(goal)});
  }
  return html + table_html(table);
}

Json json_from(const Goal& goal) {
  Json json = {{"what", goal.what},
               {"paper", goal.paper},
               {"must", goal.must},
               {"aim", goal.aim},
               {"reached", goal.reached}};
  if (goal.is_known) {
    json["meets_must"] = goal.meets_must;
    json["meets_aim"] = goal.meets_aim;
  }
  return json;
}

}  // namespace

std::string paper_json(const PaperExperiment& experiment) {
  Json json;
  Json goals = Json::array();
  for (const Goal& goal : goals_of(experiment)) goals.push_back(json_from(goal));
  json["goals"] = goals;
  if (experiment.hallways) json["section_5_1"] = json_from(*experiment.hallways);
  if (experiment.buildings) json["buildings"] = json_from(*experiment.buildings);
  if (experiment.factors) json["factors"] = json_from(*experiment.factors);
  if (experiment.circuits) json["section_5_2"] = json_from(*experiment.circuits);
  if (experiment.honesty) json["honesty"] = json_from(*experiment.honesty);
  json["timing"] = experiment.timing;
  return json.dump(1) + "\n";
}

std::string paper_html(const PaperExperiment& experiment) {
  std::vector<PageSection> sections;
  const auto add = [&](const char* anchor, const char* title, const std::string& content) {
    sections.push_back({anchor, title, content});
  };
  if (experiment.hallways) {
    add("section_5_1",
        "Section 5.1: pairs of scans in a hallway",
        hallway_html(*experiment.hallways));
  }
  if (experiment.buildings) {
    add("buildings", "Pairs of scans in many buildings", building_html(*experiment.buildings));
  }
  if (experiment.factors) {
    add("factors", "One factor at a time", factor_html(*experiment.factors));
  }
  if (experiment.circuits) {
    add("section_5_2",
        "Section 5.2: a large building, scan to scan",
        circuit_html(*experiment.circuits));
  }
  if (experiment.honesty) {
    add("honesty", "Where the scans do not tell", honesty_html(*experiment.honesty));
  }
  return page_html(kTitle, introduction_html(experiment), sections);
}

std::string paper_text(const PaperExperiment& experiment) {
  std::string text;
  if (experiment.hallways) text += hallway_text(*experiment.hallways) + "\n";
  if (experiment.buildings) text += summary_text(*experiment.buildings) + "\n";
  if (experiment.factors) text += factor_text(*experiment.factors) + "\n";
  if (experiment.circuits) text += circuit_text(*experiment.circuits) + "\n";
  if (experiment.honesty) text += honesty_text(*experiment.honesty) + "\n";
  std::vector<Goal> goals = goals_of(experiment);
  goals.push_back(time_goal(experiment));
  for (const Goal& goal : goals) {
    if (!goal.is_known) continue;
    text += joined({"[", verdict(goal).words, "] ", goal.what, ": ", goal.reached, "\n"});
  }
  char line[100];
  std::snprintf(line, sizeof line, "%.1f s\n", experiment.timing.at("all_s").get<double>());
  return text + line;
}

}  // namespace setsquare::experiments
