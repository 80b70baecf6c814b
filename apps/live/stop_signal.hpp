// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <condition_variable>
#include <csignal>
#include <functional>
#include <mutex>
#include <thread>

namespace setsquare::live_app {

/// The first SIGINT (Ctrl-C), SIGTERM or SIGHUP asks the program to stop: it finishes its map. The
/// second one ends it as it is. To be made before other threads, which inherit that these signals
/// are blocked.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  /// Asks to stop, as a signal does.
  void stop();
  [[nodiscard]] bool is_stopped() const;
  /// Called when it is asked to stop, on another thread, or at once where it was; not more than
  /// one.
  void on_stop(std::function<void()> call);

  using Clock = std::chrono::steady_clock;
  /// Waits until a moment; false at once where it is asked to stop.
  bool wait_until(Clock::time_point moment);

 private:
  void await_signals();

  mutable std::mutex mutex_;
  std::condition_variable is_asked_;
  bool is_stopped_ = false;
  bool is_over_ = false;
  std::function<void()> call_;
  sigset_t signals_{};
  sigset_t mask_before_{};
  std::thread waiter_;
};

}  // namespace setsquare::live_app
