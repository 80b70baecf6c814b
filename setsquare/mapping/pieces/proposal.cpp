// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/pieces/proposal.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace setsquare {

double places_in(const std::vector<Proposal>& proposals) {
  std::set<std::size_t> places;
  for (const Proposal& proposal : proposals) places.insert(proposal.sought);
  return static_cast<double>(places.size());
}

double places_seen_in(const std::vector<Proposal>& proposals) {
  constexpr double kNoPlace = 0.1;  // So much is contradicted at most (ClosureVerdictParams).
  std::map<std::size_t, double> places;
  for (const Proposal& proposal : proposals) {
    double& place = places[proposal.sought];
    place = std::max(place, 1.0 - proposal.places.contradiction / kNoPlace);
  }
  double sum = 0.0;
  for (const auto& [place, votes] : places) sum += votes;
  return sum;
}

double weight_in(const std::vector<Proposal>& proposals) {
  double sum = 0.0;
  for (const Proposal& proposal : proposals) sum += proposal.weight;
  return sum;
}

double surest_in(const std::vector<Proposal>& proposals) {
  double surest = 0.0;
  for (const Proposal& proposal : proposals) surest = std::max(surest, proposal.weight);
  return surest;
}

}  // namespace setsquare
