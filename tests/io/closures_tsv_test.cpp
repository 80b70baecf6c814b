// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/tables/closures_tsv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "setsquare/core/error.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::closures_tsv_test {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const std::string kHeader =
    "stamp_i\tstamp_j\tx_m\ty_m\ttheta_rad\taxes\taccepted\tweight\treason\n";
const std::string kRow = "1.500000\t2.000000\t0.1\t-2\t3.14\txy\t1\t0.5\tit fits\n";

std::vector<LoopClosure> read(const std::string& text) {
  return read_closures_tsv(make_memory_source(text), "x.tsv");
}

std::string error_of(const std::string& text) {
  try {
    static_cast<void>(read(text));
  } catch (const FormatError& error) {
    return error.what();
  }
  return {};
}

TEST(ClosuresTsv, IsTheTableThatItsHeaderDescribes) {
  const std::vector<LoopClosure> closures = {
      {{1'500'000'000}, {2'000'000'000}, {0.1, -2.0, 3.14}, ClosureAxes::kXY, true, 0.5, "it fits"},
      {{-1'000}, {976052857'337530'000}, {0.0, 1e-9, 0.0}, ClosureAxes::kX, false, 0.0, ""},
      {{3'000'000'000}, {4'000'000'000}, {1, 2, 3}, ClosureAxes::kY, true, 1.0, "a\tb\nc"}};
  EXPECT_EQ(tsv_from_closures(closures),
            kHeader + kRow + "-0.000001\t976052857.337530\t0\t1e-09\t0\tx\t0\t0\t\n" +
                "3.000000\t4.000000\t1\t2\t3\ty\t1\t1\ta b c\n");
}

TEST(ClosuresTsv, ReadsBackWhatWasWritten) {
  auto generator = testing::make_generator();
  std::vector<LoopClosure> closures;
  for (int i = 0; i < 200; ++i) {
    closures.push_back({{static_cast<std::int64_t>(generator() % 1'000'000'000'000) * 1'000},
                        {static_cast<std::int64_t>(generator() % 1'000'000'000'000) * 1'000},
                        {testing::uniform(generator, -1e3, 1e3),
                         testing::uniform(generator, -1e-7, 1e-7),
                         testing::uniform(generator, -4.0, 4.0)},
                        static_cast<ClosureAxes>(i % 3),
                        i % 2 == 0,
                        testing::uniform(generator, 0.0, 1.0),
                        std::string(static_cast<std::size_t>(i % 4), 'r')});
  }
  const auto again = read(tsv_from_closures(closures));
  ASSERT_THAT(again, SizeIs(closures.size()));
  for (std::size_t i = 0; i < closures.size(); ++i) {
    EXPECT_EQ(again[i].stamp_i, closures[i].stamp_i);
    EXPECT_EQ(again[i].stamp_j, closures[i].stamp_j);
    EXPECT_EQ(again[i].T_i_j, closures[i].T_i_j) << "to the last bit";
    EXPECT_EQ(again[i].axes, closures[i].axes);
    EXPECT_EQ(again[i].is_accepted, closures[i].is_accepted);
    EXPECT_EQ(again[i].weight, closures[i].weight);
    EXPECT_EQ(again[i].reason, closures[i].reason);
  }
}

TEST(ClosuresTsv, AMapWithoutClosuresIsNoDamage) {
  EXPECT_THAT(read(tsv_from_closures({})), IsEmpty());
  EXPECT_THAT(read("\n" + kHeader + "\r\n"), IsEmpty());
}

TEST(ClosuresTsv, ADamagedLineIsNamed) {
  EXPECT_THAT(error_of(""), HasSubstr("x.tsv: no header"));
  EXPECT_THAT(error_of(kRow), HasSubstr("x.tsv, line 1: expected the header"));
  const auto error_of_row = [](const std::string& row) { return error_of(kHeader + kRow + row); };
  for (const char* const row : {"1.5\t2\t0.1\t-2\t3\txy\t1\t0.5\n",            // no reason
                                "1.5\t2\t0.1\t-2\t3\txy\t1\t0.5\ta\tb\n",      // ten cells
                                "1.5 2 0.1 -2 3 xy 1 0.5 fits\n",              // blanks
                                "x\t2\t0.1\t-2\t3\txy\t1\t0.5\tfits\n",        // stamp
                                "1.5\t9e9\t0.1\t-2\t3\txy\t1\t0.5\tfits\n",    // stamp
                                "1.5\t2\tnan\t-2\t3\txy\t1\t0.5\tfits\n",      // number
                                "1.5\t2\t0.1 1\t-2\t3\txy\t1\t0.5\tfits\n",    // two numbers
                                "1.5\t2\t0.1\t-2\tinf\txy\t1\t0.5\tfits\n",    // number
                                "1.5\t2\t0.1\t-2\t3\tyx\t1\t0.5\tfits\n",      // axes
                                "1.5\t2\t0.1\t-2\t3\txy\tyes\t0.5\tfits\n",    // accepted
                                "1.5\t2\t0.1\t-2\t3\txy\t1\t1.5\tfits\n",      // weight
                                "1.5\t2\t0.1\t-2\t3\txy\t1\t-0.5\tfits\n"}) {  // weight
    EXPECT_THAT(error_of_row(row), HasSubstr("x.tsv, line 3: expected")) << row;
  }
  EXPECT_EQ(error_of_row("1.5\t2\t0.1\t-2\t3\txy\t1\t0.5\tfits\r\n"), "");
}

TEST(ClosuresTsv, AMissingFileIsNamed) {
  EXPECT_THROW(static_cast<void>(read_closures_tsv("/no/such.tsv")), FileError);
}

}  // namespace setsquare::closures_tsv_test
