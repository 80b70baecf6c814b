// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <csignal>
#include <functional>
#include <mutex>
#include <thread>

namespace setsquare::app {

/// While it lives, SIGINT (Ctrl-C), SIGTERM and SIGHUP first call `clean` and then end the process
/// as they do without it, so that a shell sees the signal. A signal that the process was started
/// to ignore (nohup) stays ignored.
///
/// A separate thread waits for the signals, so that `clean` may do whatever a function may; the
/// other threads, if they were started later, never receive them.
class EndingSignals {
 public:
  explicit EndingSignals(std::function<void()> clean);
  /// A signal that came too late for `clean` ends the process here.
  ~EndingSignals();
  EndingSignals(const EndingSignals&) = delete;
  EndingSignals& operator=(const EndingSignals&) = delete;

  /// Signals wait while the lock is held: around what `clean` must not find half done.
  [[nodiscard]] std::unique_lock<std::mutex> hold() { return std::unique_lock(mutex_); }

 private:
  void wait();

  std::function<void()> clean_;
  std::mutex mutex_;
  bool is_over_ = false;  ///< Guarded by the mutex.
  int late_signal_ = 0;   ///< Written before the thread is joined, read after.
  sigset_t signals_{};
  sigset_t mask_before_{};
  std::thread waiter_;
};

}  // namespace setsquare::app
