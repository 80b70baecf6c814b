// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace setsquare {

/// Called after each finished task with the number done and the total. Never called by two threads
/// at once. May be empty.
using Progress = std::function<void(std::size_t num_done, std::size_t num_tasks)>;

/// Runs task(0) ... task(num_tasks - 1) on `num_threads` threads (at least one), in no fixed order:
/// each task writes to its own place, so that the results do not depend on the threads. Where
/// tasks throw, what the first of them by index threw is thrown again after all have ended.
void run_in_parallel(std::size_t num_tasks,
                     std::size_t num_threads,
                     const std::function<void(std::size_t)>& task,
                     const Progress& progress = {});

}  // namespace setsquare
