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
  messages_ = std::make_unique<CsvFile>(folder_ + "/" + messages_file, message_row({}).columns);
}

void CsvTables::write(const RecordedMessage& message, const TypeInfo* type, const void* content) {
  messages_->write(message_row(message).cells);
  if (type == nullptr) return;
  const NamedRow row = field_row(message, *type, content);
  if (CsvFile* const file = file_of(message.topic, row.columns)) file->write(row.cells);
}

CsvFile* CsvTables::file_of(const std::string& topic, const std::vector<std::string>& columns) {
  auto& file = topics_[topic];
  if (file) return file.get();
  try {
    file = std::make_unique<CsvFile>(folder_ + "/" + table_file(topic), columns);
  } catch (const ConfigError& error) {
    problems_.emplace_back(error.what());
  }
  return file.get();
}

void CsvTables::flush() {
  (void)messages_->flush();
  for (const auto& entry : topics_) {
    if (entry.second) (void)entry.second->flush();
  }
}

std::uint64_t CsvTables::lost() const {
  std::uint64_t rows = messages_->lost();
  for (const auto& entry : topics_) {
    if (entry.second) rows += entry.second->lost();
  }
  return rows;
}

std::vector<std::string> CsvTables::take_problems() { return std::exchange(problems_, {}); }

}  // namespace tocsin
