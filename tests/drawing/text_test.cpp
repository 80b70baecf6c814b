// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/drawing/text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace setsquare::text_test {

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
  EXPECT_EQ(escape_xml("\x01\x1b\xc3\xa9 ok\n"), "\xef\xbf\xbd\xef\xbf\xbd\xc3\xa9 ok\n");
  EXPECT_EQ(escape_xml(""), "");
}

TEST(Text, KeepsWhatIsUtf8) {
  for (const char* text :
       {"B\xc3\xbcro_\xe6\x97\xa5\xe6\x9c\xac.clf", "\xf0\x9f\x97\xba", "\xef\xbf\xbc"}) {
    EXPECT_EQ(escape_xml(text), text);
  }
}

TEST(Text, WhatIsNoUtf8BecomesTheReplacementCharacter) {
  const std::string mark = "\xef\xbf\xbd";
  EXPECT_EQ(escape_xml("B\xfcro"), "B" + mark + "ro");  // Latin-1
  EXPECT_EQ(escape_xml("\xc3"), mark);                  // cut off
  EXPECT_EQ(escape_xml("\xc0\xaf"), mark + mark);       // longer than it must be
  EXPECT_EQ(escape_xml("\xe0\x80\xaf"), mark + mark + mark);
  EXPECT_EQ(escape_xml("\xed\xa0\x80"), mark + mark + mark);             // a surrogate
  EXPECT_EQ(escape_xml("\xf4\x90\x80\x80"), mark + mark + mark + mark);  // beyond Unicode
  EXPECT_EQ(escape_xml("\xef\xbf\xbf"), mark + mark + mark);             // XML 1.0 forbids U+FFFF
  EXPECT_EQ(escape_xml("\xc2\x85\x7f\t"), mark + mark + mark + mark);    // controls
}

}  // namespace setsquare::text_test
