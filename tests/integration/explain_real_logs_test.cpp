// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The account of a verdict by `explain`, against the verdict itself, on real scans. Skips where the
// logs are absent.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <variant>
#include <vector>

#include "setsquare/io/logs/open_log.hpp"
#include "setsquare/report/match/story/story.hpp"
#include "setsquare/report/match/story/verdict_rules.hpp"
#include "tests/support/data_dir.hpp"

namespace setsquare::explain_real_logs_test {

std::vector<Scan> first_scans(const std::string& path, std::size_t count) {
  std::vector<Scan> scans;
  const auto log = open_log(path);
  while (scans.size() < count) {
    const LogRecord* record = log->next();
    if (record == nullptr) break;
    scans.push_back(record->scan);
  }
  return scans;
}

TEST(ExplainOnRealLogs, TheRulesComeToTheMatchersOwnVerdict) {
  std::set<MatchStatus> met;
  for (const char* name : {"intel/intel.clf", "aces/aces.clf"}) {
    const auto path = testing::data_file(name);
    if (!path) GTEST_SKIP() << name << " is absent (SETSQUARE_DATA_DIR)";
    const std::vector<Scan> scans = first_scans(path->string(), 1000);
    for (std::size_t i = 0; i + 150 < scans.size(); i += 85) {
      for (const std::size_t apart : {5, 40, 150}) {
        const MatchStory story = tell_default_match(scans[i], scans[i + apart], {});
        const auto& looked_at = std::get<SurfaceEvidence>(story.looked_at);
        EXPECT_EQ(to_string(status_of_rules(looked_at.rules)), to_string(story.result.status))
            << name << ": " << i << " and " << i + apart;
        met.insert(story.result.status);
      }
    }
  }
  EXPECT_GE(met.size(), 3U);  // matched, ambiguous, degenerate
}

}  // namespace setsquare::explain_real_logs_test
