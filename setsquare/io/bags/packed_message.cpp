// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bags/packed_message.hpp"

namespace setsquare {

std::string PackedMessage::unpack(MessageEncoding encoding, Message& message) {
  if (encoding != MessageEncoding::kCdr || packing_at(message.data) != Packing::kZstd) return {};
  const BlockUnpacker::Block block = unpacker_.unpack(Packing::kZstd, message.data);
  if (!block.damage.empty()) return "the packed message is " + block.damage;
  message.data = block.bytes;
  return {};
}

}  // namespace setsquare
