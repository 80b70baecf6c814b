// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/live/resumed_messages.hpp"

#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bags/open_recording.hpp"

namespace setsquare {

ResumedMessages::ResumedMessages(std::vector<std::string> files,
                                 std::unique_ptr<MessageQueue> queue,
                                 std::function<void()> on_live)
    : files_(std::move(files)), queue_(std::move(queue)), on_live_(std::move(on_live)) {}

bool ResumedMessages::read(Message& message) {
  if (read_kept(message)) return true;
  if (on_live_) std::exchange(on_live_, {})();
  if (!queue_->read(message)) return false;
  renumber(*queue_, message);
  return true;
}

bool ResumedMessages::read_kept(Message& message) {
  while (kept_ != nullptr || num_opened_ < files_.size()) {
    try {
      if (kept_ == nullptr) open_next();
      if (kept_ != nullptr && kept_->read(message)) {
        renumber(*kept_, message);
        return true;
      }
    } catch (const Error& error) {
      problems().add(files_[num_opened_ - 1], error.what());
    }
    kept_.reset();
  }
  return false;
}

void ResumedMessages::open_next() {
  const std::string& file = files_[num_opened_++];
  kept_ = open_recording_file(file);
}

void ResumedMessages::renumber(const MessageSource& source, Message& message) {
  message.topic = add_topic(source.topics()[message.topic]);
  count(message.topic);
}

}  // namespace setsquare
