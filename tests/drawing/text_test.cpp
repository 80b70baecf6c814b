// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/drawing/text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace setsquare {
namespace {

TEST(Text, FixedDecimals) {
  EXPECT_EQ(fixed(3.14159, 2), "3.14");
  EXPECT_EQ(fixed(-0.5, 1), "-0.5");
  EXPECT_EQ(fixed(1e20, 0), "100000000000000000000");
  EXPECT_EQ(fixed(std::nan(""), 2), "nan");
  EXPECT_EQ(fixed(std::numeric_limits<double>::infinity(), 2), "inf");
  EXPECT_EQ(fixed(std::numeric_limits<double>::max(), 9).size(), 309U + 10U);
}

TEST(Text, ZeroHasNoSign) {
  EXPECT_EQ(fixed(-0.001, 2), "0.00");
  EXPECT_EQ(fixed(-0.0, 0), "0");
  EXPECT_EQ(fixed(-0.01, 2), "-0.01");
}

TEST(Text, EscapesWhatXmlReserves) {
  EXPECT_EQ(escape_xml("a < b && c > \"d\" 'e'"),
            "a &lt; b &amp;&amp; c &gt; &quot;d&quot; &#39;e&#39;");
  EXPECT_EQ(escape_xml("\x01\x1b\xc3\xa9 ok\n"), "???? ok\n");
  EXPECT_EQ(escape_xml(""), "");
}

TEST(Text, JoinsPieces) { EXPECT_EQ(joined({"a", "", "bc"}), "abc"); }

}  // namespace
}  // namespace setsquare
