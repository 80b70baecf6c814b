// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/outputs/ending_signals.hpp"

#include <pthread.h>

#include <cstdlib>
#include <utility>

namespace setsquare::app {
namespace {

/// Makes the waiting thread end.
constexpr int kWake = SIGUSR1;

sigset_t awaited_signals() {
  sigset_t signals;
  ::sigemptyset(&signals);
  ::sigaddset(&signals, kWake);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    ::sigaction(signal, nullptr, &action);
    if (action.sa_handler != SIG_IGN) ::sigaddset(&signals, signal);
  }
  return signals;
}

/// Lets the signal do what it does by default: it ends the process.
void end_by(int signal) {
  sigset_t only;
  ::sigemptyset(&only);
  ::sigaddset(&only, signal);
  ::pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
  ::raise(signal);
  std::_Exit(128 + signal);  // where a handler of the signal returns
}

}  // namespace

EndingSignals::EndingSignals(std::function<void()> clean)
    : clean_(std::move(clean)), signals_(awaited_signals()) {
  ::pthread_sigmask(SIG_BLOCK, &signals_, &mask_before_);
  waiter_ = std::thread([this] { wait(); });
}

EndingSignals::~EndingSignals() {
  {
    const auto held = hold();
    is_over_ = true;
  }
  ::pthread_kill(waiter_.native_handle(), kWake);
  waiter_.join();
  ::pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
  if (late_signal_ != 0) end_by(late_signal_);
}

void EndingSignals::wait() {
  int signal = 0;
  ::sigwait(&signals_, &signal);
  const auto held = hold();
  if (is_over_) {
    late_signal_ = signal == kWake ? 0 : signal;
    return;
  }
  clean_();
  end_by(signal);
}

}  // namespace setsquare::app
