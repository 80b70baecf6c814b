// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bags/sqlite/database.hpp"

#include <fmt/core.h>
#include <sqlite3.h>

#include <algorithm>
#include <exception>
#include <new>
#include <span>
#include <utility>

#include "setsquare/core/error.hpp"

namespace setsquare::sqlite {
namespace {

/// Names and definitions are shorter; a longer text is damage.
constexpr int kMaxTextBytes = 1 << 22;

/// Steps of SQLite's machine for one row. A whole recording's schema takes a thousand; pages that
/// lead in circles would take for ever.
constexpr int kStepsPerCheck = 1000;
constexpr int kMaxChecks = 10000;

/// Tables of a database, columns of a table.
constexpr std::size_t kMaxNames = 1000;

constexpr std::size_t kFirstReadBytes = 1 << 16;

}  // namespace

/// What SQLite is given in place of a file system: one open file, the database.
struct PageAccess {
  explicit PageAccess(Pages all_pages);
  ~PageAccess() { sqlite3_vfs_unregister(&file_system); }
  PageAccess(const PageAccess&) = delete;
  PageAccess& operator=(const PageAccess&) = delete;

  Pages pages;
  std::exception_ptr failure;  ///< What a read ended with; exceptions cannot pass through SQLite.
  int num_checks = 0;          ///< Since the last row.
  std::string name;            ///< Of this file system among SQLite's.
  sqlite3_vfs file_system{};
};

namespace {

struct OpenPages {
  sqlite3_file file;  ///< First, as SQLite wants it.
  PageAccess* access;
};

PageAccess& access_of(sqlite3_file* file) { return *reinterpret_cast<OpenPages*>(file)->access; }

int read_pages(sqlite3_file* file, void* into, int num_bytes, sqlite3_int64 offset) {
  PageAccess& access = access_of(file);
  const std::span<char> bytes(static_cast<char*>(into), static_cast<std::size_t>(num_bytes));
  const auto begin = static_cast<std::uint64_t>(offset);
  try {
    const std::size_t num_read = access.pages.read_at(begin, bytes);
    if (num_read == bytes.size()) return SQLITE_OK;
    std::ranges::fill(bytes.subspan(num_read), '\0');
    return begin < access.pages.size_bytes() ? SQLITE_CORRUPT : SQLITE_IOERR_SHORT_READ;
  } catch (...) {
    access.failure = std::current_exception();
    return SQLITE_IOERR_READ;
  }
}

int tell_size(sqlite3_file* file, sqlite3_int64* num_bytes) {
  *num_bytes = static_cast<sqlite3_int64>(access_of(file).pages.size_bytes());
  return SQLITE_OK;
}

/// A file that cannot change needs no locks, no journal and no shared memory.
const sqlite3_io_methods kPageMethods = {
    .iVersion = 1,
    .xClose = [](sqlite3_file*) { return SQLITE_OK; },
    .xRead = read_pages,
    .xWrite = [](sqlite3_file*, const void*, int, sqlite3_int64) { return SQLITE_READONLY; },
    .xTruncate = [](sqlite3_file*, sqlite3_int64) { return SQLITE_READONLY; },
    .xSync = [](sqlite3_file*, int) { return SQLITE_OK; },
    .xFileSize = tell_size,
    .xLock = [](sqlite3_file*, int) { return SQLITE_OK; },
    .xUnlock = [](sqlite3_file*, int) { return SQLITE_OK; },
    .xCheckReservedLock =
        [](sqlite3_file*, int* is_reserved) {
          *is_reserved = 0;
          return SQLITE_OK;
        },
    .xFileControl = [](sqlite3_file*, int, void*) { return SQLITE_NOTFOUND; },
    .xSectorSize = [](sqlite3_file*) { return 512; },
    .xDeviceCharacteristics = [](sqlite3_file*) { return SQLITE_IOCAP_IMMUTABLE; },
    .xShmMap = nullptr,
    .xShmLock = nullptr,
    .xShmBarrier = nullptr,
    .xShmUnmap = nullptr,
    .xFetch = nullptr,
    .xUnfetch = nullptr,
};

int open_pages(
    sqlite3_vfs* file_system, const char*, sqlite3_file* file, int flags, int* flags_out) {
  file->pMethods = nullptr;
  if ((flags & SQLITE_OPEN_MAIN_DB) == 0) return SQLITE_CANTOPEN;
  auto* const opened = reinterpret_cast<OpenPages*>(file);
  opened->file.pMethods = &kPageMethods;
  opened->access = static_cast<PageAccess*>(file_system->pAppData);
  if (flags_out != nullptr) *flags_out = flags;
  return SQLITE_OK;
}

int keep_name(sqlite3_vfs*, const char* name, int num_bytes, char* full_name) {
  sqlite3_snprintf(num_bytes, full_name, "%s", name);
  return SQLITE_OK;
}

}  // namespace

PageAccess::PageAccess(Pages all_pages)
    : pages(std::move(all_pages)), name(fmt::format("setsquare {}", static_cast<void*>(this))) {
  // Random numbers and the time still come from the system.
  file_system = *sqlite3_vfs_find(nullptr);
  file_system.pNext = nullptr;
  file_system.szOsFile = sizeof(OpenPages);
  file_system.zName = name.c_str();
  file_system.pAppData = this;
  file_system.xOpen = open_pages;
  file_system.xDelete = [](sqlite3_vfs*, const char*, int) { return SQLITE_READONLY; };
  file_system.xAccess = [](sqlite3_vfs*, const char*, int, int* is_there) {
    *is_there = 0;
    return SQLITE_OK;
  };
  file_system.xFullPathname = keep_name;
  if (sqlite3_vfs_register(&file_system, 0) != SQLITE_OK) throw std::bad_alloc();
}

Database::Database(Pages pages) : access_(std::make_unique<PageAccess>(std::move(pages))) {
  const int opened = sqlite3_open_v2(
      "recording", &connection_, SQLITE_OPEN_READONLY | SQLITE_OPEN_NOMUTEX, access_->name.c_str());
  if (connection_ == nullptr) throw std::bad_alloc();
  if (opened != SQLITE_OK) {
    const std::string reason = sqlite3_errmsg(connection_);
    sqlite3_close(connection_);
    throw FormatError(access_->pages.name(), "", reason);
  }
  // A schema that is partly wrong does not keep us from the tables that are right.
  sqlite3_db_config(connection_, SQLITE_DBCONFIG_DEFENSIVE, 0, nullptr);
  sqlite3_db_config(connection_, SQLITE_DBCONFIG_WRITABLE_SCHEMA, 1, nullptr);
  sqlite3_db_config(connection_, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_limit(connection_, SQLITE_LIMIT_LENGTH, kMaxTextBytes);
  const auto check = [](void* access) {
    return static_cast<int>(++static_cast<PageAccess*>(access)->num_checks > kMaxChecks);
  };
  sqlite3_progress_handler(connection_, kStepsPerCheck, check, access_.get());
}

Database::~Database() { sqlite3_close(connection_); }

const Pages& Database::pages() const { return access_->pages; }

Outcome Database::damage(std::string reason) {
  last_error_ = std::move(reason);
  return Outcome::kDamaged;
}

Outcome Database::outcome_of(int result_code) {
  access_->num_checks = 0;
  if (access_->failure) std::rethrow_exception(std::exchange(access_->failure, nullptr));
  if (result_code == SQLITE_OK || result_code == SQLITE_ROW) return Outcome::kFound;
  if (result_code == SQLITE_DONE) return Outcome::kNone;
  // SQLite says so of some damaged definitions of tables too.
  if (result_code == SQLITE_NOMEM) return damage("out of memory, or a damaged schema");
  return damage(sqlite3_errmsg(connection_));
}

std::vector<std::string> Database::names(const std::string& sql) {
  Statement query(*this, sql);
  std::vector<std::string> found;
  while (found.size() < kMaxNames && query.step() == Outcome::kFound) {
    found.push_back(query.text(0));
  }
  return found;
}

std::vector<std::string> Database::tables() {
  return names("SELECT name FROM sqlite_master WHERE type = 'table' AND rootpage > 0");
}

std::vector<std::string> Database::columns(const std::string& table) {
  return names(fmt::format("SELECT name FROM pragma_table_info('{}')", table));
}

Statement::Statement(Database& database, const std::string& sql) : database_(database) {
  const int prepared =
      sqlite3_prepare_v2(database.connection_, sql.c_str(), -1, &statement_, nullptr);
  if (database.outcome_of(prepared) == Outcome::kFound) return;
  throw FormatError(database.pages().name(), "", database.last_error());
}

Statement::~Statement() { sqlite3_finalize(statement_); }

void Statement::restart(std::int64_t parameter) {
  sqlite3_reset(statement_);
  sqlite3_bind_int64(statement_, 1, parameter);
}

Outcome Statement::step() { return database_.outcome_of(sqlite3_step(statement_)); }

bool Statement::is_integer(int column) const {
  return sqlite3_column_type(statement_, column) == SQLITE_INTEGER;
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_, column);
}

std::string Statement::text(int column) const {
  const unsigned char* const text = sqlite3_column_text(statement_, column);
  if (text == nullptr) return {};
  const auto num_bytes = static_cast<std::size_t>(sqlite3_column_bytes(statement_, column));
  return {text, text + num_bytes};
}

Blob::Blob(Database& database, std::string table, std::string column)
    : database_(database), table_(std::move(table)), column_(std::move(column)) {}

Blob::~Blob() { sqlite3_blob_close(blob_); }

Outcome Blob::open(std::int64_t row_id) {
  if (blob_ != nullptr && sqlite3_blob_reopen(blob_, row_id) == SQLITE_OK) return Outcome::kFound;
  // What failed once cannot be opened for another row.
  sqlite3_blob_close(std::exchange(blob_, nullptr));
  return database_.outcome_of(sqlite3_blob_open(
      database_.connection_, "main", table_.c_str(), column_.c_str(), row_id, 0, &blob_));
}

Outcome Blob::read(std::int64_t row_id, std::size_t max_bytes, std::string& value) {
  value.clear();
  const Outcome opened = open(row_id);
  if (opened != Outcome::kFound) return opened;
  const auto num_bytes = static_cast<std::size_t>(sqlite3_blob_bytes(blob_));
  if (num_bytes > max_bytes) {
    return database_.damage(fmt::format("a length of {} bytes is not possible", num_bytes));
  }
  while (value.size() < num_bytes) {
    const std::size_t begin = value.size();
    const std::size_t num_more =
        std::min(num_bytes - begin, std::max(kFirstReadBytes, value.size()));
    value.resize(begin + num_more);
    const Outcome outcome = database_.outcome_of(sqlite3_blob_read(
        blob_, value.data() + begin, static_cast<int>(num_more), static_cast<int>(begin)));
    if (outcome != Outcome::kFound) return outcome;
  }
  return Outcome::kFound;
}

}  // namespace setsquare::sqlite
