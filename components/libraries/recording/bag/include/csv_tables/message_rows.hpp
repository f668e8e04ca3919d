// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "idl_support/type_info.hpp"

namespace tocsin {

/// A message that was recorded, without its fields.
struct RecordedMessage {
  std::string topic;                  ///< without leading slash
  std::int64_t received_wall_ns = 0;  ///< since the Unix epoch
  std::int64_t sent_wall_ns = 0;
  std::uint64_t writer = 0;
  std::uint64_t sequence = 0;  ///< of the writer
  std::size_t bytes = 0;       ///< serialised
};

/// Cells, and the names of their columns.
struct NamedRow {
  std::vector<std::string> columns;
  std::vector<std::string> cells;
};

/// The table with a row for each message of all topics.
inline constexpr const char* messages_file = "messages.csv";
/// The file of a topic's fields: its name with '.' for '/', and `.csv`.
[[nodiscard]] std::string table_file(std::string topic);

/// A row of messages.csv: receive_s, send_s, topic, writer, sequence, bytes.
[[nodiscard]] NamedRow message_row(const RecordedMessage& message);
/// A row of the topic's file: receive_s, send_s, sequence, and what flatten() makes of `content`, a
/// message of that type.
[[nodiscard]] NamedRow field_row(const RecordedMessage& message, const TypeInfo& type,
                                 const void* content);

/// One line of a CSV file, with its end.
[[nodiscard]] std::string csv_line(const std::vector<std::string>& cells);

}  // namespace tocsin
