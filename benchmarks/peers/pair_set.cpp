// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/peers/pair_set.hpp"

#include <algorithm>
#include <cstdint>
#include <map>

#include "setsquare/core/error.hpp"
#include "setsquare/io/open_log.hpp"
#include "setsquare/io/relations.hpp"

namespace setsquare::peers {
namespace {

/// Relations round their stamps to 10 microseconds.
constexpr std::int64_t kStampSlack_ns = 10'000;

using ScansByStamp = std::map<Timestamp, Scan>;

ScansByStamp::iterator find_near(ScansByStamp& scans, Timestamp stamp) {
  const auto found = scans.lower_bound({stamp.ns - kStampSlack_ns});
  const bool is_near = found != scans.end() && found->first.ns <= stamp.ns + kStampSlack_ns;
  return is_near ? found : scans.end();
}

/// The scans of a log whose stamps the relations name.
ScansByStamp read_named_scans(const std::string& log_path, const std::vector<Relation>& relations) {
  ScansByStamp scans;
  for (const Relation& relation : relations) {
    scans[relation.reference_stamp] = {};
    scans[relation.current_stamp] = {};
  }
  const auto reader = open_log(log_path);
  while (const LogRecord* record = reader->next()) {
    const auto found = find_near(scans, record->stamp);
    if (found != scans.end()) found->second = record->scan;
  }
  return scans;
}

}  // namespace

std::vector<ScanPair> read_pair_set(const std::string& log_path,
                                    const std::string& relations_path) {
  const std::vector<Relation> relations = read_relations(relations_path);
  const ScansByStamp scans = read_named_scans(log_path, relations);
  std::vector<ScanPair> pairs;
  pairs.reserve(relations.size());
  for (const Relation& relation : relations) {
    const Scan& reference = scans.at(relation.reference_stamp);
    const Scan& current = scans.at(relation.current_stamp);
    if (reference.num_beams() == 0 || current.num_beams() == 0) {
      throw FormatError(relations_path, "", "names a stamp that is not in " + log_path);
    }
    pairs.push_back({reference, current, relation.T_reference_current});
  }
  return pairs;
}

}  // namespace setsquare::peers
