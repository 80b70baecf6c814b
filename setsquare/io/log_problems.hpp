// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace setsquare {

/// A record that could not be read and was skipped.
struct LogProblem {
  std::string location;  ///< "line 12" or "offset 3456".
  std::string reason;
};

/// What is wrong with a log, as far as it has been read.
struct LogProblems {
  static constexpr std::size_t kMaxKept = 20;

  std::uint64_t num_damaged = 0;     ///< Records skipped, all of them.
  std::vector<LogProblem> first;     ///< The first kMaxKept of them.
  std::vector<std::string> remarks;  ///< What concerns the whole log, one sentence each.

  [[nodiscard]] bool empty() const { return num_damaged == 0 && remarks.empty(); }
  void add(std::string location, std::string reason) {
    ++num_damaged;
    if (first.size() < kMaxKept) first.push_back({std::move(location), std::move(reason)});
  }
};

/// One sentence for the end of a run, naming the first damaged record: "3 damaged records skipped,
/// the first at line 12: ...". Empty where there is none.
[[nodiscard]] std::string summary(const LogProblems& problems);

}  // namespace setsquare
