// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/save_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "setsquare/core/error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace setsquare::save_file_test {

using testing::content_of;

class SaveFile : public ::testing::Test {
 protected:
  const testing::TemporaryFolder temporary_;
  const std::filesystem::path& folder_ = temporary_.path();
};

TEST_F(SaveFile, StagedFilesComeTogetherOrNotAtAll) {
  const std::string first = (folder_ / "map.pgm").string();
  const std::string second = (folder_ / "map.yaml").string();
  save_file(first, "old");
  {
    StagedFiles files;
    files.add(first, "new");
    files.add(second, "text");
    EXPECT_EQ(content_of(first), "old");
    EXPECT_FALSE(std::filesystem::exists(second));
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1) << "removed";
  StagedFiles files;
  files.add(first, "new");
  files.add(second, "text");
  files.commit();
  EXPECT_EQ(content_of(first), "new");
  EXPECT_EQ(content_of(second), "text");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 2);
}

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

TEST_F(SaveFile, AFullDiskIsAnErrorAndTheOldFileStaysWhole) {
  const std::filesystem::path path = folder_ / "picture.svg";
  save_file(path.string(), "old");
  rlimit old_limit{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old_limit), 0);
  const auto old_action = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{4096, old_limit.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  EXPECT_THROW(save_file(path.string(), std::string(100'000, 'x')), FileError);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old_limit), 0);
  std::signal(SIGXFSZ, old_action);
  EXPECT_EQ(content_of(path), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(SaveFile, ADeviceIsWrittenToAndItsErrorsAreReported) {
  const std::filesystem::path link = folder_ / "device";
  for (const bool is_full : {false, true}) {
    const char* const device = is_full ? "/dev/full" : "/dev/null";
    if (!std::filesystem::exists(device)) GTEST_SKIP() << "no " << device << " on this machine";
    std::filesystem::remove(link);
    std::filesystem::create_symlink(device, link);
    if (is_full) {
      EXPECT_THROW(save_file(link.string(), "text"), FileError);
    } else {
      save_file(link.string(), "text");
    }
    EXPECT_TRUE(std::filesystem::is_character_file(link)) << device;
    EXPECT_TRUE(std::filesystem::is_symlink(link)) << device;
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(SaveFile, APipeStaysAPipe) {
  const std::filesystem::path path = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK);  // NOLINT: variadic by POSIX.
  ASSERT_GE(reader, 0);
  save_file(path.string(), "text");
  char text[8] = {};
  EXPECT_EQ(::read(reader, text, sizeof text), 4);
  ::close(reader);
  EXPECT_STREQ(text, "text");
  EXPECT_TRUE(std::filesystem::is_fifo(path));
}

TEST_F(SaveFile, ALinkStaysAndWhatItNamesIsReplaced) {
  std::filesystem::create_directory(folder_ / "inside");
  const std::filesystem::path target = folder_ / "inside" / "picture.svg";
  const std::filesystem::path link = folder_ / "link";
  std::filesystem::create_symlink("inside/picture.svg", link);
  for (const std::string text : {"to a name without a file", "to a file"}) {
    save_file(link.string(), text);
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    EXPECT_EQ(content_of(target), text);
  }
}

TEST_F(SaveFile, AStrangersPartFileIsLeftAlone) {
  const std::filesystem::path path = folder_ / "picture.svg";
  for (const char* const ending : {".part", ".0.part"}) {
    std::ofstream(path.string() + ending) << "of somebody";
  }
  save_file(path.string(), "text");
  EXPECT_EQ(content_of(path), "text");
  for (const char* const ending : {".part", ".0.part"}) {
    EXPECT_EQ(content_of(path.string() + ending), "of somebody");
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 3);
}

TEST_F(SaveFile, PermissionsAreTheUsersHabitOrTheOldFiles) {
  const auto permissions_of = [](const std::filesystem::path& path) {
    return std::filesystem::status(path).permissions();
  };
  const std::filesystem::path path = folder_ / "picture.svg";
  const std::filesystem::path plain = folder_ / "plain";
  std::ofstream(plain) << "made as every program does";
  save_file(path.string(), "new");
  EXPECT_EQ(permissions_of(path), permissions_of(plain));
  const auto only_owner = std::filesystem::perms::owner_read | std::filesystem::perms::owner_write;
  std::filesystem::permissions(path, only_owner);
  save_file(path.string(), "newer");
  EXPECT_EQ(permissions_of(path), only_owner);
}

}  // namespace setsquare::save_file_test
