// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/faults/findings_json.hpp"

#include <gtest/gtest.h>

namespace setsquare::findings_json_test {

TEST(FindingsJson, WhatIsWrittenIsReadAgain) {
  std::vector<LogFinding> findings;
  for (int kind = 0; kind <= static_cast<int>(FindingKind::kDamagedRecords); ++kind) {
    findings.push_back({.kind = static_cast<FindingKind>(kind),
                        .sentence = "laser \"" + std::to_string(kind) + "\" is odd",
                        .share = {},
                        .option = kind % 2 == 0 ? "" : "--mend " + std::to_string(kind)});
    if (kind % 3 == 0) findings.back().share = 0.25;
  }
  const std::vector<LogFinding> read = findings_from_json(findings_json(findings));
  ASSERT_EQ(read.size(), findings.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].kind, findings[i].kind);
    EXPECT_EQ(read[i].share, findings[i].share);
    EXPECT_EQ(text_of(read[i]), text_of(findings[i]));
  }
}

TEST(FindingsJson, WhatIsNoArrayOfFindingsGivesNone) {
  for (const char* text : {"", "{}", "[", "null", "[1, null, \"a\"]"}) {
    EXPECT_TRUE(findings_from_json(text).empty()) << text;
  }
  const auto read = findings_from_json(R"([{"kind": "of_later", "sentence": 3, "share": "x"}])");
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].kind, FindingKind::kRemark);
  EXPECT_EQ(read[0].sentence, "");
}

}  // namespace setsquare::findings_json_test
