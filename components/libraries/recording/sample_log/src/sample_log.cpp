// SPDX-License-Identifier: Apache-2.0
#include "sample_log/sample_log.hpp"

#include <algorithm>
#include <chrono>
#include <set>

#include "active_segment.hpp"
#include "foundation/error.hpp"
#include "mcap/reader.hpp"
#include "numbered.hpp"
#include "sample_channel.hpp"
#include "segment_names.hpp"
#include "span.hpp"

namespace tocsin::sample_log {
namespace {

/// A log has about so many segments when it is full: what goes is the oldest of them.
constexpr std::uint64_t segments_of_a_log = 16;

}  // namespace

SampleLog::SampleLog(LogFiles& files, const LogLimits& limits, Instant at, LogUse use)
    : files_(files), limits_(limits), use_(use), confirmed_(files, "confirmed") {
  for (const std::string& file : files_.names()) {
    const auto number = number_in(file, segment_name, segment_extension);
    if (number) recover(file, *number, at);
  }
  if (confirmed_.damaged() > 0) {
    problems_.push_back(std::to_string(confirmed_.damaged()) +
                        " records of what was confirmed are damaged: samples may be sent again");
  }
}

SampleLog::~SampleLog() = default;

void SampleLog::add(const LoggedStream& stream) {
  streams_.emplace(stream_key(stream.name), stream);
}

bool SampleLog::begin_segment() {
  const std::string file = numbered(segment_name, last_number_ + 1, segment_extension);
  try {
    active_ = std::make_unique<Active>(files_.make(file));
  } catch (const ConfigError& error) {
    if (!refuses_) problems_.emplace_back(error.what());
    return false;
  }
  segments_.push_back({file, ++last_number_, 0, {}, {}});
  return true;
}

std::vector<Logged> SampleLog::append(const std::vector<LogEntry>& entries, Instant at) {
  std::vector<Logged> logged(entries.size(), Logged::waiting);
  std::vector<std::pair<const LogEntry*, std::uint64_t>> fresh;
  std::set<SampleId> seen;
  std::uint64_t log_time_ns = last_log_time_ns_;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const SampleId& id = entries[i].id;
    if (confirmed_.done().contains(id)) {
      logged[i] = Logged::confirmed;
      continue;
    }
    const bool is_there = waiting_.count(id) != 0 || known_.contains(id);
    if (is_there || !seen.insert(id).second) continue;
    log_time_ns = std::max(log_time_ns + 1, static_cast<std::uint64_t>(std::max(at.wall_ns, {})));
    fresh.emplace_back(&entries[i], log_time_ns);
    logged[i] = Logged::refused;
  }
  if (fresh.empty()) return logged;
  const bool was_refusing = refuses_;
  refuses_ =
      !(active_ || begin_segment()) || active_->append(fresh, streams_) == mcap::Kept::nothing;
  if (refuses_) {
    if (!was_refusing) problems_.emplace_back("there is no room for samples");
    return logged;
  }
  if (was_refusing) problems_.emplace_back("samples can be stored again");
  last_log_time_ns_ = log_time_ns;
  for (const auto& [entry, time_ns] : fresh) note(entry->id, time_ns);
  std::replace(logged.begin(), logged.end(), Logged::refused, Logged::kept);
  segments_.back().written = at.now;
  measure_segment();
  return logged;
}

void SampleLog::measure_segment() {
  const bool full = active_->bytes() >= limits_.bytes / segments_of_a_log;
  if (full) active_->close();
  segments_.back().bytes = active_->bytes();
  if (full) active_.reset();
}

void SampleLog::note(const SampleId& id, std::uint64_t log_time_ns) {
  if (use_ == LogUse::queue) waiting_[id] = {last_number_, log_time_ns};
  if (use_ == LogUse::history) known_.add(id);
  extend(segments_.back().spans, streams_.at(id.stream).topic, log_time_ns);
}

void SampleLog::confirm(const std::vector<SampleId>& ids) {
  for (const SampleId& id : ids) {
    waiting_.erase(id);
    confirmed_.add(id);
  }
  (void)confirmed_.save();  // what fails is tried again with the next
}

void SampleLog::forget(const std::vector<SampleId>& ids) {
  for (const SampleId& id : ids) waiting_.erase(id);
}

void SampleLog::remove_oldest(std::vector<SampleId>& retired) {
  const Segment oldest = segments_.front();
  segments_.pop_front();
  if (segments_.empty()) active_.reset();
  files_.remove(oldest.file);
  for (auto it = waiting_.begin(); it != waiting_.end();) {
    if (it->second.segment != oldest.number) {
      ++it;
      continue;
    }
    retired.push_back(it->first);
    it = waiting_.erase(it);
  }
}

std::vector<SampleId> SampleLog::retire(Time now) {
  std::vector<SampleId> retired;
  while (!segments_.empty()) {
    const bool too_many = bytes() > limits_.bytes && segments_.size() > 1;
    if (!too_many && now - segments_.front().written <= limits_.age) break;
    remove_oldest(retired);
  }
  return retired;
}

std::uint64_t SampleLog::bytes() const {
  std::uint64_t bytes = 0;
  for (const Segment& segment : segments_) bytes += segment.bytes;
  return bytes;
}

void SampleLog::sync() {
  if (active_) active_->sync();
  (void)confirmed_.save();
  confirmed_.sync();
}

void SampleLog::recover(const std::string& file, std::uint64_t number, Instant at) {
  Segment segment{file, number, 0, at.now, {}};
  last_number_ = std::max(last_number_, number);
  try {
    auto source = files_.open(file);
    segment.bytes = source->size();
    index(std::move(source), segment);
  } catch (const ConfigError& error) {
    problems_.emplace_back(error.what());
  }
  const auto age =
      std::chrono::nanoseconds(at.wall_ns - static_cast<std::int64_t>(last_log_time_ns_));
  if (last_log_time_ns_ > 0) segment.written = at.now - std::max<Duration>(age, Duration::zero());
  segments_.push_back(segment);
}

void SampleLog::index(std::unique_ptr<mcap::ByteSource> source, Segment& segment) {
  mcap::Reader reader(std::move(source), segment.file);
  const auto& channels = reader.summary().channels;
  const auto& schemas = reader.summary().schemas;
  for (const auto& [id, channel] : channels) {
    if (!key_of(channel)) continue;
    const auto schema = schemas.find(channel.schema_id);
    add(stream_of(channel, schema == schemas.end() ? mcap::Schema{} : schema->second));
  }
  mcap::Query in_order;
  in_order.order = mcap::Order::file;
  const auto messages = reader.messages(in_order);
  while (const auto message = messages->next()) {
    const auto channel = channels.find(message->channel_id);
    const auto key = channel == channels.end() ? std::nullopt : key_of(channel->second);
    if (!key) continue;
    last_log_time_ns_ = std::max(last_log_time_ns_, message->log_time_ns);
    extend(segment.spans, channel->second.topic, message->log_time_ns);
    const SampleId id = sample_id(*key, message->sequence);
    if (use_ == LogUse::history) {
      known_.add(id);
      continue;
    }
    if (!confirmed_.done().contains(id)) waiting_[id] = {segment.number, message->log_time_ns};
  }
  if (reader.damage().chunks > 0) {
    problems_.push_back(segment.file + ": " + std::to_string(reader.damage().chunks) +
                        " chunks are damaged and left out");
  }
}

std::vector<SampleId> SampleLog::waiting() const {
  std::vector<std::pair<std::uint64_t, SampleId>> by_time;
  for (const auto& [id, place] : waiting_) by_time.emplace_back(place.log_time_ns, id);
  std::sort(by_time.begin(), by_time.end());
  std::vector<SampleId> ids;
  for (const auto& entry : by_time) ids.push_back(entry.second);
  return ids;
}

std::vector<LoggedSpan> SampleLog::contents() const {
  std::map<std::string, LoggedSpan> all;
  for (const Segment& segment : segments_) {
    for (const auto& [topic, span] : segment.spans) {
      LoggedSpan& sum =
          all.try_emplace(topic, LoggedSpan{topic, 0, span.first_ns, 0}).first->second;
      sum.samples += span.samples;
      sum.first_ns = std::min(sum.first_ns, span.first_ns);
      sum.last_ns = std::max(sum.last_ns, span.last_ns);
    }
  }
  std::vector<LoggedSpan> list;
  for (auto& entry : all) list.push_back(std::move(entry.second));
  return list;
}

LogFinding SampleLog::find(const LogQuery& query) {
  LogFinding finding;
  for (const Segment& segment : segments_) {
    const auto span = segment.spans.find(query.topic);
    const bool overlaps = span != segment.spans.end() && span->second.first_ns <= query.to_ns &&
                          span->second.last_ns >= query.from_ns;
    if (overlaps) find(segment, query, finding);
    if (finding.next_ns) break;
  }
  return finding;
}

void SampleLog::find(const Segment& segment, const LogQuery& query, LogFinding& finding) {
  try {
    mcap::Reader reader(files_.open(segment.file), segment.file);
    const auto& channels = reader.summary().channels;
    mcap::Query in_time{query.from_ns, query.to_ns, {}, mcap::Order::file};
    in_time.wanted = [&query](const mcap::Channel& one) { return one.topic == query.topic; };
    const auto messages = reader.messages(in_time);
    while (const auto message = messages->next()) {
      const auto key = key_of(channels.at(message->channel_id));
      if (!key) continue;
      const SampleId id = sample_id(*key, message->sequence);
      if (confirmed_.done().contains(id)) continue;
      if (finding.ids.size() >= query.most) {
        finding.next_ns = message->log_time_ns;
        return;
      }
      waiting_[id] = {segment.number, message->log_time_ns};
      finding.ids.push_back(id);
    }
  } catch (const ConfigError& error) {
    problems_.emplace_back(error.what());
  }
}

std::vector<LogEntry> SampleLog::read(const std::vector<SampleId>& ids) {
  std::map<std::uint64_t, std::map<std::uint64_t, SampleId>> wanted;
  for (const SampleId& id : ids) {
    const auto place = waiting_.find(id);
    if (place != waiting_.end()) wanted[place->second.segment][place->second.log_time_ns] = id;
  }
  std::vector<LogEntry> found;
  for (const Segment& segment : segments_) {
    const auto here = wanted.find(segment.number);
    if (here != wanted.end()) read(segment, here->second, found);
  }
  return found;
}

void SampleLog::read(const Segment& segment, const std::map<std::uint64_t, SampleId>& wanted,
                     std::vector<LogEntry>& found) {
  try {
    mcap::Reader reader(files_.open(segment.file), segment.file);
    mcap::Query query;
    query.from_ns = wanted.begin()->first;
    query.to_ns = wanted.rbegin()->first;
    query.order = mcap::Order::file;
    const auto messages = reader.messages(query);
    while (const auto message = messages->next()) {
      const auto id = wanted.find(message->log_time_ns);
      if (id == wanted.end()) continue;
      found.push_back({id->second,
                       static_cast<std::int64_t>(message->publish_time_ns),
                       {message->data, message->data + message->size}});
    }
  } catch (const ConfigError& error) {
    problems_.emplace_back(error.what());
  }
}

}  // namespace tocsin::sample_log
