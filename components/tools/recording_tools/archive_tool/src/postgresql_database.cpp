// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <libpq-fe.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "database.hpp"
#include "foundation/error.hpp"

namespace tocsin::archive {
namespace {

/// NULL is nothing.
std::optional<std::string> text_of(const SqlValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  const double number = std::get<double>(value);
  return std::isnan(number) ? std::nullopt : std::optional(fmt::format("{}", number));
}

class PostgresqlDatabase final : public Database {
 public:
  explicit PostgresqlDatabase(const std::string& url)
      : connection_(PQconnectdb(url.c_str()), PQfinish) {
    if (PQstatus(connection_.get()) != CONNECTION_OK) fail();
    (void)PQsetNoticeProcessor(
        connection_.get(), [](void*, const char*) {}, nullptr);
  }
  [[nodiscard]] Dialect dialect() const override { return Dialect::postgresql; }
  std::vector<SqlRow> run(const std::string& statement,
                          const std::vector<SqlValue>& values) override {
    std::vector<std::optional<std::string>> texts;
    for (const SqlValue& value : values) texts.push_back(text_of(value));
    std::vector<const char*> given;
    for (const auto& text : texts) given.push_back(text ? text->c_str() : nullptr);
    const std::unique_ptr<PGresult, decltype(&PQclear)> result(
        PQexecParams(connection_.get(), statement.c_str(), static_cast<int>(given.size()), nullptr,
                     given.data(), nullptr, nullptr, 0),
        PQclear);
    const ExecStatusType status = PQresultStatus(result.get());
    if (status != PGRES_COMMAND_OK && status != PGRES_TUPLES_OK) fail();
    std::vector<SqlRow> rows(static_cast<std::size_t>(PQntuples(result.get())));
    for (std::size_t row = 0; row < rows.size(); ++row) {
      for (int column = 0; column < PQnfields(result.get()); ++column) {
        rows[row].emplace_back(PQgetvalue(result.get(), static_cast<int>(row), column));
      }
    }
    return rows;
  }

 private:
  [[noreturn]] void fail() const {
    std::string text = PQerrorMessage(connection_.get());
    std::replace(text.begin(), text.end(), '\n', ' ');
    while (!text.empty() && text.back() == ' ') text.pop_back();
    throw EnvironmentError("index: " + text);
  }
  const std::unique_ptr<PGconn, decltype(&PQfinish)> connection_;
};

}  // namespace

std::unique_ptr<Database> open_postgresql(const std::string& url) {
  return std::make_unique<PostgresqlDatabase>(url);
}

}  // namespace tocsin::archive
