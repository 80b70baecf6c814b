// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/map/map_verdict.hpp"

#include <gtest/gtest.h>

namespace setsquare::map_verdict_test {

Map audited(const AuditReport& audit) {
  Map map;
  map.audit = audit;
  return map;
}

TEST(MapVerdict, IsNothingWhereTheMapWasNotAudited) { EXPECT_EQ(map_verdict({}), ""); }

TEST(MapVerdict, IsConsistentWhereMatchesAgree) {
  EXPECT_EQ(map_verdict(audited({.num_pairs = 9, .num_matched = 7, .num_agreeing = 7})),
            "consistent (7 of 7 independent matches agree)");
}

TEST(MapVerdict, IsUnconfirmedWhereNoMatchAgrees) {
  EXPECT_EQ(map_verdict(audited({.num_pairs = 9})),
            "unconfirmed (none of 9 pairs of scans could be matched)");
  EXPECT_EQ(map_verdict(audited({.num_pairs = 9, .num_matched = 1, .num_contradicting = 1})),
            "unconfirmed (0 of 1 independent matches agree, 1 of places that look alike do not)");
}

TEST(MapVerdict, IsDoubtfulWhereThereAreDoubts) {
  Map map = audited({.num_pairs = 9, .num_matched = 7, .num_agreeing = 7});
  map.doubts.resize(1);
  EXPECT_EQ(map_verdict(map), "doubtful in 1 place (7 of 7 independent matches agree)");
  map.doubts.resize(2);
  EXPECT_EQ(map_verdict(map), "doubtful in 2 places (7 of 7 independent matches agree)");
}

}  // namespace setsquare::map_verdict_test
