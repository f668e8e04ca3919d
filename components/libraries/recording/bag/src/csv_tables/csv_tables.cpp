// SPDX-License-Identifier: Apache-2.0
#include "csv_tables/csv_tables.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include "foundation/error.hpp"

namespace tocsin {

CsvTables::CsvTables(std::string folder) : folder_(std::move(folder)) {
  std::error_code failed;
  std::filesystem::create_directories(folder_, failed);
  if (failed) throw ConfigError(folder_ + " cannot be made: " + failed.message());
  messages_.open(folder_ + "/" + messages_file);
  if (!messages_) throw ConfigError(folder_ + "/" + messages_file + " cannot be written");
  append(messages_, message_row({}).columns);
}

void CsvTables::write(const RecordedMessage& message, const TypeInfo* type, const void* content) {
  append(messages_, message_row(message).cells);
  if (type == nullptr) return;
  const NamedRow row = field_row(message, *type, content);
  const auto [found, is_new] = topics_.try_emplace(message.topic);
  if (is_new) {
    const std::string path = folder_ + "/" + table_file(message.topic);
    found->second.open(path);
    if (!found->second.is_open()) problems_.push_back(path + " cannot be written");
    append(found->second, row.columns);
  }
  append(found->second, row.cells);
}

void CsvTables::append(std::ofstream& file, const std::vector<std::string>& cells) {
  if (!file.is_open()) return;
  file.clear();
  if (!(file << csv_line(cells) << std::flush)) ++lost_;
}

std::vector<std::string> CsvTables::take_problems() { return std::exchange(problems_, {}); }

}  // namespace tocsin
