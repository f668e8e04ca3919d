// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace tocsin::archive {

/// A value of a statement. NaN is NULL.
using SqlValue = std::variant<std::int64_t, double, std::string>;
/// As text; NULL is empty.
using SqlRow = std::vector<std::string>;

enum class Dialect { sqlite, postgresql };

/// An SQL database: SQLite in a file, or PostgreSQL. One thread.
class Database {
 public:
  virtual ~Database() = default;
  [[nodiscard]] virtual Dialect dialect() const = 0;
  /// One statement with `$1`, `$2`, ... in place of values. Throws EnvironmentError with what the
  /// engine says.
  virtual std::vector<SqlRow> run(const std::string& statement,
                                  const std::vector<SqlValue>& values = {}) = 0;
};

/// Of `postgresql://...`, else of the SQLite file, which is made when it is absent. Throws
/// EnvironmentError when it cannot be reached or opened.
[[nodiscard]] std::unique_ptr<Database> open_database(const std::string& where);

[[nodiscard]] bool is_postgresql(const std::string& where);
[[nodiscard]] std::unique_ptr<Database> open_postgresql(const std::string& url);
[[nodiscard]] std::unique_ptr<Database> open_sqlite(const std::string& path);

/// A number of a column; NaN for NULL.
[[nodiscard]] double sql_number(const std::string& text);

/// What is done while it lives is done as a whole, or, without commit(), not at all.
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

}  // namespace tocsin::archive
