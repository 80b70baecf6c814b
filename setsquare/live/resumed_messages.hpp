// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "setsquare/io/bags/message_source.hpp"
#include "setsquare/live/message_queue.hpp"

namespace setsquare {

/// What an earlier run has kept (Journal), and then what comes: one recording. A file that cannot
/// be read is told in problems(), and passed over.
class ResumedMessages final : public MessageSource {
 public:
  /// `on_live`: before the first message that comes now, when all files have been read.
  ResumedMessages(std::vector<std::string> files,
                  std::unique_ptr<MessageQueue> queue,
                  std::function<void()> on_live);

  [[nodiscard]] bool read(Message& message) override;
  [[nodiscard]] std::string format() const override { return queue_->format(); }
  [[nodiscard]] std::optional<double> fraction_read() const override { return std::nullopt; }
  [[nodiscard]] bool has_arrival_times() const override { return true; }
  void left_out() override { queue_->left_out(); }

 private:
  [[nodiscard]] bool read_kept(Message& message);
  void open_next();
  /// The message's topic in this source, by its topic in another.
  void renumber(const MessageSource& source, Message& message);

  std::vector<std::string> files_;
  std::size_t num_opened_ = 0;
  std::unique_ptr<MessageSource> kept_;
  std::unique_ptr<MessageQueue> queue_;
  std::function<void()> on_live_;
};

}  // namespace setsquare
