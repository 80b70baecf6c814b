// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/map/timing.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

namespace setsquare::app {
namespace {

using Json = nlohmann::ordered_json;

/// Times are measured to about a microsecond.
double rounded_to_us(double seconds) { return std::round(seconds * 1e6) / 1e6; }

/// The system's name for it; "unknown" where it has none.
std::string processor_name() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);) {
    const bool is_name = line.starts_with("model name") || line.starts_with("Model");
    const std::size_t colon = line.find(": ");
    if (is_name && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

constexpr const char* kCompiler =
#if defined(__clang__)
    "Clang " __clang_version__;
#elif defined(__GNUC__)
    "GCC " __VERSION__;
#else
    "unknown";
#endif

}  // namespace

void StageClock::begin(const std::string& stage) {
  end();
  const auto found = std::ranges::find(stages_, stage, &StageTime::stage);
  running_ = static_cast<std::size_t>(found - stages_.begin());
  if (found == stages_.end()) stages_.push_back({.stage = stage, .wall_s = 0.0});
  start_ = Clock::now();
}

void StageClock::end() {
  if (running_ == kNone) return;
  stages_[running_].wall_s += std::chrono::duration<double>(Clock::now() - start_).count();
  running_ = kNone;
}

std::string timing_json(const MapTiming& timing) {
  Json stages = Json::object();
  double total_s = 0.0;
  for (const StageTime& time : timing.stages) {
    stages[time.stage] = rounded_to_us(time.wall_s);
    total_s += time.wall_s;
  }
  const double scans = static_cast<double>(std::max<std::size_t>(timing.num_scans, 1));
  const Json json = {
      {"wall_s", {{"stages", stages}, {"total", rounded_to_us(total_s)}}},
      {"scans", timing.num_scans},
      {"us_per_scan", std::round(1e7 * total_s / scans) / 10.0},
      {"threads", timing.num_threads},
      {"peak_memory_mb", std::round(static_cast<double>(peak_memory_bytes()) / 1e5) / 10.0},
      {"machine",
       {{"processor", processor_name()}, {"cores", std::thread::hardware_concurrency()}}},
      {"build",
       {{"version", SETSQUARE_VERSION}, {"compiler", kCompiler}, {"type", SETSQUARE_BUILD_TYPE}}}};
  // The processor's name comes from outside: what is no UTF-8 is replaced, not refused.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::uint64_t peak_memory_bytes() {
  rusage usage{};
  if (::getrusage(RUSAGE_SELF, &usage) != 0) return 0;
#if defined(__APPLE__)
  constexpr std::uint64_t kUnit = 1;
#else
  constexpr std::uint64_t kUnit = 1024;
#endif
  return static_cast<std::uint64_t>(usage.ru_maxrss) * kUnit;
}

}  // namespace setsquare::app
