#include "reports/runner/sqlite.h"

#include <sqlite3.h>

#include "base/error.h"

namespace wedgesim::reports {

Statement::Statement(Database& database, std::string_view sql) : database_(database) {
  const int code = sqlite3_prepare_v2(database.handle_, sql.data(), static_cast<int>(sql.size()),
                                      &statement_, nullptr);
  if (code != SQLITE_OK) database.fail(sqlite3_errmsg(database.handle_));
}

Statement::~Statement() { sqlite3_finalize(statement_); }

void Statement::check_bound(int code) {
  if (code != SQLITE_OK) database_.fail(sqlite3_errmsg(database_.handle_));
}

Statement& Statement::bind(std::string_view text) {
  check_bound(sqlite3_bind_text(statement_, ++bound_, text.data(), static_cast<int>(text.size()),
                                SQLITE_TRANSIENT));
  return *this;
}

Statement& Statement::bind(std::int64_t number) {
  check_bound(sqlite3_bind_int64(statement_, ++bound_, number));
  return *this;
}

Statement& Statement::bind(double number) {
  check_bound(sqlite3_bind_double(statement_, ++bound_, number));
  return *this;
}

Statement& Statement::bind_null() {
  check_bound(sqlite3_bind_null(statement_, ++bound_));
  return *this;
}

void Statement::reset() {
  sqlite3_reset(statement_);
  sqlite3_clear_bindings(statement_);
  bound_ = 0;
}

bool Statement::step() {
  const int code = sqlite3_step(statement_);
  if (code == SQLITE_ROW) return true;
  const std::string message = sqlite3_errmsg(database_.handle_);
  reset();
  if (code != SQLITE_DONE) database_.fail(message);
  return false;
}

void Statement::run() {
  while (step()) {
  }
}

std::string Statement::text(int column) const {
  const auto* text = sqlite3_column_text(statement_, column);
  if (text == nullptr) return {};
  return {reinterpret_cast<const char*>(text),
          static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))};
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_, column);
}

double Statement::number(int column) const { return sqlite3_column_double(statement_, column); }

bool Statement::is_null(int column) const {
  return sqlite3_column_type(statement_, column) == SQLITE_NULL;
}

Database::Database(const std::filesystem::path& file, Access access) : file_(file.string()) {
  const int flags =
      access == Access::read ? SQLITE_OPEN_READWRITE : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  try {
    if (sqlite3_open_v2(file_.c_str(), &handle_, flags, nullptr) != SQLITE_OK) {
      fail(sqlite3_errmsg(handle_));
    }
    if (access == Access::read) return;
    // A commit is then one append, and needs no file of shared memory beside it.
    run("PRAGMA locking_mode = EXCLUSIVE");
    run("PRAGMA journal_mode = WAL");
    run("PRAGMA synchronous = NORMAL");
    run("BEGIN EXCLUSIVE");
    run("COMMIT");
  } catch (...) {
    sqlite3_close(handle_);
    throw;
  }
}

Database::~Database() { sqlite3_close(handle_); }

void Database::run(std::string_view sql) { Statement(*this, sql).run(); }

void Database::fail(std::string_view what) const {
  if (sqlite3_errcode(handle_) == SQLITE_BUSY) {
    throw InputError(file_, "another run works on it", "a folder of its own, or to wait");
  }
  throw InputError(file_, what, "a database of results that can be read and written");
}

Transaction::Transaction(Database& database) : database_(database) { database_.run("BEGIN"); }

Transaction::~Transaction() {
  if (!open_) return;
  try {
    database_.run("ROLLBACK");
  } catch (const InputError&) {  // SQLite has rolled back already
  }
}

void Transaction::commit() {
  database_.run("COMMIT");
  open_ = false;
}

}  // namespace wedgesim::reports
