// SPDX-License-Identifier: Apache-2.0
#include "csv_tables/message_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "csv_tables/flat_message.hpp"
#include "foundation/printable.hpp"

namespace tocsin {
namespace {

/// Nanoseconds as seconds with all digits.
std::string seconds_text(std::int64_t ns) {
  constexpr std::int64_t second = 1'000'000'000;
  return fmt::format("{}.{:09}", ns / second, ns % second);
}

}  // namespace

std::string table_file(std::string topic) {
  std::replace(topic.begin(), topic.end(), '/', '.');
  return topic + ".csv";
}

NamedRow message_row(const RecordedMessage& message) {
  return {{"receive_s", "send_s", "topic", "writer", "sequence", "bytes"},
          {seconds_text(message.received_wall_ns), seconds_text(message.sent_wall_ns),
           message.topic, std::to_string(message.writer), std::to_string(message.sequence),
           std::to_string(message.bytes)}};
}

NamedRow field_row(const RecordedMessage& message, const TypeInfo& type, const void* content) {
  NamedRow row{{"receive_s", "send_s", "sequence"},
               {seconds_text(message.received_wall_ns), seconds_text(message.sent_wall_ns),
                std::to_string(message.sequence)}};
  for (FlatField& field : flatten(type, content)) {
    row.columns.push_back(std::move(field.name));
    row.cells.push_back(std::move(field.value));
  }
  return row;
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) {
    if (&cell != &cells.front()) line += ',';
    line += csv_cell(cell, cell.size());
  }
  return line + '\n';
}

}  // namespace tocsin
