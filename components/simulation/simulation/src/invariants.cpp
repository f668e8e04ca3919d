// SPDX-License-Identifier: Apache-2.0
#include "simulation/invariants.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::simulation {
namespace {

constexpr std::size_t most_violations = 20;
constexpr double stands_mps = 0.02;
constexpr double stands_radps = 0.1;

std::string process_of(const TopicEnd& end) { return end.host + "/" + end.process; }
std::string text_of(const TopicEnd& end) { return process_of(end) + " " + end.topic; }

/// NaN is allowed where the IDL says so.
bool is_percent(double value) { return std::isnan(value) || (value >= 0 && value <= 100); }

bool is(const TopicEnd& end, const TopicInfo& topic) { return end.topic == topic.name; }

}  // namespace

void Invariants::expect(bool kept, Time now, const char* promise, const std::string& detail) {
  ++checks_;
  if (kept || violations_.size() == most_violations) return;
  violations_.push_back({to_seconds(now - start_time), std::string(promise) + ": " + detail});
}

bool Invariants::is_closed(const TopicEnd& end) const {
  return end.pausable && closed_.count(end.host) != 0;
}

/// The first of several that wait is looked at; a newer one may go in its place.
void Invariants::await(const TopicEnd& end, std::uint64_t sequence, Time since) {
  if (!policy_of(*end.traffic_class).passes_backlog || routed_.count(end.host) == 0) return;
  const Time due = since + seconds(limits_.leaves_s);
  if (awaited_.insert({&end, {sequence, due}}).second) next_due_ = std::min(next_due_, due);
}

void Invariants::on_written(const Written& written) {
  const TopicEnd& end = written.from;
  check_message(written);
  see_stop(written);
  if (!end.traffic_class) return;
  if (!is_closed(end)) return await(end, written.sequence, written.time);
  if (!end.drops) kept_[&end] = {written.sequence, written.time};
}

void Invariants::check_message(const Written& written) {
  const TopicEnd& end = written.from;
  if (is(end, topic::CmdVel::info)) {
    const auto& twist = *static_cast<const topic::CmdVel::Message*>(written.message);
    if (twist.linear().x() != 0 || twist.angular().z() != 0) wanted_ = written.time;
  } else if (is(end, topic::NetworkQuality::info)) {
    const auto& quality = *static_cast<const topic::NetworkQuality::Message*>(written.message);
    const bool in_range = quality.per_percent() >= 0 && quality.per_percent() <= 100 &&
                          is_percent(quality.quality_percent()) &&
                          is_percent(quality.retry_percent()) && is_percent(quality.busy_percent());
    expect(in_range, written.time, "network quality out of its range", text_of(end));
  } else if (is(end, topic::TransmissionState::info)) {
    const auto& state = *static_cast<const topic::TransmissionState::Message*>(written.message);
    expect(is_percent(state.qni()), written.time, "QNI out of its range",
           std::to_string(state.qni()));
  }
}

void Invariants::see_stop(const Written& written) {
  const TopicEnd& end = written.from;
  if (is(end, topic::EmergencyStop::info)) {
    const auto& stop = *static_cast<const topic::EmergencyStop::Message*>(written.message);
    if (end.role == Role::gcs) return pressed_stop_.on_station(stop.data(), written.time);
    stop_.on_writer(end, stop.data(), written.time);
  } else if (end.role == Role::uxv && is(end, topic::LinkStop::info)) {
    const auto& link = *static_cast<const topic::LinkStop::Message*>(written.message);
    stop_.on_link(link.stands(), written.time);
    expect(pressed_stop_.on_link(link.stands(), written.time), written.time,
           "an emergency stop ended that nobody released", end.host);
  }
}

void Invariants::on_sent(const Sent& sent) {
  const TopicEnd& end = sent.from;
  routed_.insert(end.host);
  expect(!is_closed(end), sent.time, "sent through a closed gate", text_of(end));
  for (Marks* marks : {&kept_, &awaited_}) {
    const auto found = marks->find(&end);
    if (found != marks->end() && sent.written >= found->second.sequence) marks->erase(found);
  }
}

/// What is repaired comes after newer ones, where these do not make it worthless.
bool Invariants::is_new(Given& given, const TopicEnd& from, std::uint64_t sequence) {
  constexpr std::size_t most_recent = 1000;
  const bool is_newest = sequence > given.newest;
  given.newest = std::max(given.newest, sequence);
  if (from.keeps_one) return is_newest;
  const bool is_first = given.recent.insert(sequence).second;
  if (given.recent.size() > most_recent) given.recent.erase(given.recent.begin());
  return is_first;
}

void Invariants::on_delivered(const Delivered& delivered) {
  Given& given = given_[{&delivered.from, &delivered.to}];
  expect(is_new(given, delivered.from, delivered.sequence), delivered.received,
         "a sample came again or out of order",
         text_of(delivered.from) + " to " + process_of(delivered.to));
  if (delivered.from.role == Role::gcs && delivered.to.role == Role::uxv) {
    pressed_stop_.on_crossed(delivered.written_at, delivered.received);
  }
  const double age_s = to_seconds(delivered.received - delivered.sent_at);
  expect(age_s <= delivered.from.lifespan_s, delivered.received, "delivered after its lifespan",
         text_of(delivered.from) + ", " + std::to_string(age_s) + " s old");
}

void Invariants::on_position(const BasePosition& base) {
  x_m_ = base.x_m;
  y_m_ = base.y_m;
  const bool stands =
      std::abs(base.speed_mps) < stands_mps && std::abs(base.turn_rate_radps) < stands_radps;
  const auto since = [&](Time then) {
    return then == Time::min() ? 1e9 : to_seconds(base.time - then);
  };
  expect(stands || since(base.commanded) <= limits_.base_stops_s, base.time,
         "the base moves without commands", base.host);
  expect(stands || since(wanted_) <= limits_.vehicle_stops_s, base.time,
         "the vehicle moves though nobody wants it", base.host);
  expect(pressed_stop_.is_reported(base.time), base.time,
         "the station's emergency stop is not reported though its router is received", base.host);
  vehicle_ = base.host;
  check_stop(base, stands);
}

void Invariants::check_stop(const BasePosition& base, bool stands) {
  const auto since = stop_.since(base.time);
  if (!since) return;
  const Time commanded = *since + seconds(limits_.stop_commanded_s);
  expect(base.commanded_to_stand || base.commanded <= commanded, base.time,
         "commanded to move though an emergency stop stands", base.host);
  expect(stands || base.time <= commanded + seconds(limits_.base_stops_s), base.time,
         "the base moves though an emergency stop stands", base.host);
}

void Invariants::forget(Marks& marks, const std::function<bool(const TopicEnd&)>& which) {
  for (auto it = marks.begin(); it != marks.end();) {
    it = which(*it->first) ? marks.erase(it) : std::next(it);
  }
}

void Invariants::on_gate(const GateChange& change) {
  const auto of_host = [&](const TopicEnd& end) { return end.host == change.host; };
  if (change.event == GateEvent::closed) {
    closed_.insert(change.host);
    return forget(awaited_, [&](const TopicEnd& end) { return of_host(end) && end.pausable; });
  }
  closed_.erase(change.host);
  if (change.event == GateEvent::gone) {
    routed_.erase(change.host);
    forget(awaited_, of_host);
  } else {
    for (const auto& [end, kept] : kept_) {
      const bool fresh = to_seconds(change.time - kept.time) <= end->lifespan_s;
      if (fresh && of_host(*end)) await(*end, kept.sequence, change.time);
    }
  }
  forget(kept_, of_host);
}

void Invariants::on_process(const ProcessChange& change) {
  pressed_stop_.on_router();
  if (change.event == ProcessEvent::started || change.event == ProcessEvent::thawed) {
    const std::string host = change.process.substr(0, change.process.find('/'));
    if (host == vehicle_) stop_.on_process_started(change.time);
    return;
  }
  if (change.event == ProcessEvent::frozen) return on_frozen(change.process);
  stop_.on_process_ended(change.process);
  const auto dead = [&](const TopicEnd& end) { return process_of(end) == change.process; };
  forget(kept_, dead);
  forget(awaited_, dead);
}

/// It may be the router, which sends nothing then.
void Invariants::on_frozen(const std::string& process) {
  const std::string host = process.substr(0, process.find('/'));
  routed_.erase(host);
  forget(awaited_, [&](const TopicEnd& end) { return end.host == host; });
}

void Invariants::on_failure(const std::string& component, const std::string& what, Time now) {
  expect(false, now, "a component threw", component + ": " + what);
}

void Invariants::on_step(Time now) {
  if (now <= next_due_) return;
  const auto is_late = [&](const auto& entry) { return entry.second.time < now; };
  for (const auto& entry : awaited_) {
    expect(!is_late(entry), now, "not put on the radio in time", text_of(*entry.first));
  }
  forget(awaited_, [&](const TopicEnd& end) { return awaited_.at(&end).time < now; });
  next_due_ = Time::max();
  for (const auto& entry : awaited_) next_due_ = std::min(next_due_, entry.second.time);
}

void Invariants::on_end(const Outcome& outcome) {
  const Time now = start_time + outcome.simulated;
  char place[60];
  std::snprintf(place, sizeof place, "at (%.2f, %.2f)", x_m_, y_m_);
  expect(outcome.exit_code.has_value(), now, "the mission was not over in time", place);
  if (outcome.exit_code) {
    expect(*outcome.exit_code == 0, now, "the mission failed",
           "exit code " + std::to_string(*outcome.exit_code));
  }
}

}  // namespace tocsin::simulation
