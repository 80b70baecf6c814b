// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The records of ROS 1 bags, version 2.0 (http://wiki.ros.org/Bags/Format/2.0), as far as messages
// need them. A record is a header and data, each behind its length of four bytes; the header is a
// list of fields "name=value", each behind its length of four bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "setsquare/core/timestamp.hpp"
#include "setsquare/io/bytes/byte_window.hpp"

namespace setsquare {

enum class RosbagOp : std::uint8_t {
  kMessage = 0x02,
  kBagHeader = 0x03,
  kIndex = 0x04,
  kChunk = 0x05,
  kChunkInfo = 0x06,
  kConnection = 0x07,
};

/// What stands in front of a record's data. Fields that a kind does not have are zero or empty.
struct RosbagHead {
  RosbagOp op{};
  std::uint32_t num_head_bytes = 0;  ///< Of the header and both lengths.
  std::uint32_t num_data_bytes = 0;
  std::uint32_t connection = 0;          ///< kMessage, kConnection.
  Timestamp time;                        ///< kMessage: when it was recorded.
  std::string_view topic;                ///< kConnection.
  std::string_view compression;          ///< kChunk: "none", "bz2", "lz4".
  std::uint32_t num_bytes_unpacked = 0;  ///< kChunk.
  std::uint32_t num_entries = 0;         ///< kIndex.
  std::uint64_t index_position = 0;      ///< kBagHeader: 0 in a bag that was not closed.
  std::uint32_t num_chunks = 0;          ///< kBagHeader.

  [[nodiscard]] std::uint64_t num_bytes() const {
    return std::uint64_t{num_head_bytes} + num_data_bytes;
  }
  [[nodiscard]] bool is_known() const {
    return op >= RosbagOp::kMessage && op <= RosbagOp::kConnection;
  }
};

/// What the data of a connection say of its messages.
struct RosbagConnection {
  std::string_view topic;  ///< As the publisher names it; the header's is what was recorded.
  std::string_view type;
  std::string_view definition;
};

/// The head that begins at `offset` of what is available, its text inside of it; nothing where no
/// record can begin like this: fields that do not fill the header, or not those that a record of
/// its kind must have, or a length that it cannot have. Nothing, too, where the bytes end before
/// the head does.
[[nodiscard]] std::optional<RosbagHead> read_rosbag_head(ByteWindow& bytes, std::size_t offset = 0);

/// The fields of a connection's data; nothing where they are damaged.
[[nodiscard]] std::optional<RosbagConnection> read_rosbag_connection(std::string_view data);

}  // namespace setsquare
