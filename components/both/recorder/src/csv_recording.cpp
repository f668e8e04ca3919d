// SPDX-License-Identifier: Apache-2.0
#include "recorder/csv_recording.hpp"

#include <utility>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

CsvTables open_tables(const std::string& owner, const std::string& directory) {
  try {
    return CsvTables(directory);
  } catch (const ConfigError& error) {
    throw ConfigError(owner + ".directory: " + error.what());
  }
}

}  // namespace

CsvRecording::CsvRecording(std::string owner, const std::string& directory, Logger& log)
    : owner_(std::move(owner)), log_(log), tables_(open_tables(owner_, directory)) {}

std::size_t CsvRecording::add(const ChosenTopic& topic) {
  if (table_file(topic.info.name) == messages_file) {
    throw ConfigError(owner_ + ".topics: '" + topic.info.name + "' cannot be recorded: its file " +
                      "would be the one of all messages");
  }
  topics_.push_back({topic.info.name, topic.type});
  return topics_.size() - 1;
}

void CsvRecording::write(std::size_t topic, const Sample& sample) {
  const Topic& its = topics_.at(topic);
  const void* const content = sample.message.get();
  const std::size_t bytes = sample.bytes > 0 ? sample.bytes : its.type->serialized_size(content);
  tables_.write({its.name, sample.received_wall_ns, sample.sent_wall_ns, sample.source,
                 sample.sequence, bytes},
                its.type, content);
  for (const std::string& problem : tables_.take_problems()) log_.error("{}", problem);
}

}  // namespace tocsin
