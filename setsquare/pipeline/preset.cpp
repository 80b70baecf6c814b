// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/pipeline/preset.hpp"

#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/paper/paper_matcher.hpp"

namespace setsquare {

MatchResult match_by(Preset preset, const Scan& reference, const Scan& current) {
  return preset == Preset::kPaper ? match_paper(reference, current) : match(reference, current);
}

}  // namespace setsquare
