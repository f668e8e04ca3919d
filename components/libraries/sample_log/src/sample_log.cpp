// SPDX-License-Identifier: Apache-2.0
// Opening, writing and retiring; what is read is in reading.cpp.
#include "sample_log/sample_log.hpp"

#include <algorithm>
#include <chrono>
#include <set>

#include "active_segment.hpp"
#include "foundation/error.hpp"
#include "numbered.hpp"
#include "segment_names.hpp"
#include "span.hpp"

namespace tocsin::sample_log {
namespace {

/// A log has about so many segments when it is full: what goes is the oldest of them.
constexpr std::uint64_t segments_of_a_log = 16;

}  // namespace

SampleLog::SampleLog(LogFiles& files, const LogLimits& limits, Time now, std::int64_t wall_ns,
                     LogUse use)
    : files_(files), limits_(limits), use_(use), confirmed_(files, "confirmed") {
  for (const std::string& file : files_.names()) {
    const auto number = number_in(file, segment_name, segment_extension);
    if (number) recover(file, *number, now, wall_ns);
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

std::vector<Logged> SampleLog::append(const std::vector<LogEntry>& entries, Time now,
                                      std::int64_t wall_ns) {
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
    log_time_ns = std::max(log_time_ns + 1, static_cast<std::uint64_t>(std::max(wall_ns, {})));
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
  segments_.back().written = now;
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
  if (use_ == LogUse::history) (void)known_.add(id);
  extend(segments_.back().spans, streams_.at(id.stream).topic, log_time_ns);
}

void SampleLog::confirm(const std::vector<SampleId>& ids) {
  for (const SampleId& id : ids) {
    waiting_.erase(id);
    (void)confirmed_.add(id);
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

void SampleLog::recover(const std::string& file, std::uint64_t number, Time now,
                        std::int64_t wall_ns) {
  Segment segment{file, number, 0, now, {}};
  last_number_ = std::max(last_number_, number);
  try {
    auto source = files_.open(file);
    segment.bytes = source->size();
    index(std::move(source), segment);
  } catch (const ConfigError& error) {
    problems_.emplace_back(error.what());
  }
  const auto age = std::chrono::nanoseconds(wall_ns - static_cast<std::int64_t>(last_log_time_ns_));
  if (last_log_time_ns_ > 0) segment.written = now - std::max<Duration>(age, Duration::zero());
  segments_.push_back(segment);
}

}  // namespace tocsin::sample_log
