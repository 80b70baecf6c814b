// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/preset.hpp"

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <map>

#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/paper/paper_matcher.hpp"

namespace setsquare::app {

void add_preset_option(CLI::App& subcommand, Preset& preset) {
  static const std::map<std::string, Preset> kNames{{"default", Preset::kDefault},
                                                    {"paper", Preset::kPaper}};
  subcommand.add_option("--preset", preset, "default, or paper: Bando et al. 2014 as printed")
      ->transform(CLI::Transformer(kNames, CLI::ignore_case).description(""))
      ->type_name("default|paper");
}

void add_frame_option(CLI::App& subcommand, bool& is_of_sensor) {
  static const std::map<std::string, bool> kNames{{"base", false}, {"sensor", true}};
  subcommand.add_option("--frame", is_of_sensor, "Poses of the robot (base) or of the sensor")
      ->transform(CLI::Transformer(kNames, CLI::ignore_case).description(""))
      ->type_name("base|sensor");
}

MatchResult match_by(Preset preset, const Scan& reference, const Scan& current) {
  return preset == Preset::kPaper ? match_paper(reference, current) : match(reference, current);
}

}  // namespace setsquare::app
