// SPDX-License-Identifier: Apache-2.0
#include "station_stop.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "foundation/printable.hpp"

namespace tocsin {
namespace {

constexpr std::size_t most_vehicles = 64;
/// An older report says nothing of now.
constexpr Duration report_lives = std::chrono::seconds(1);

/// Nobody guesses it, in a simulation either: it changes no message of a host.
StopToken random_token() {
  std::random_device random;
  StopToken token{};
  for (std::size_t at = 0; at < token.size(); at += sizeof(std::uint32_t)) {
    const std::uint32_t word = random();
    std::memcpy(token.data() + at, &word, sizeof word);
  }
  return token;
}

}  // namespace

StationStop::StationStop(Component& owner, const StopKeysFile::Content& kept)
    : stop_(owner), request_(owner), speaker_(random_token) {
  latch_.restore({kept.stands, kept.others});
  std::vector<router::StopSpeaker::Press> presses;
  for (const auto& one : kept.tokens) presses.push_back({one.token, one.flag});
  speaker_.restore(presses);
}

EmergencyStopLatch::Writer StationStop::writer(std::uint64_t source) const {
  const auto known = stop_.writer(source);
  const std::string user_data = known ? known->user_data : "";
  const bool station = user_data.find(topic::EmergencyStop::station) != std::string::npos;
  return {source, station, known ? printable(known->name, StopValue::longest_name) : "gone"};
}

void StationStop::take_host(Time now) {
  while (const auto sample = stop_.take_sample()) {
    const auto* word = static_cast<const topic::EmergencyStop::Message*>(sample->message.get());
    if (word->data()) {
      latch_.press(writer(sample->source));
    } else {
      latch_.release(writer(sample->source),
                     [this](std::uint64_t id) { return stop_.writer(id).has_value(); });
    }
  }
  while (const auto request = request_.take()) {
    if (!request->data()) speaker_.on_release(now);
  }
  speaker_.on_host(latch_.stands(), now);
}

void StationStop::take(const StopNews& news, Time now) {
  take_host(now);
  for (const ReceivedStop& one : news.values) {
    if (one.value.role != Role::uxv) continue;
    speaker_.on_report(one.value.locks, now);
    if (reports_.size() >= most_vehicles && reports_.count(one.value.host) == 0) reports_.clear();
    reports_[one.value.host] = {one.value.known, one.value.stands, one.value.by, one.received};
  }
}

void StationStop::fill(StopValue& value, Time now) {
  speaker_.fill(value, now);
  value.by = latch_.others();
  if (latch_.stands_by_station()) {
    value.by.insert(value.by.begin(), topic::EmergencyStop::station_name);
  }
}

void StationStop::fill(topic::LinkStop::Message& message, Time now) {
  Duration silence = Duration::max();
  for (const auto& [host, report] : reports_) {
    silence = std::min(silence, now - report.received);
    if (now - report.received > report_lives || !report.known || !report.stands) continue;
    message.stands(true);
    for (const std::string& name : report.by) message.stopped_by().push_back(printable(name, 64));
  }
  message.silence_s(silence == Duration::max() ? std::numeric_limits<double>::quiet_NaN()
                                               : to_seconds(silence));
}

StopKeysFile::Content StationStop::kept() const {
  const auto memory = latch_.memory();
  StopKeysFile::Content content{memory.station, memory.others, {}};
  for (const auto& press : speaker_.presses())
    content.tokens.push_back({press.key, press.released});
  return content;
}

}  // namespace tocsin
