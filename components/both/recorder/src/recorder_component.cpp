// SPDX-License-Identifier: Apache-2.0
#include "recorder/recorder_component.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "foundation/error.hpp"
#include "recorder/flat_message.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

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

RecorderComponent::RecorderComponent(Context& context, const Params& params)
    : Component(context),
      directory_(params.directory.empty() ? context.run_dir + "/" + context.role
                                          : params.directory),
      flush_period_(seconds(params.flush_period_s)) {
  std::error_code failed;
  std::filesystem::create_directories(directory_, failed);
  if (failed) {
    throw ConfigError(context.name + ".directory: " + directory_ +
                      " cannot be made: " + failed.message());
  }
  messages_ = std::make_unique<CsvFile>(
      directory_ + "/messages.csv",
      std::vector<std::string>{"receive_s", "send_s", "topic", "writer", "sequence", "bytes"});
  add_all(topic::AllLinkTopics{});
}

template <class... Topics>
void RecorderComponent::add_all(topic::List<Topics...>) {
  (tracks_.push_back({Topics::info.name, &type_info<typename Topics::Message>(),
                      std::make_unique<InputPort>(
                          *this, Endpoint{Topics::info, &type_info<typename Topics::Message>(),
                                          Writers::optional}),
                      nullptr}),
   ...);
}

void RecorderComponent::tick(Time now) {
  for (Track& track : tracks_) {
    while (const auto sample = track.input->take_sample()) record(track, *sample);
  }
  if (now >= next_flush_) flush(now);
  wake_at(next_flush_);
}

void RecorderComponent::record(Track& track, const Sample& sample) {
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

void RecorderComponent::open(Track& track, const std::vector<std::string>& columns) {
  try {
    track.fields = std::make_unique<CsvFile>(directory_ + "/" + file_of(track.topic), columns);
  } catch (const ConfigError& error) {
    log().error("{}", error.what());
  }
}

void RecorderComponent::flush(Time now) {
  next_flush_ = now + flush_period_;
  (void)messages_->flush();
  for (Track& track : tracks_) {
    if (track.fields) (void)track.fields->flush();
  }
  const std::uint64_t lost_before = std::exchange(lost_, lost());
  const bool was_full = std::exchange(disk_full_, lost_ > lost_before);
  if (disk_full_ != was_full) {
    if (disk_full_) {
      log().error("rows are being lost: {} cannot be written", directory_);
    } else {
      log().info("{} can be written again; {} rows were lost since the start", directory_, lost_);
    }
  }
}

std::uint64_t RecorderComponent::lost() const {
  std::uint64_t rows = messages_->lost();
  for (const Track& track : tracks_) {
    if (track.fields) rows += track.fields->lost();
  }
  return rows;
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::RecorderComponent)
