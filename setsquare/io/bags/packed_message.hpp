// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "setsquare/io/bags/message_source.hpp"
#include "setsquare/io/bytes/block_unpacker.hpp"

namespace setsquare {

/// More than any message has, packed or not: a longer one is damaged.
inline constexpr std::size_t kMaxMessageBytes = std::size_t{1} << 28;

/// Unpacks messages that were recorded with `--compression-mode message`: each is a frame of zstd.
/// A message in CDR begins with a zero byte and such a frame does not, so that nobody need say
/// which it is.
class PackedMessage {
 public:
  /// What is wrong with the message, which is then not to be used; empty where it stands in
  /// `message` as CDR, unpacked if need be (valid until the next call), or is of another encoding.
  [[nodiscard]] std::string unpack(MessageEncoding encoding, Message& message);

 private:
  BlockUnpacker unpacker_{kMaxMessageBytes};
};

}  // namespace setsquare
