// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A recording is mostly images: what that costs a reader of scans.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "setsquare/io/bags/mcap.hpp"
#include "setsquare/io/bags/rosbag1.hpp"
#include "tests/io/mcap_bytes.hpp"
#include "tests/io/rosbag1_bytes.hpp"
#include "tests/support/temporary_folder.hpp"

namespace setsquare::recording_memory_test {

constexpr int kNumImages = 200;
constexpr std::size_t kImageBytes = 1 << 20;
constexpr std::uint64_t kBallastBytes = std::uint64_t{kNumImages} * kImageBytes;

/// Writes `head`, then scans, each with an image behind it that is a hole in the file.
void write_recording(const std::filesystem::path& path,
                     const std::string& head,
                     const std::string& scan,
                     const std::string& image_head) {
  std::ofstream file(path, std::ios::binary);
  file << head;
  for (int i = 0; i < kNumImages; ++i) {
    file << scan << image_head;
    file.seekp(static_cast<std::streamoff>(kImageBytes), std::ios::cur);
  }
  file << scan;
}

std::string without_data(std::string record) {
  record.resize(record.size() - kImageBytes);
  return record;
}

void write_mcap(const std::filesystem::path& path) {
  using namespace testing;
  const std::string image(kImageBytes, '\0');
  write_recording(
      path,
      kMcapMagicBytes + mcap_header() + mcap_channel(1, 0, "/scan") + mcap_channel(2, 0, "/camera"),
      mcap_message(1, 5, std::string(2000, 's')),
      without_data(mcap_message(2, 5, image)));
}

void write_bag(const std::filesystem::path& path) {
  using namespace testing;
  const std::string image(kImageBytes, '\0');
  write_recording(path,
                  kRosbagMagicBytes + rosbag_header(0, 0) +
                      rosbag_connection(1, "/scan", "a/B", "") +
                      rosbag_connection(2, "/camera", "a/C", ""),
                  rosbag_message(1, 5, 0, std::string(2000, 's')),
                  without_data(rosbag_message(2, 5, 0, image)));
}

/// Hands on what another source reads, and counts it.
class CountingSource final : public ByteSource {
 public:
  CountingSource(const std::string& path, std::uint64_t& num_read)
      : file_(open_file_source(path)), num_read_(num_read) {}

  std::size_t read(std::span<char> bytes) override {
    const std::size_t num_read = file_->read(bytes);
    num_read_ += num_read;
    return num_read;
  }
  std::uint64_t skip(std::uint64_t num_bytes) override { return file_->skip(num_bytes); }

 private:
  std::unique_ptr<ByteSource> file_;
  std::uint64_t& num_read_;
};

std::unique_ptr<MessageSource> open_counting(const std::string& path, std::uint64_t& num_read) {
  auto input = std::make_unique<InputBuffer>(std::make_unique<CountingSource>(path, num_read));
  if (path.ends_with(".mcap")) return std::make_unique<Mcap>(std::move(input));
  return std::make_unique<Rosbag1>(std::move(input), path);
}

/// "VmHWM" or "VmRSS" of this process; 0 where the system does not tell.
std::size_t memory_bytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(name + ":")) return std::stoul(line.substr(name.size() + 1)) * 1024;
  }
  return 0;
}

bool restart_peak() {
  std::ofstream file("/proc/self/clear_refs");
  file << 5 << std::flush;
  return file.good();
}

class Ballast : public ::testing::TestWithParam<const char*> {
 protected:
  Ballast() : path_((folder_.path() / GetParam()).string()) {
    if (path_.ends_with(".mcap")) {
      write_mcap(path_);
    } else {
      write_bag(path_);
    }
  }

  testing::TemporaryFolder folder_;
  std::string path_;
};

TEST_P(Ballast, IsNotReadWhereItIsNotWanted) {
  std::uint64_t num_read = 0;
  const auto source = open_counting(path_, num_read);
  source->set_wanted([](const MessageTopic& topic) { return topic.name == "/scan"; });
  int num_scans = 0;
  Message message;
  while (source->read(message)) ++num_scans;
  EXPECT_EQ(num_scans, kNumImages + 1);
  EXPECT_EQ(source->num_messages().at(1), static_cast<std::uint64_t>(kNumImages));
  EXPECT_EQ(source->problems().num_damaged, 0U);
  EXPECT_LT(num_read, kBallastBytes / 20);
}

TEST_P(Ballast, TakesTheMemoryOfOneMessageWhereItIsWanted) {
  std::uint64_t num_read = 0;
  const auto source = open_counting(path_, num_read);
  const std::size_t before = memory_bytes("VmRSS");
  if (before == 0 || !restart_peak()) GTEST_SKIP() << "the system does not tell of memory";
  Message message;
  while (source->read(message)) {
  }
  EXPECT_GT(num_read, kBallastBytes);
  EXPECT_LT(memory_bytes("VmHWM"), before + 16 * kImageBytes);
}

INSTANTIATE_TEST_SUITE_P(EveryFormat, Ballast, ::testing::Values("run.mcap", "run.bag"));

}  // namespace setsquare::recording_memory_test
