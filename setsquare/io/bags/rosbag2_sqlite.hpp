// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>

#include "setsquare/io/bags/message_source.hpp"
#include "setsquare/io/bags/packed_message.hpp"
#include "setsquare/io/bags/sqlite/database.hpp"
#include "setsquare/io/bytes/byte_source.hpp"

namespace setsquare {

/// A recording of rosbag2 in one SQLite file (.db3). Four versions of its tables are about, which
/// are told by the tables and columns that are there:
///
///   topics(id, name, type, serialization_format)    all; what else it has is not needed
///   messages(topic_id, timestamp, data)             all
///   message_definitions(topic_type, encoding, encoded_message_definition)    from version 4 on
///
/// Messages come in the order of their rows, in which they arrived; their position is the row's
/// number. Of the messages of topics that are not wanted only the row's beginning is read. Messages
/// packed one by one are unpacked (PackedMessage).
///
/// Nothing is written, and nothing lies beside the file afterwards. Of a file that is cut short or
/// damaged all rows are read that SQLite can reach. What a killed recorder left in a write-ahead
/// log beside the file ("x.db3-wal") is read with it.
class Rosbag2Sqlite final : public MessageSource {
 public:
  /// Throws FileError; FormatError where the file is no such recording.
  explicit Rosbag2Sqlite(const std::string& path);

  /// The same from bytes that come in order only. SQLite must jump, so they are copied into a
  /// temporary file first (SeekableFile says where). `name` stands in messages for the path.
  Rosbag2Sqlite(std::unique_ptr<ByteSource> source, const std::string& name);

  [[nodiscard]] bool read(Message& message) override;
  [[nodiscard]] std::string format() const override { return "ROS 2 bag (SQLite)"; }
  [[nodiscard]] std::optional<double> fraction_read() const override;

 private:
  explicit Rosbag2Sqlite(sqlite::Pages pages);

  void require_tables();
  void remark_on_pages();
  void begin();
  void read_topics();
  [[nodiscard]] std::unordered_map<std::string, std::string> read_definitions();
  [[nodiscard]] std::string text(const sqlite::Statement& query, int column);
  [[nodiscard]] bool next_row();
  void skip_damaged_rows(const std::string& reason);
  [[nodiscard]] bool is_readable_behind(std::int64_t row_id);
  [[nodiscard]] std::optional<std::size_t> topic_of_row();
  [[nodiscard]] bool read_message(std::size_t topic, Message& message);
  void count_damage(const std::string& reason);

  sqlite::Database database_;
  std::optional<sqlite::Statement> rows_;
  sqlite::Blob data_;
  std::unordered_map<std::int64_t, std::size_t> topic_of_id_;
  std::int64_t row_id_ = 0;  ///< Of the row read last.
  std::optional<std::int64_t> last_row_id_;
  bool is_at_end_ = false;
  std::string bytes_;
  std::uint64_t num_bytes_left_;  ///< Of messages and texts; the file cannot hold more.
  PackedMessage packed_message_;
};

}  // namespace setsquare
