// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace setsquare {

void run_in_parallel(std::size_t num_tasks,
                     std::size_t num_threads,
                     const std::function<void(std::size_t)>& task,
                     const Progress& progress) {
  std::atomic<std::size_t> next{0};
  std::size_t num_done = 0;
  std::mutex telling;
  std::vector<std::exception_ptr> failures(num_tasks);
  const auto work = [&] {
    for (std::size_t i = next++; i < num_tasks; i = next++) {
      try {
        task(i);
      } catch (...) {
        failures[i] = std::current_exception();
      }
      const std::lock_guard lock(telling);
      ++num_done;
      if (progress) progress(num_done, num_tasks);
    }
  };
  std::vector<std::thread> workers;
  const std::size_t num_workers = std::clamp<std::size_t>(num_threads, 1, 256);
  for (std::size_t i = 1; i < std::min(num_workers, num_tasks); ++i) workers.emplace_back(work);
  work();
  for (std::thread& worker : workers) worker.join();
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace setsquare
