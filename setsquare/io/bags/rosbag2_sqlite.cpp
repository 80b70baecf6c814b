// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bags/rosbag2_sqlite.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <utility>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/core/joined.hpp"

namespace setsquare {
namespace {

using sqlite::Outcome;

constexpr std::size_t kMaxTopics = 65536;

bool is_there(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

/// The write-ahead log beside a database, if there is one.
std::optional<SeekableFile> write_ahead_log_of(const std::string& path) {
  const std::string log = path + "-wal";
  if (!is_there(log)) return std::nullopt;
  return SeekableFile(log);
}

/// The pages of a database whose bytes come in order only.
sqlite::Pages copied_pages(ByteSource& source, const std::string& name) {
  SeekableFile file(source, name);
  const std::string damage = source.damage();
  if (file.size() == 0 && !damage.empty()) throw FormatError(name, "", damage);
  return sqlite::Pages(std::move(file), std::nullopt);
}

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

Rosbag2Sqlite::Rosbag2Sqlite(const std::string& path)
    : Rosbag2Sqlite(sqlite::Pages(SeekableFile(path), write_ahead_log_of(path))) {
  if (!is_there(path + "-journal")) return;
  problems().remarks.push_back(
      fmt::format("{}-journal lies beside the file: the recorder was stopped in the midst of "
                  "writing, and the last messages may be in disorder",
                  path));
}

Rosbag2Sqlite::Rosbag2Sqlite(std::unique_ptr<ByteSource> source, const std::string& name)
    : Rosbag2Sqlite(copied_pages(*source, name)) {
  if (const std::string damage = source->damage(); !damage.empty()) {
    problems().add("the end", damage);
  }
}

Rosbag2Sqlite::Rosbag2Sqlite(sqlite::Pages pages)
    : database_(std::move(pages)),
      data_(database_, "messages", "data"),
      num_bytes_left_(database_.pages().size_bytes()) {
  require_tables();
  remark_on_pages();
}

void Rosbag2Sqlite::require_tables() {
  struct Needed {
    const char* table;
    std::vector<std::string> columns;
  };
  const Needed all_needed[] = {{"topics", {"id", "name", "type", "serialization_format"}},
                               {"messages", {"topic_id", "timestamp", "data"}}};
  const std::string& name = database_.pages().name();
  const std::vector<std::string> tables = database_.tables();
  for (const Needed& needed : all_needed) {
    if (!has(tables, needed.table)) {
      throw FormatError(name,
                        "",
                        fmt::format("an SQLite file, but no ROS 2 bag: it has no table {}, but {}",
                                    needed.table,
                                    tables.empty() ? "none at all" : joined(tables)));
    }
    const std::vector<std::string> columns = database_.columns(needed.table);
    for (const std::string& column : needed.columns) {
      if (has(columns, column)) continue;
      throw FormatError(
          name, "", fmt::format("no ROS 2 bag: its table {} has no {}", needed.table, column));
    }
  }
}

void Rosbag2Sqlite::remark_on_pages() {
  const sqlite::Pages& pages = database_.pages();
  if (pages.num_pages() < pages.num_pages_stated()) {
    problems().remarks.push_back(fmt::format("the file is cut short: {} of its {} pages are there",
                                             pages.num_pages(),
                                             pages.num_pages_stated()));
  }
  if (pages.num_newer_pages() > 0) {
    problems().remarks.push_back(
        fmt::format("the recorder did not come to its end: its last {} pages are those of {}-wal",
                    pages.num_newer_pages(),
                    pages.name()));
  }
}

bool Rosbag2Sqlite::read(Message& message) {
  if (!rows_) begin();
  while (next_row()) {
    const std::optional<std::size_t> topic = topic_of_row();
    if (!topic || (is_wanted(*topic) && !read_message(*topic, message))) continue;
    count(*topic);
    if (is_wanted(*topic)) return true;
  }
  return false;
}

std::optional<double> Rosbag2Sqlite::fraction_read() const {
  if (is_at_end_) return 1.0;
  if (!rows_) return 0.0;
  if (!last_row_id_ || *last_row_id_ <= 0) return std::nullopt;
  return std::min(1.0, static_cast<double>(row_id_) / static_cast<double>(*last_row_id_));
}

void Rosbag2Sqlite::begin() {
  read_topics();
  sqlite::Statement last(database_, "SELECT max(rowid) FROM messages");
  if (last.step() == Outcome::kFound && last.is_integer(0)) last_row_id_ = last.integer(0);
  // All rows, and no index: unwanted rows cost less than an order that is not that of arrival.
  rows_.emplace(database_,
                "SELECT rowid, topic_id, timestamp FROM messages NOT INDEXED WHERE rowid > ?1 "
                "ORDER BY rowid");
  rows_->restart(row_id_);
}

std::unordered_map<std::string, std::string> Rosbag2Sqlite::read_definitions() {
  std::unordered_map<std::string, std::string> definitions;
  const std::vector<std::string> columns = database_.columns("message_definitions");
  for (const char* column : {"topic_type", "encoding", "encoded_message_definition"}) {
    if (!has(columns, column)) return {};
  }
  // Of the two languages of definitions the other, "ros2idl", is not read.
  sqlite::Statement query(database_,
                          "SELECT topic_type, encoded_message_definition FROM message_definitions "
                          "WHERE encoding = 'ros2msg' ORDER BY rowid");
  for (std::size_t i = 0; i < kMaxTopics && query.step() == Outcome::kFound; ++i) {
    definitions.emplace(plain_type_name(text(query, 0)), text(query, 1));
  }
  return definitions;
}

void Rosbag2Sqlite::read_topics() {
  const std::unordered_map<std::string, std::string> definitions = read_definitions();
  sqlite::Statement query(database_,
                          "SELECT id, name, type, serialization_format FROM topics ORDER BY rowid");
  for (std::size_t i = 0; i < kMaxTopics; ++i) {
    const Outcome outcome = query.step();
    if (outcome == Outcome::kDamaged) problems().add("table topics", database_.last_error());
    if (outcome != Outcome::kFound) return;
    MessageTopic topic;
    topic.name = text(query, 1);
    topic.type = plain_type_name(text(query, 2));
    if (text(query, 3) == "cdr") topic.encoding = MessageEncoding::kCdr;
    const auto definition = definitions.find(topic.type);
    if (definition != definitions.end()) topic.definition = definition->second;
    topic_of_id_.emplace(query.integer(0), add_topic(std::move(topic)));
  }
}

std::string Rosbag2Sqlite::text(const sqlite::Statement& query, int column) {
  std::string text = query.text(column);
  if (text.size() > num_bytes_left_) {
    throw FormatError(database_.pages().name(), "", "damaged: its texts are longer than the file");
  }
  num_bytes_left_ -= text.size();
  return text;
}

bool Rosbag2Sqlite::next_row() {
  while (!is_at_end_) {
    const Outcome outcome = rows_->step();
    if (outcome == Outcome::kNone) {
      is_at_end_ = true;
    } else if (outcome == Outcome::kDamaged) {
      skip_damaged_rows(database_.last_error());
    } else if (rows_->integer(0) <= row_id_) {
      skip_damaged_rows("the rows go round in circles");
    } else {
      row_id_ = rows_->integer(0);
      return true;
    }
  }
  return false;
}

bool Rosbag2Sqlite::is_readable_behind(std::int64_t row_id) {
  rows_->restart(row_id);
  const Outcome outcome = rows_->step();
  return outcome == Outcome::kNone || (outcome == Outcome::kFound && rows_->integer(0) > row_id);
}

/// A damaged page hides a range of rows that only its neighbours tell the end of: larger and larger
/// steps find a row behind it, then halving the last step finds the first such row.
void Rosbag2Sqlite::skip_damaged_rows(const std::string& reason) {
  const std::int64_t first = row_id_ + 1;
  std::int64_t unreadable = row_id_;
  std::int64_t readable = row_id_;
  for (std::int64_t step = 1; readable == row_id_; step *= 2) {
    if (step > (std::numeric_limits<std::int64_t>::max() - row_id_) / 2) {
      is_at_end_ = true;
      problems().add(fmt::format("row {}", first), "from here on none can be read: " + reason);
      return;
    }
    if (is_readable_behind(row_id_ + step)) {
      readable = row_id_ + step;
    } else {
      unreadable = row_id_ + step;
    }
  }
  while (readable - unreadable > 1) {
    const std::int64_t middle = unreadable + (readable - unreadable) / 2;
    (is_readable_behind(middle) ? readable : unreadable) = middle;
  }
  problems().add(fmt::format("row {}", first),
                 fmt::format("unreadable to row {}: {}", readable, reason));
  row_id_ = readable;
  rows_->restart(row_id_);
}

std::optional<std::size_t> Rosbag2Sqlite::topic_of_row() {
  if (!rows_->is_integer(1) || !rows_->is_integer(2)) {
    count_damage("topic_id and timestamp must be whole numbers");
    return std::nullopt;
  }
  const auto found = topic_of_id_.find(rows_->integer(1));
  if (found == topic_of_id_.end()) {
    count_damage(fmt::format("no topic has the id {}", rows_->integer(1)));
    return std::nullopt;
  }
  return found->second;
}

bool Rosbag2Sqlite::read_message(std::size_t topic, Message& message) {
  const std::size_t max_bytes =
      static_cast<std::size_t>(std::min<std::uint64_t>(num_bytes_left_, kMaxMessageBytes));
  if (data_.read(row_id_, max_bytes, bytes_) != Outcome::kFound) {
    count_damage(database_.last_error());
    return false;
  }
  num_bytes_left_ -= bytes_.size();
  message = {topic, {rows_->integer(2)}, bytes_, static_cast<std::uint64_t>(row_id_)};
  const std::string damage = packed_message_.unpack(topics()[topic].encoding, message);
  if (!damage.empty()) count_damage(damage);
  return damage.empty();
}

void Rosbag2Sqlite::count_damage(const std::string& reason) {
  problems().add(fmt::format("row {}", row_id_), reason);
}

}  // namespace setsquare
