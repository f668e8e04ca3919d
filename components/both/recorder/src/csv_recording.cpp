// SPDX-License-Identifier: Apache-2.0
#include "recorder/csv_recording.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "foundation/error.hpp"
#include "recorder/flat_message.hpp"

namespace tocsin {
namespace {

constexpr const char* messages_file = "messages.csv";

/// Nanoseconds as seconds with all digits.
std::string seconds_text(std::int64_t ns) {
  constexpr std::int64_t second = 1'000'000'000;
  std::string fraction = std::to_string(ns % second);
  return std::to_string(ns / second) + "." + std::string(9 - fraction.size(), '0') + fraction;
}

std::string file_of(std::string topic) {
  std::replace(topic.begin(), topic.end(), '/', '.');
  return topic + ".csv";
}

}  // namespace

CsvRecording::CsvRecording(std::string owner, std::string directory, Logger& log)
    : owner_(std::move(owner)), directory_(std::move(directory)), log_(log) {
  std::error_code failed;
  std::filesystem::create_directories(directory_, failed);
  if (failed) {
    throw ConfigError(owner_ + ".directory: " + directory_ +
                      " cannot be made: " + failed.message());
  }
  messages_ = std::make_unique<CsvFile>(
      directory_ + "/" + messages_file,
      std::vector<std::string>{"receive_s", "send_s", "topic", "writer", "sequence", "bytes"});
}

std::size_t CsvRecording::add(const ChosenTopic& topic) {
  if (file_of(topic.info.name) == messages_file) {
    throw ConfigError(owner_ + ".topics: '" + topic.info.name + "' cannot be recorded: its file " +
                      "would be the one of all messages");
  }
  tracks_.push_back({topic.info.name, topic.type, nullptr});
  return tracks_.size() - 1;
}

void CsvRecording::write(std::size_t topic, const Sample& sample) {
  Track& track = tracks_.at(topic);
  const std::string received = seconds_text(sample.received_wall_ns);
  const std::string sent = seconds_text(sample.sent_wall_ns);
  const std::size_t bytes =
      sample.bytes > 0 ? sample.bytes : track.type->serialized_size(sample.message.get());
  messages_->write({received, sent, track.topic, std::to_string(sample.source),
                    std::to_string(sample.sequence), std::to_string(bytes)});
  std::vector<std::string> columns{"receive_s", "send_s", "sequence"};
  std::vector<std::string> cells{received, sent, std::to_string(sample.sequence)};
  for (FlatField& field : flatten(*track.type, sample.message.get())) {
    columns.push_back(std::move(field.name));
    cells.push_back(std::move(field.value));
  }
  if (!track.fields) open(track, columns);
  if (track.fields) track.fields->write(cells);
}

void CsvRecording::open(Track& track, const std::vector<std::string>& columns) {
  try {
    track.fields = std::make_unique<CsvFile>(directory_ + "/" + file_of(track.topic), columns);
  } catch (const ConfigError& error) {
    log_.error("{}", error.what());
  }
}

void CsvRecording::flush() {
  (void)messages_->flush();
  for (Track& track : tracks_) {
    if (track.fields) (void)track.fields->flush();
  }
}

std::uint64_t CsvRecording::lost() const {
  std::uint64_t rows = messages_->lost();
  for (const Track& track : tracks_) {
    if (track.fields) rows += track.fields->lost();
  }
  return rows;
}

}  // namespace tocsin
