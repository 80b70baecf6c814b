// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "setsquare/io/bags/sqlite/pages.hpp"

struct sqlite3;
struct sqlite3_blob;
struct sqlite3_stmt;

namespace setsquare::sqlite {

struct PageAccess;

/// How an access to a database ended.
enum class Outcome {
  kFound,    ///< There is a row, or a value.
  kNone,     ///< There is no more.
  kDamaged,  ///< What is there cannot be read; Database::last_error() says why.
};

/// An SQLite database from strangers, read through SQLite's own library, which gets at nothing but
/// the pages: it writes nowhere, opens no other file, and trusts no schema.
class Database {
 public:
  /// Throws FormatError where SQLite does not take it.
  explicit Database(Pages pages);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  /// Names of the tables that hold rows of their own (no views, no virtual tables).
  [[nodiscard]] std::vector<std::string> tables();

  /// Names of a table's columns. The table's name must be a plain word.
  [[nodiscard]] std::vector<std::string> columns(const std::string& table);

  [[nodiscard]] const Pages& pages() const;

  /// Why the last access was kDamaged.
  [[nodiscard]] const std::string& last_error() const { return last_error_; }

 private:
  friend class Statement;
  friend class Blob;

  [[nodiscard]] Outcome outcome_of(int result_code);
  [[nodiscard]] Outcome damage(std::string reason);
  [[nodiscard]] std::vector<std::string> names(const std::string& sql);

  std::unique_ptr<PageAccess> access_;
  sqlite3* connection_ = nullptr;
  std::string last_error_;
};

/// A query, with at most one parameter.
class Statement {
 public:
  /// Throws FormatError where the database has no such tables and columns.
  Statement(Database& database, const std::string& sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  /// Begins again, with the parameter's value.
  void restart(std::int64_t parameter);

  /// The next row. Throws FileError where the file cannot be read.
  [[nodiscard]] Outcome step();

  [[nodiscard]] bool is_integer(int column) const;
  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] std::string text(int column) const;

 private:
  Database& database_;
  sqlite3_stmt* statement_ = nullptr;
};

/// The values of one column, of which no more is read than is asked for.
class Blob {
 public:
  Blob(Database& database, std::string table, std::string column);
  ~Blob();
  Blob(const Blob&) = delete;
  Blob& operator=(const Blob&) = delete;

  /// Reads a row's value. Memory grows as bytes arrive, whatever length the row claims. A claim
  /// above `max_bytes` is damage. Throws FileError where the file cannot be read.
  [[nodiscard]] Outcome read(std::int64_t row_id, std::size_t max_bytes, std::string& value);

 private:
  [[nodiscard]] Outcome open(std::int64_t row_id);

  Database& database_;
  std::string table_;
  std::string column_;
  sqlite3_blob* blob_ = nullptr;
};

}  // namespace setsquare::sqlite
