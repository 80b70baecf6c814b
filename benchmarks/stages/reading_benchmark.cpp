// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
//
// Logs read from the disk's cache to records of scans: MCAP as it is packed, and CARMEN text. Bytes
// are those of the uncompressed file.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "benchmarks/stages/office_scan.hpp"
#include "setsquare/io/logs/log_writer.hpp"
#include "setsquare/io/logs/open_log.hpp"

namespace setsquare::benchmarks {
namespace {

constexpr int kNumScans = 10000;
constexpr std::size_t kNumBeams = 1081;

/// A log on the disk while it lives.
class LogOnDisk {
 public:
  LogOnDisk(LogFormat format, ChunkPacking packing)
      : path_(std::filesystem::temp_directory_path() /
              ("setsquare_reading_benchmark_" + std::to_string(::getpid()))) {
    std::ofstream file(path_, std::ios::binary);
    const auto writer = make_log_writer(
        format,
        [&file](std::string_view bytes) { file.write(bytes.data(), std::ssize(bytes)); },
        packing);
    LogRecord record;
    record.scan = office_scan(kReferencePose, kNumBeams);
    for (int i = 0; i < kNumScans; ++i) {
      record.stamp = {1'000'000'000'000 + i * std::int64_t{25'000'000}};
      record.scan.stamp = record.stamp;
      for (double& range_m : record.scan.ranges_m) range_m += i % 2 == 0 ? 0.004 : -0.004;
      writer->write(record);
    }
    writer->finish();
  }
  ~LogOnDisk() { std::filesystem::remove(path_); }
  LogOnDisk(const LogOnDisk&) = delete;
  LogOnDisk& operator=(const LogOnDisk&) = delete;

  [[nodiscard]] std::string path() const { return path_.string(); }
  [[nodiscard]] std::int64_t num_bytes() const {
    return static_cast<std::int64_t>(std::filesystem::file_size(path_));
  }

 private:
  std::filesystem::path path_;
};

void read_log(benchmark::State& state, LogFormat format, ChunkPacking packing) {
  const std::int64_t num_bytes = LogOnDisk(format, ChunkPacking::kNone).num_bytes();
  const LogOnDisk log(format, packing);
  std::size_t num_scans = 0;
  for (auto _ : state) {
    const auto reader = open_log(log.path());
    num_scans = 0;
    while (const LogRecord* record = reader->next()) {
      benchmark::DoNotOptimize(record->scan.ranges_m.data());
      ++num_scans;
    }
  }
  if (num_scans != kNumScans) state.SkipWithError("scans are missing");
  state.SetBytesProcessed(state.iterations() * num_bytes);
}

BENCHMARK_CAPTURE(read_log, mcap, LogFormat::kMcap, ChunkPacking::kNone)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_log, mcap_lz4, LogFormat::kMcap, ChunkPacking::kLz4)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_log, mcap_zstd, LogFormat::kMcap, ChunkPacking::kZstd)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_log, carmen, LogFormat::kCarmen, ChunkPacking::kNone)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace setsquare::benchmarks
