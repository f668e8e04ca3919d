// SPDX-License-Identifier: Apache-2.0
#include <sqlite3.h>

#include <cmath>

#include "database.hpp"
#include "foundation/error.hpp"

namespace tocsin::archive {
namespace {

constexpr int patience_ms = 10000;  // for another process that writes

class SqliteDatabase final : public Database {
 public:
  explicit SqliteDatabase(const std::string& path) : path_(path) {
    sqlite3* opened = nullptr;
    const int result = sqlite3_open(path.c_str(), &opened);
    handle_.reset(opened);
    if (result != SQLITE_OK) fail();
    (void)sqlite3_busy_timeout(opened, patience_ms);
  }
  [[nodiscard]] Dialect dialect() const override { return Dialect::sqlite; }
  std::vector<SqlRow> run(const std::string& statement,
                          const std::vector<SqlValue>& values) override {
    sqlite3_stmt* made = nullptr;
    if (sqlite3_prepare_v2(handle_.get(), statement.c_str(), -1, &made, nullptr) != SQLITE_OK) {
      fail();
    }
    const std::unique_ptr<sqlite3_stmt, decltype(&sqlite3_finalize)> prepared(made,
                                                                              sqlite3_finalize);
    for (std::size_t i = 0; i < values.size(); ++i) bind(made, i, values[i]);
    std::vector<SqlRow> rows;
    int result = sqlite3_step(made);
    for (; result == SQLITE_ROW; result = sqlite3_step(made)) rows.push_back(row_of(made));
    if (result != SQLITE_DONE) fail();
    return rows;
  }

 private:
  void bind(sqlite3_stmt* statement, std::size_t i, const SqlValue& value) {
    const std::string name = "$" + std::to_string(i + 1);
    const int place = sqlite3_bind_parameter_index(statement, name.c_str());
    int result = SQLITE_OK;
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
      result = sqlite3_bind_int64(statement, place, *whole);
    } else if (const auto* number = std::get_if<double>(&value)) {
      result = std::isnan(*number) ? sqlite3_bind_null(statement, place)
                                   : sqlite3_bind_double(statement, place, *number);
    } else {
      const std::string& text = std::get<std::string>(value);
      result = sqlite3_bind_text(statement, place, text.data(), static_cast<int>(text.size()),
                                 SQLITE_TRANSIENT);
    }
    if (result != SQLITE_OK) fail();
  }
  [[nodiscard]] static SqlRow row_of(sqlite3_stmt* statement) {
    SqlRow row;
    for (int i = 0; i < sqlite3_column_count(statement); ++i) {
      const unsigned char* const text = sqlite3_column_text(statement, i);
      row.emplace_back(text == nullptr ? "" : reinterpret_cast<const char*>(text));
    }
    return row;
  }
  [[noreturn]] void fail() const {
    throw EnvironmentError("index " + path_ + ": " + sqlite3_errmsg(handle_.get()));
  }
  const std::string path_;
  std::unique_ptr<sqlite3, decltype(&sqlite3_close)> handle_{nullptr, sqlite3_close};
};

}  // namespace

std::unique_ptr<Database> open_sqlite(const std::string& path) {
  return std::make_unique<SqliteDatabase>(path);
}

}  // namespace tocsin::archive
