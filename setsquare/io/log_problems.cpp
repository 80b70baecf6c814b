// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/log_problems.hpp"

namespace setsquare {

std::string summary(const LogProblems& problems) {
  if (problems.num_damaged == 0) return {};
  const LogProblem& first = problems.first.front();
  const bool is_one = problems.num_damaged == 1;
  return std::to_string(problems.num_damaged) +
         (is_one ? " damaged record skipped, at " : " damaged records skipped, the first at ") +
         first.location + ": " + first.reason;
}

}  // namespace setsquare
