// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/save_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

std::string content_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

class SaveFile : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directory(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// One a test: CTest runs them side by side.
  const std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) /
      (std::string("setsquare_save_file_") +
       ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(SaveFile, ReplacesAndLeavesNothingElseBehind) {
  const std::filesystem::path path = folder_ / "picture.svg";
  save_file(path.string(), "first and longer");
  save_file(path.string(), std::string("a\0b", 3));
  EXPECT_EQ(content_of(path), std::string("a\0b", 3));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(SaveFile, ATargetThatIsAFolderIsAnErrorWithoutLeftovers) {
  const std::filesystem::path path = folder_ / "folder";
  std::filesystem::create_directories(path / "inside");
  EXPECT_THROW(save_file(path.string(), "text"), FileError);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(SaveFile, AFullDiskIsAnError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full on this machine";
  const std::filesystem::path path = folder_ / "picture.svg";
  std::filesystem::create_symlink("/dev/full", path.string() + ".part");
  EXPECT_THROW(save_file(path.string(), std::string(100'000, 'x')), FileError);
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace setsquare
