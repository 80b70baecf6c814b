// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Recordings as rosbag2 writes them into SQLite, and what a source of messages reads, for the tests
// of recordings.
#pragma once

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bags/message_source.hpp"
#include "setsquare/io/bags/rosbag2_sqlite.hpp"
#include "setsquare/io/bytes/byte_source.hpp"
#include "tests/io/read_messages.hpp"
#include "tests/support/temporary_folder.hpp"

namespace setsquare::testing {

/// What was read, where each message was, and the error that ended it, if one did.
struct Reading : ReadRecording {
  std::vector<std::uint64_t> positions;
  std::string error;
};

using MakeSource = std::function<std::unique_ptr<MessageSource>()>;

inline Reading read_source(const MakeSource& make_source,
                           const MessageSource::IsWanted& is_wanted = {}) {
  Reading all;
  try {
    const std::unique_ptr<MessageSource> source = make_source();
    if (is_wanted) source->set_wanted(is_wanted);
    try {
      Message message;
      while (source->read(message)) {
        all.messages.push_back(
            {source->topics()[message.topic].name, message.log_time.ns, std::string(message.data)});
        all.positions.push_back(message.position);
      }
      EXPECT_TRUE(std::is_sorted(all.positions.begin(), all.positions.end()));
      EXPECT_FALSE(source->read(message));  // the end stays the end
    } catch (const Error& error) {
      all.error = error.what();
    }
    all.topics = source->topics();
    all.num_messages = source->num_messages();
    all.problems = source->problems();
  } catch (const Error& error) {
    all.error = error.what();
  }
  return all;
}

/// A database that a test fills.
class DatabaseWriter {
 public:
  explicit DatabaseWriter(const std::string& path, int page_bytes = 4096) {
    EXPECT_EQ(sqlite3_open(path.c_str(), &connection_), SQLITE_OK) << path;
    run("PRAGMA page_size = " + std::to_string(page_bytes));
    run("PRAGMA synchronous = OFF");
  }
  ~DatabaseWriter() { sqlite3_close(connection_); }
  DatabaseWriter(const DatabaseWriter&) = delete;
  DatabaseWriter& operator=(const DatabaseWriter&) = delete;

  void run(const std::string& sql) {
    char* error = nullptr;
    EXPECT_EQ(sqlite3_exec(connection_, sql.c_str(), nullptr, nullptr, &error), SQLITE_OK)
        << sql << ": " << (error != nullptr ? error : "");
    sqlite3_free(error);
  }

  void insert_message(std::int64_t topic_id, std::int64_t time_ns, const std::string& bytes) {
    sqlite3_stmt* insert = nullptr;
    sqlite3_prepare_v2(connection_,
                       "INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)",
                       -1,
                       &insert,
                       nullptr);
    sqlite3_bind_int64(insert, 1, topic_id);
    sqlite3_bind_int64(insert, 2, time_ns);
    sqlite3_bind_blob(insert, 3, bytes.data(), static_cast<int>(bytes.size()), SQLITE_STATIC);
    EXPECT_EQ(sqlite3_step(insert), SQLITE_DONE);
    sqlite3_finalize(insert);
  }

  /// The tables of a recording, as the four versions have them.
  void create_tables(int version) {
    if (version >= 3) {
      run("CREATE TABLE schema(schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL)");
      run("CREATE TABLE metadata(id INTEGER PRIMARY KEY, metadata_version INTEGER NOT NULL, "
          "metadata TEXT NOT NULL)");
    }
    std::string more_columns;
    if (version >= 2) more_columns += ", offered_qos_profiles TEXT NOT NULL DEFAULT ''";
    if (version >= 4) more_columns += ", type_description_hash TEXT NOT NULL DEFAULT ''";
    run("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
        "serialization_format TEXT NOT NULL" +
        more_columns + ")");
    if (version >= 4) {
      run("CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL, "
          "encoding TEXT NOT NULL, encoded_message_definition TEXT NOT NULL, "
          "type_description_hash TEXT NOT NULL)");
    }
    run("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp "
        "INTEGER NOT NULL, data BLOB NOT NULL)");
    run("CREATE INDEX timestamp_idx ON messages (timestamp ASC)");
  }

  void insert_topic(const std::string& name,
                    const std::string& type,
                    const std::string& serialization_format = "cdr") {
    run("INSERT INTO topics(name, type, serialization_format) VALUES ('" + name + "', '" + type +
        "', '" + serialization_format + "')");
  }

 private:
  sqlite3* connection_ = nullptr;
};

/// Bytes that begin as a message in CDR does, all different.
inline std::string cdr_bytes(std::size_t num_bytes, std::size_t seed = 0) {
  std::string bytes("\0\1\0\0", 4);
  for (std::size_t i = bytes.size(); i < num_bytes; ++i) {
    bytes.push_back(static_cast<char>((i * 7 + seed * 13 + i / 256) % 251 + 1));
  }
  return bytes;
}

/// Messages of /scan and /camera/image_raw in turn, some longer than several small pages.
inline std::vector<ReadMessage> made_up_messages(std::size_t num_messages,
                                                 std::int64_t begin_ns = 1000) {
  std::vector<ReadMessage> messages;
  for (std::size_t i = 0; i < num_messages; ++i) {
    const bool is_scan = i % 2 == 0;
    messages.push_back({is_scan ? "/scan" : "/camera/image_raw",
                        begin_ns + static_cast<std::int64_t>(i),
                        cdr_bytes(is_scan ? 100 + i : 37 * i % 1800 + 5, i)});
  }
  return messages;
}

/// Writes made-up messages as a recording.
inline void write_recording(const std::string& path,
                            const std::vector<ReadMessage>& messages,
                            int version = 3,
                            int page_bytes = 4096) {
  DatabaseWriter database(path, page_bytes);
  database.run("BEGIN");
  database.create_tables(version);
  database.insert_topic("/scan",
                        version % 2 == 0 ? "sensor_msgs/msg/LaserScan" : "sensor_msgs/LaserScan");
  database.insert_topic("/camera/image_raw", "sensor_msgs/msg/Image");
  for (const ReadMessage& message : messages) {
    database.insert_message(message.topic == "/scan" ? 1 : 2, message.time_ns, message.data);
  }
  database.run("COMMIT");
}

/// The bytes of such a recording.
inline std::string recording_bytes(const std::vector<ReadMessage>& messages,
                                   int version = 3,
                                   int page_bytes = 4096) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "recording.db3").string();
  write_recording(path, messages, version, page_bytes);
  return content_of(path);
}

/// Of a file.
inline Reading read_file(const std::filesystem::path& path,
                         const MessageSource::IsWanted& is_wanted = {}) {
  return read_source([&] { return std::make_unique<Rosbag2Sqlite>(path.string()); }, is_wanted);
}

/// Bytes that come in order, as through a pipe.
inline Reading read_bytes(const std::string& bytes, const MessageSource::IsWanted& is_wanted = {}) {
  return read_source(
      [&] {
        return std::make_unique<Rosbag2Sqlite>(unpack(make_memory_source(bytes)), "test.db3");
      },
      is_wanted);
}

/// Read by SQLite itself, the plain way.
inline std::vector<ReadMessage> read_by_sqlite(const std::filesystem::path& path) {
  std::vector<ReadMessage> messages;
  sqlite3* connection = nullptr;
  EXPECT_EQ(sqlite3_open(path.c_str(), &connection), SQLITE_OK);
  sqlite3_stmt* query = nullptr;
  EXPECT_EQ(sqlite3_prepare_v2(connection,
                               "SELECT name, timestamp, data FROM messages JOIN topics ON "
                               "topics.id = topic_id ORDER BY messages.id",
                               -1,
                               &query,
                               nullptr),
            SQLITE_OK);
  while (sqlite3_step(query) == SQLITE_ROW) {
    const auto text_of = [&query](int column) {
      const auto* const begin = static_cast<const char*>(sqlite3_column_blob(query, column));
      const int num_bytes = sqlite3_column_bytes(query, column);
      return std::string(begin, begin + num_bytes);
    };
    messages.push_back({text_of(0), sqlite3_column_int64(query, 1), text_of(2)});
  }
  sqlite3_finalize(query);
  sqlite3_close(connection);
  return messages;
}

/// What is in a folder.
inline std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.insert(entry.path().filename());
  return names;
}

}  // namespace setsquare::testing
