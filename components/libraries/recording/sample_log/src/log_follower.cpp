// SPDX-License-Identifier: Apache-2.0
#include "sample_log/log_follower.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "foundation/error.hpp"
#include "mcap/reader.hpp"
#include "numbered.hpp"
#include "sample_channel.hpp"
#include "segment_names.hpp"

namespace tocsin::sample_log {
namespace {

std::set<std::uint64_t> segments_of(const LogSource& files) {
  std::set<std::uint64_t> numbers;
  for (const std::string& name : files.names()) {
    const auto number = number_in(name, segment_name, segment_extension);
    if (number) numbers.insert(*number);
  }
  return numbers;
}

std::string file_of(std::uint64_t segment) {
  return numbered(segment_name, segment, segment_extension);
}

/// Empty when it cannot be read: the log has removed it.
std::unique_ptr<mcap::Reader> reader_of(const LogSource& files, std::uint64_t segment) {
  try {
    return std::make_unique<mcap::Reader>(files.open(file_of(segment)), file_of(segment));
  } catch (const ConfigError&) {
    return nullptr;
  }
}

/// Places of a topic's samples in a segment, in its order.
std::vector<std::uint64_t> places_in(mcap::Reader& reader, const std::string& topic) {
  mcap::Query query;
  query.order = mcap::Order::file;
  query.wanted = [&topic](const mcap::Channel& one) { return one.topic == topic && key_of(one); };
  std::vector<std::uint64_t> places;
  const auto messages = reader.messages(query);
  while (const auto message = messages->next()) places.push_back(message->log_time_ns);
  return places;
}

}  // namespace

LogFollower::LogFollower(const LogSource& files, std::string topic, const LogStart& start)
    : files_(files), topic_(std::move(topic)) {
  using From = LogStart::From;
  if (start.from == From::end) go_to_end();
  if (start.from == From::last) go_before_last(start.value);
  if (start.from == From::time) place_ = std::max<std::uint64_t>(start.value, 1) - 1;
  if (start.from == From::after) place_ = start.value;
  find_segment();
  if (start.from != From::after) has_gap_ = false;
}

LogFollower::Numbers LogFollower::segments() const { return segments_of(files_); }

void LogFollower::go_to_end() {
  const Numbers numbers = segments();
  for (auto it = numbers.rbegin(); it != numbers.rend() && place_ == 0; ++it) {
    if (const auto reader = reader_of(files_, *it)) place_ = reader->summary().statistics.end_ns;
  }
}

void LogFollower::go_before_last(std::uint64_t count) {
  const Numbers numbers = segments();
  if (count == 0) return go_to_end();
  for (auto it = numbers.rbegin(); it != numbers.rend() && count > 0; ++it) {
    const auto reader = reader_of(files_, *it);
    if (!reader) continue;
    const auto places = places_in(*reader, topic_);
    const auto here = std::min<std::uint64_t>(count, places.size());
    if (here > 0) place_ = places[places.size() - static_cast<std::size_t>(here)] - 1;
    count -= here;
  }
}

void LogFollower::find_segment() {
  const Numbers numbers = segments();
  for (auto it = numbers.rbegin(); it != numbers.rend(); ++it) {
    begin(*it);
    const auto reader = reader_of(files_, *it);
    if (!reader) continue;
    const mcap::Statistics& has = reader->summary().statistics;
    if (has.message_count > 0 && has.start_ns <= place_) return;
  }
  has_gap_ = place_ > 0 && !numbers.empty();
}

void LogFollower::begin(std::uint64_t segment) {
  segment_ = segment;
  tail_.emplace(file_of(segment));
  is_read_ = false;
}

std::vector<LogSample> LogFollower::read(std::size_t most) {
  std::vector<LogSample> came;
  // Listed before it is read: a segment that is followed by another one is read to its end.
  const Numbers numbers = segments();
  while (came.size() < most) {
    const auto next = numbers.upper_bound(segment_);
    if (segment_ != 0 && !read_segment(most, came)) break;
    if (next == numbers.end()) break;
    if (segment_ != 0 && *next != segment_ + 1) has_gap_ = true;
    begin(*next);
  }
  return came;
}

bool LogFollower::read_segment(std::size_t most, std::vector<LogSample>& came) {
  const std::uint64_t damaged_before = tail_->damaged_chunks();
  mcap::Tail::Step step = mcap::Tail::Step::read;
  try {
    const auto source = files_.open(file_of(segment_));
    while (step == mcap::Tail::Step::read && came.size() < most) {
      step = tail_->read(*source, [&](const mcap::Channel& channel, const mcap::Message& message) {
        take(channel, message, came);
      });
    }
    is_read_ = step == mcap::Tail::Step::ended;
  } catch (const ConfigError&) {  // the log has removed it
    if (!std::exchange(is_read_, true)) has_gap_ = true;
    step = mcap::Tail::Step::ended;
  }
  damaged_ += tail_->damaged_chunks() - damaged_before;
  return step != mcap::Tail::Step::read;
}

void LogFollower::take(const mcap::Channel& channel, const mcap::Message& message,
                       std::vector<LogSample>& came) {
  if (channel.topic != topic_ || message.log_time_ns <= place_) return;
  const auto key = key_of(channel);
  if (!key) return;
  const auto schema = tail_->schemas().find(channel.schema_id);
  const auto& stream =
      streams_
          .try_emplace(key->stream,
                       stream_of(channel, schema == tail_->schemas().end() ? mcap::Schema{}
                                                                           : schema->second))
          .first->second;
  place_ = message.log_time_ns;
  came.push_back({sample_id(*key, message.sequence),
                  &stream,
                  place_,
                  static_cast<std::int64_t>(message.publish_time_ns),
                  {message.data, message.data + message.size}});
}

std::set<std::string> topics_in(const LogSource& files) {
  std::set<std::string> topics;
  for (const std::uint64_t segment : segments_of(files)) {
    const auto reader = reader_of(files, segment);
    if (!reader) continue;
    for (const auto& [id, channel] : reader->summary().channels) {
      if (key_of(channel)) topics.insert(channel.topic);
    }
  }
  return topics;
}

}  // namespace tocsin::sample_log
