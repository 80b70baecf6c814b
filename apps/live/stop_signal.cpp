// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/live/stop_signal.hpp"

#include <pthread.h>

#include <utility>

namespace setsquare::live_app {
namespace {

constexpr int kWake = SIGUSR1;  ///< Makes the waiting thread end.

}  // namespace

StopSignal::StopSignal() {
  ::sigemptyset(&signals_);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, kWake}) {
    struct sigaction action {};
    ::sigaction(signal, nullptr, &action);
    if (signal == kWake || action.sa_handler != SIG_IGN) ::sigaddset(&signals_, signal);
  }
  ::pthread_sigmask(SIG_BLOCK, &signals_, &mask_before_);
  waiter_ = std::thread([this] { await_signals(); });
}

StopSignal::~StopSignal() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  ::pthread_kill(waiter_.native_handle(), kWake);
  waiter_.join();
  ::pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
}

void StopSignal::await_signals() {
  for (;;) {
    int signal = 0;
    ::sigwait(&signals_, &signal);
    {
      const std::lock_guard lock(mutex_);
      if (is_over_) return;
    }
    if (signal == kWake) continue;
    if (is_stopped()) {
      sigset_t only;
      ::sigemptyset(&only);
      ::sigaddset(&only, signal);
      ::pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
      ::raise(signal);
    }
    stop();
  }
}

void StopSignal::stop() {
  std::function<void()> call;
  {
    const std::lock_guard lock(mutex_);
    if (std::exchange(is_stopped_, true)) return;
    call = call_;
  }
  is_asked_.notify_all();
  if (call) call();
}

bool StopSignal::is_stopped() const {
  const std::lock_guard lock(mutex_);
  return is_stopped_;
}

void StopSignal::on_stop(std::function<void()> call) {
  {
    const std::lock_guard lock(mutex_);
    call_ = call;
    if (!is_stopped_) return;
  }
  if (call) call();
}

bool StopSignal::wait_until(Clock::time_point moment) {
  std::unique_lock lock(mutex_);
  is_asked_.wait_until(lock, moment, [this] { return is_stopped_; });
  return !is_stopped_;
}

}  // namespace setsquare::live_app
