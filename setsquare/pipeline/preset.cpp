// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/pipeline/preset.hpp"

#include "setsquare/core/error.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/paper/paper_matcher.hpp"

namespace setsquare {

Preset preset_from(std::string_view name) {
  if (name == "default") return Preset::kDefault;
  if (name == "paper") return Preset::kPaper;
  throw ParameterError("preset", "must be \"default\" or \"paper\"");
}

MatchResult match_by(Preset preset, const Scan& reference, const Scan& current) {
  return preset == Preset::kPaper ? match_paper(reference, current) : match(reference, current);
}

}  // namespace setsquare
