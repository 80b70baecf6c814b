// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The default matcher on pairs of real scans, against the relations of Kuemmerle et al. 2009: no
// initial guess, one parameter set. Skips where the logs are absent.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "setsquare/io/logs/open_log.hpp"
#include "setsquare/io/tables/relations.hpp"
#include "setsquare/matching/base_frame.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "tests/support/data_dir.hpp"

namespace setsquare::match_real_logs_test {

using testing::data_file;

/// Counts over one class of pairs. Success and tight are those of the best proposal, whatever the
/// status: 0.2 m and 30 deg (the paper's), 0.05 m and 1 deg. Wrong: matched, over 0.2 m or 3 deg.
struct Tally {
  int num_pairs = 0;
  int num_success = 0;
  int num_tight = 0;
  int num_matched = 0;
  int num_wrong = 0;

  void add(const MatchResult& result, const Pose2& truth) {
    const Pose2 far{1e9, 0.0, 0.0};
    const Pose2 error = truth.inverse() * result.T_reference_current.value_or(far);
    const auto is_within = [&](double limit_m, double limit_deg) {
      return std::hypot(error.x_m, error.y_m) <= limit_m &&
             std::abs(error.theta_rad) <= rad_from_deg(limit_deg);
    };
    const bool is_matched = result.status == MatchStatus::kMatched;
    ++num_pairs;
    num_success += is_within(0.2, 30.0);
    num_tight += is_within(0.05, 1.0);
    num_matched += is_matched;
    num_wrong += is_matched && !is_within(0.2, 3.0);
  }
  Tally& operator+=(const Tally& other) {
    num_pairs += other.num_pairs;
    num_success += other.num_success;
    num_tight += other.num_tight;
    num_matched += other.num_matched;
    num_wrong += other.num_wrong;
    return *this;
  }
};

double percent(int count, int total) { return 100.0 * count / total; }

void tell(const std::string& name, const Tally& tally) {
  std::cout << name << ": " << tally.num_pairs << " pairs, success "
            << percent(tally.num_success, tally.num_pairs) << " %, tight "
            << percent(tally.num_tight, tally.num_pairs) << " %, matched "
            << percent(tally.num_matched, tally.num_pairs) << " %, wrong " << tally.num_wrong
            << "\n";
}

/// The pairs of one log by class.
struct LogTallies {
  Tally local;
  Tally loop_high;    ///< Overlap of 45 % and more.
  Tally loop_middle;  ///< From 20 to 45 %.
  Tally loop_low;
};

class PairSets {
 public:
  /// Nothing where a file is absent.
  static std::optional<LogTallies> match_log(const std::string& name) {
    const auto log = data_file(name + "/" + name + ".clf");
    const auto local = data_file(name + "/" + name + ".local.relations");
    const auto loop = data_file(name + "/" + name + ".loop.relations");
    const auto overlap = data_file(name + "/" + name + ".loop.overlap");
    if (!log || !local || !loop || !overlap) return std::nullopt;
    const auto local_relations = read_relations(*local);
    const auto loop_relations = read_relations(*loop);
    const auto overlaps = read_overlaps(*overlap);
    PairSets pairs(*log, {&local_relations, &loop_relations});
    LogTallies tallies;
    for (const Relation& relation : local_relations) pairs.match(relation, tallies.local);
    EXPECT_EQ(overlaps.size(), loop_relations.size());
    for (std::size_t i = 0; i < loop_relations.size(); ++i) {
      const double share = overlaps.at(i).overlap;
      pairs.match(loop_relations[i],
                  share >= 0.45   ? tallies.loop_high
                  : share >= 0.20 ? tallies.loop_middle
                                  : tallies.loop_low);
    }
    return tallies;
  }

 private:
  PairSets(const std::string& log, std::initializer_list<const std::vector<Relation>*> sets) {
    for (const auto* relations : sets) {
      for (const Relation& relation : *relations) {
        scans_[relation.reference_stamp] = {};
        scans_[relation.current_stamp] = {};
      }
    }
    const auto reader = open_log(log);
    while (const LogRecord* record = reader->next()) {
      // Relations round the log's stamps.
      const auto near = scans_.lower_bound(Timestamp{record->stamp.ns - 20'000});
      if (near != scans_.end() && near->first.ns <= record->stamp.ns + 20'000) {
        near->second = record->scan;
      }
    }
  }

  void match(const Relation& relation, Tally& tally) const {
    const Scan& reference = scans_.at(relation.reference_stamp);
    const Scan& current = scans_.at(relation.current_stamp);
    ASSERT_GT(reference.num_beams(), 0U) << "no scan with stamp " << to_string(reference.stamp);
    ASSERT_GT(current.num_beams(), 0U) << "no scan with stamp " << to_string(current.stamp);
    tally.add(
        match_result_of_base(
            setsquare::match(reference, current), reference.T_base_sensor, current.T_base_sensor),
        relation.T_reference_current);
  }

  std::map<Timestamp, Scan> scans_;
};

struct LogTargets {
  const char* name;
  double min_tight_percent;  ///< Of local pairs; the truth's own noise bounds it.
};

// The targets are those that the matcher was built to reach, the same for every log but the tight
// share; they bound what the classes hold together, so one test matches every pair once.
TEST(MatchRealLogs, ReachTheirTargets) {
  Tally all;
  Tally loop_high;
  Tally loop_middle;
  for (const LogTargets& log : {LogTargets{"intel", 96.0}, {"aces", 77.0}, {"fr079", 91.0}}) {
    SCOPED_TRACE(log.name);
    const auto tallies = PairSets::match_log(log.name);
    if (!tallies) GTEST_SKIP() << log.name << ": no data folder";
    const std::string name = log.name;
    const Tally& local = tallies->local;
    const Tally& high = tallies->loop_high;
    tell(name + " local", local);
    tell(name + " loop, overlap >= 45 %", high);
    tell(name + " loop, overlap 20-45 %", tallies->loop_middle);
    tell(name + " loop, overlap < 20 %", tallies->loop_low);
    EXPECT_GE(percent(local.num_success, local.num_pairs), 99.5);
    EXPECT_GE(percent(local.num_tight, local.num_pairs), log.min_tight_percent);
    EXPECT_GE(percent(local.num_matched, local.num_pairs), 93.0);
    EXPECT_GE(percent(high.num_matched, high.num_pairs), 85.0);
    loop_high += high;
    loop_middle += tallies->loop_middle;
    ((all += local) += high) += tallies->loop_middle;
    all += tallies->loop_low;
  }
  tell("all", all);
  EXPECT_EQ(all.num_pairs, 1079);
  EXPECT_GE(percent(loop_high.num_success, loop_high.num_pairs), 99.0);
  EXPECT_GE(percent(loop_middle.num_success, loop_middle.num_pairs), 80.0);
  EXPECT_LE(percent(all.num_wrong, all.num_matched), 0.25);
}

}  // namespace setsquare::match_real_logs_test
