// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/scans/scans_at_stamps.hpp"

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <set>

#include "apps/setsquare/progress_bar.hpp"
#include "apps/setsquare/scans/log_options.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/io/logs/open_log.hpp"

namespace setsquare::app {
namespace {

std::int64_t distance_ns(Timestamp a, Timestamp b) { return std::abs(a.ns - b.ns); }

}  // namespace

std::map<Timestamp, Scan> scans_at_stamps(const std::string& log_path,
                                          const LogOptions& options,
                                          const std::vector<Timestamp>& stamps) {
  constexpr std::int64_t kTolerance_ns = 20'000;
  const std::set<Timestamp> wanted(stamps.begin(), stamps.end());
  std::map<Timestamp, Scan> found;
  const std::unique_ptr<LogReader> reader = open_log(log_path, options);
  ProgressBar progress("reading " + log_path);
  while (const LogRecord* record = reader->next()) {
    progress.advance(reader->fraction_read());
    auto near = wanted.lower_bound(Timestamp{record->stamp.ns - kTolerance_ns});
    for (; near != wanted.end() && near->ns <= record->stamp.ns + kTolerance_ns; ++near) {
      const auto [held, is_new] = found.try_emplace(*near, record->scan);
      const bool is_nearer =
          distance_ns(record->stamp, *near) < distance_ns(held->second.stamp, *near);
      if (!is_new && is_nearer) held->second = record->scan;
    }
  }
  tell_problems(log_path, reader->problems());
  for (const Timestamp stamp : stamps) {
    if (!found.contains(stamp)) {
      throw Error(log_path + ": no scan with stamp " + to_string(stamp));
    }
  }
  return found;
}

}  // namespace setsquare::app
