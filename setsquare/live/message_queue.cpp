// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/live/message_queue.hpp"

#include <utility>

namespace setsquare {

void MessageQueue::push(std::size_t topic, Timestamp log_time, std::string_view data) {
  {
    const std::lock_guard lock(mutex_);
    if (is_closed_) return;
    queued_.push_back({topic, log_time, Clock::now(), std::string(data)});
    num_bytes_ += data.size();
    while (queued_.size() > kMaxMessages || (num_bytes_ > kMaxBytes && queued_.size() > 1)) {
      num_bytes_ -= queued_.front().data.size();
      queued_.pop_front();
      ++num_dropped_;
    }
  }
  has_more_.notify_one();
}

void MessageQueue::close() {
  {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
  }
  has_more_.notify_one();
}

std::size_t MessageQueue::num_waiting() const {
  const std::lock_guard lock(mutex_);
  return queued_.size();
}

std::uint64_t MessageQueue::num_dropped() const {
  const std::lock_guard lock(mutex_);
  return num_dropped_;
}

bool MessageQueue::read(Message& message) {
  do {
    std::unique_lock lock(mutex_);
    has_more_.wait(lock, [this] { return is_closed_ || !queued_.empty(); });
    if (queued_.empty()) return false;
    current_ = std::move(queued_.front());
    queued_.pop_front();
    num_bytes_ -= current_.data.size();
    lock.unlock();
    count(current_.topic);
  } while (!is_wanted(current_.topic));
  message = {.topic = current_.topic,
             .log_time = current_.log_time,
             .data = current_.data,
             .position = num_read_++};
  if (on_read_) on_read_(topics()[current_.topic], message);
  return true;
}

}  // namespace setsquare
