// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bytes/byte_source.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bytes/input_buffer.hpp"
#include "tests/io/packing.hpp"
#include "tests/io/read_all.hpp"
#include "tests/support/seed.hpp"
#include "tests/support/temporary_folder.hpp"

namespace setsquare::byte_source_test {

std::string read_rest(ByteSource& source) {
  std::string bytes;
  std::string block(777, '\0');
  while (const std::size_t num_read = source.read(block)) bytes.append(block, 0, num_read);
  return bytes;
}

TEST(FileSource, SaysWhyAFileCannotBeRead) {
  EXPECT_THROW(static_cast<void>(open_file_source("/no/such/file")), FileError);
  const auto directory = open_file_source("/");
  std::string block(10, '\0');
  EXPECT_THROW(static_cast<void>(directory->read(block)), FileError);
}

/// The same bytes from each kind of source.
class EverySource : public ::testing::Test {
 protected:
  using Open = std::function<std::unique_ptr<ByteSource>()>;

  EverySource() {
    const std::string path = (folder_.path() / "bytes").string();
    std::ofstream(path, std::ios::binary) << text_;
    const std::string packed_path = (folder_.path() / "packed").string();
    std::ofstream(packed_path, std::ios::binary) << testing::pack_zstd(text_);
    kinds_ = {[this] { return make_memory_source(text_); },
              [this] { return std::make_unique<testing::TricklingSource>(text_, 1000); },
              [path] { return open_file_source(path); },
              [path] { return unpack(open_file_source(path)); },
              [packed_path] { return unpack(open_file_source(packed_path)); }};
  }

  testing::TemporaryFolder folder_;
  std::string text_ = testing::long_text(60000);
  std::vector<Open> kinds_;
};

TEST_F(EverySource, SkipsAsIfItHadRead) {
  for (const Open& open : kinds_) {
    for (const std::size_t num_bytes : {std::size_t{0}, std::size_t{3}, std::size_t{300000}}) {
      const auto source = open();
      EXPECT_EQ(source->skip(num_bytes), num_bytes);
      EXPECT_TRUE(read_rest(*source) == text_.substr(num_bytes));
    }
  }
}

TEST_F(EverySource, SkipsNotBeyondTheEnd) {
  for (const Open& open : kinds_) {
    for (const std::uint64_t lie : {text_.size() + 0UL, text_.size() + 1UL, ~0UL}) {
      const auto source = open();
      EXPECT_EQ(source->skip(5), 5U);
      EXPECT_EQ(source->skip(lie), text_.size() - 5);
      EXPECT_EQ(source->skip(lie), 0U);
      EXPECT_EQ(read_rest(*source), "");
    }
  }
}

TEST_F(EverySource, TheFractionReadCountsWhatIsSkipped) {
  const auto source = open_file_source((folder_.path() / "bytes").string());
  source->skip(text_.size() / 4);
  EXPECT_NEAR(source->fraction_read().value(), 0.25, 1e-4);
  source->skip(text_.size());
  EXPECT_EQ(source->fraction_read().value(), 1.0);
}

TEST_F(EverySource, AWindowShowsTheSameBytesHoweverItMoves) {
  auto generator = testing::make_generator();
  for (int round = 0; round < 20; ++round) {
    InputBuffer input(kinds_[static_cast<std::size_t>(round) % kinds_.size()]());
    for (std::uint64_t at = 0; at < text_.size();) {
      ASSERT_EQ(input.offset(), at);
      const auto num_bytes = static_cast<std::size_t>(testing::uniform(generator, 0.0, 90000.0));
      const std::size_t num_left = text_.size() - at;
      if (testing::uniform(generator, 0.0, 1.0) < 0.5) {
        ASSERT_EQ(input.skip(num_bytes), std::min(num_bytes, num_left));
      } else {
        ASSERT_EQ(input.ensure(num_bytes), num_bytes <= num_left);
        const std::size_t num_shown = std::min(num_bytes, num_left);
        ASSERT_TRUE(input.available().substr(0, num_shown) == text_.substr(at, num_shown));
        input.consume(num_shown);
      }
      at += std::min(num_bytes, num_left);
    }
    EXPECT_EQ(input.skip(1), 0U);
    EXPECT_FALSE(input.ensure(1));
  }
}

TEST(ByteWindow, EndsWithItsBytes) {
  ByteWindow window("0123456789");
  EXPECT_TRUE(window.ensure(10));
  EXPECT_FALSE(window.ensure(11));
  window.consume(3);
  EXPECT_EQ(window.available(), "3456789");
  EXPECT_EQ(window.skip(2), 2U);
  EXPECT_EQ(window.offset(), 5U);
  EXPECT_EQ(window.skip(100), 5U);
  EXPECT_FALSE(window.ensure(1));
}

}  // namespace setsquare::byte_source_test
