#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace wedgesim::reports {

class Database;

/// A prepared statement. Values are bound from the left, columns read from the left.
class Statement {
 public:
  Statement(Database& database, std::string_view sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  Statement& bind(std::string_view text);
  Statement& bind(std::int64_t number);
  Statement& bind(double number);
  Statement& bind_null();

  /// \return whether there is a row; after the last the statement can be bound anew
  bool step();
  /// Runs a statement without rows.
  void run();

  std::string text(int column) const;
  std::int64_t integer(int column) const;
  double number(int column) const;
  bool is_null(int column) const;

 private:
  void check_bound(int code);
  void reset();

  Database& database_;
  sqlite3_stmt* statement_ = nullptr;
  int bound_ = 0;
};

/// A SQLite file. What SQLite refuses is an InputError naming the file.
class Database {
 public:
  enum class Access {
    read,      // it must be there
    exclusive  // made if missing; nobody else may have it open
  };
  Database(const std::filesystem::path& file, Access access);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  void run(std::string_view sql);
  [[noreturn]] void fail(std::string_view what) const;

 private:
  friend class Statement;
  std::string file_;
  sqlite3* handle_ = nullptr;
};

/// What happens in its life is in the file whole or not at all; without commit(), not at all.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& database_;
  bool open_ = true;
};

}  // namespace wedgesim::reports
