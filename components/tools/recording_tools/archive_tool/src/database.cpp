// SPDX-License-Identifier: Apache-2.0
#include "database.hpp"

#include <charconv>
#include <limits>

#include "foundation/error.hpp"

namespace tocsin::archive {

bool is_postgresql(const std::string& where) {
  return where.rfind("postgresql://", 0) == 0 || where.rfind("postgres://", 0) == 0;
}

std::unique_ptr<Database> open_database(const std::string& where) {
  return is_postgresql(where) ? open_postgresql(where) : open_sqlite(where);
}

double sql_number(const std::string& text) {
  double number = std::numeric_limits<double>::quiet_NaN();
  (void)std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

Transaction::Transaction(Database& database) : database_(database) {
  // SQLite: the lock at once, so that two that read first do not wait for each other for ever.
  database_.run(database_.dialect() == Dialect::sqlite ? "BEGIN IMMEDIATE" : "BEGIN");
}

Transaction::~Transaction() {
  if (!open_) return;
  try {
    database_.run("ROLLBACK");
  } catch (const EnvironmentError&) {  // the engine is gone, and with it what was begun
  }
}

void Transaction::commit() {
  database_.run("COMMIT");
  open_ = false;
}

}  // namespace tocsin::archive
