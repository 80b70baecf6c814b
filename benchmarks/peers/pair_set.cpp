// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/peers/pair_set.hpp"

#include "apps/setsquare/scans/scans_at_stamps.hpp"
#include "setsquare/io/tables/relations.hpp"

namespace setsquare::peers {

std::vector<ScanPair> read_pair_set(const std::string& log_path,
                                    const std::string& relations_path) {
  const std::vector<Relation> relations = read_relations(relations_path);
  std::vector<Timestamp> stamps;
  for (const Relation& relation : relations) {
    stamps.push_back(relation.reference_stamp);
    stamps.push_back(relation.current_stamp);
  }
  const auto scans = app::scans_at_stamps(log_path, {}, stamps);
  std::vector<ScanPair> pairs;
  pairs.reserve(relations.size());
  for (const Relation& relation : relations) {
    pairs.push_back({scans.at(relation.reference_stamp),
                     scans.at(relation.current_stamp),
                     relation.T_reference_current});
  }
  return pairs;
}

}  // namespace setsquare::peers
