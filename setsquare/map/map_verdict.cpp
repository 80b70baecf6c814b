// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/map/map_verdict.hpp"

namespace setsquare {
namespace {

std::string matches_of(const AuditReport& audit) {
  if (audit.num_matched == 0) {
    return "none of " + std::to_string(audit.num_pairs) + " pairs of scans could be matched";
  }
  std::string text = std::to_string(audit.num_agreeing) + " of " +
                     std::to_string(audit.num_matched) + " independent matches agree";
  const std::size_t num_alone = audit.num_contradicting - audit.num_seconded;
  if (num_alone > 0) text += ", " + std::to_string(num_alone) + " of places that look alike do not";
  return text;
}

}  // namespace

std::string map_verdict(const Map& map) {
  if (!map.audit) return {};
  const std::string matches = " (" + matches_of(*map.audit) + ")";
  const std::size_t num_doubts = map.doubts.size();
  if (num_doubts > 0) {
    return "doubtful in " + std::to_string(num_doubts) + (num_doubts == 1 ? " place" : " places") +
           matches;
  }
  return (map.audit->num_agreeing > 0 ? "consistent" : "unconfirmed") + matches;
}

}  // namespace setsquare
