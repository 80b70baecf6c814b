// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/live/journal.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/live/message_queue.hpp"
#include "setsquare/live/resumed_messages.hpp"
#include "tests/support/seed.hpp"
#include "tests/support/temporary_folder.hpp"

namespace setsquare {
namespace journal_test {

using Clock = std::chrono::steady_clock;

const MessageTopic kScans{.name = "/scan",
                          .type = "sensor_msgs/LaserScan",
                          .definition = {},
                          .encoding = MessageEncoding::kCdr};
const MessageTopic kFixed{.name = "/tf_static",
                          .type = "tf2_msgs/TFMessage",
                          .definition = {},
                          .encoding = MessageEncoding::kCdr};

std::int64_t now_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now().time_since_epoch())
      .count();
}

void add(Journal& journal, const MessageTopic& topic, const std::string& data) {
  Message message;
  message.log_time = {now_ns()};
  message.data = data;
  journal.add(topic, message);
}

struct Read {
  std::string topic;
  std::string data;
  Timestamp log_time;

  bool operator==(const Read& other) const { return topic == other.topic && data == other.data; }
};

/// What a folder holds, and then what a queue gives: "live".
std::vector<Read> read_all(const std::string& folder, LogProblems* problems = nullptr) {
  auto queue = std::make_unique<MessageQueue>("test");
  MessageQueue* to = queue.get();
  ResumedMessages messages(Journal::files_of(folder), std::move(queue), [&] {
    to->push(to->add(kScans), {}, "live");
    to->close();
  });
  std::vector<Read> all;
  Message message;
  while (messages.read(message)) {
    all.push_back(
        {messages.topics()[message.topic].name, std::string(message.data), message.log_time});
  }
  if (problems != nullptr) *problems = messages.problems();
  EXPECT_EQ(all.at(all.size() - 1).data, "live");
  all.pop_back();
  return all;
}

void refuse_failure(const std::string& reason) { ADD_FAILURE() << reason; }

TEST(Journal, WhatWasKeptIsReadInItsOrderOverSeveralRuns) {
  const testing::TemporaryFolder folder;
  std::vector<Read> added;
  for (int run = 0; run < 3; ++run) {
    Journal journal(folder.path() / "kept", refuse_failure, 0.01);
    for (int i = 0; i < 100; ++i) {
      const std::string data = std::to_string(run) + "/" + std::to_string(i);
      add(journal, i % 7 == 0 ? kFixed : kScans, data);
      added.push_back({i % 7 == 0 ? "/tf_static" : "/scan", data, {}});
      if (i % 30 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }
  EXPECT_EQ(read_all(folder.path() / "kept"), added);
}

TEST(Journal, MountingsOutliveWhatIsForgotten) {
  const testing::TemporaryFolder folder;
  {
    Journal journal(folder.path(), refuse_failure, 0.01);
    add(journal, kFixed, "mounting");
    add(journal, kScans, "old");
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    journal.clear();
    add(journal, kScans, "new");
  }
  const std::vector<Read> expected = {{"/tf_static", "mounting", {}}, {"/scan", "new", {}}};
  EXPECT_EQ(read_all(folder.path()), expected);
}

TEST(Journal, ADamagedFileIsToldAndPassedOver) {
  const testing::TemporaryFolder folder;
  for (const char* data : {"a", "b", "c"}) {
    Journal journal(folder.path(), refuse_failure);
    add(journal, kScans, data);
  }
  const std::vector<std::string> files = Journal::files_of(folder.path());
  ASSERT_EQ(files.size(), 3U);
  std::ofstream(files[1], std::ios::binary) << "no recording";
  std::ofstream(folder.path() / "notes.mcap") << "somebody's own file";
  LogProblems problems;
  const std::vector<Read> expected = {{"/scan", "a", {}}, {"/scan", "c", {}}};
  EXPECT_EQ(read_all(folder.path(), &problems), expected);
  EXPECT_EQ(problems.num_damaged, 1U);
}

TEST(Journal, AFolderThatCannotBeMadeIsNamed) {
  const testing::TemporaryFolder folder;
  std::ofstream(folder.path() / "file") << "x";
  EXPECT_THROW(Journal(folder.path() / "file" / "kept", refuse_failure), FileError);
}

/// Adds a numbered message each millisecond until it is killed.
[[noreturn]] void add_until_killed(const std::string& folder, double period_s) {
  Journal journal(
      folder, [](const std::string&) {}, period_s);
  for (int i = 0;; ++i) {
    add(journal, kScans, std::to_string(i));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(Journal, AKillLosesNoMoreThanOnePeriod) {
  constexpr double kPeriod_s = 0.05;
  constexpr double kSlowDisk_s = 2.0;  // Of a machine that has much to do.
  constexpr int kNumKills = 40;
  auto random = testing::make_generator();
  SCOPED_TRACE(testing::test_seed());
  for (int kill_number = 0; kill_number < kNumKills; ++kill_number) {
    const testing::TemporaryFolder folder;
    const std::int64_t begin_ns = now_ns();
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) add_until_killed(folder.path(), kPeriod_s);
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 300000));
    const std::int64_t killed_ns = now_ns();
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const std::vector<Read> kept = read_all(folder.path());
    for (std::size_t i = 0; i < kept.size(); ++i) ASSERT_EQ(kept[i].data, std::to_string(i));
    const std::int64_t last_ns = kept.empty() ? begin_ns : kept.back().log_time.ns;
    EXPECT_LT(1e-9 * static_cast<double>(killed_ns - last_ns), kPeriod_s + kSlowDisk_s);
  }
}

}  // namespace journal_test
}  // namespace setsquare
