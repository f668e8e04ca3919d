// SPDX-License-Identifier: Apache-2.0
// What a SampleLog reads of its segments.
#include <algorithm>

#include "foundation/error.hpp"
#include "mcap/reader.hpp"
#include "sample_channel.hpp"
#include "sample_log/sample_log.hpp"
#include "span.hpp"

namespace tocsin::sample_log {

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
      (void)known_.add(id);
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
