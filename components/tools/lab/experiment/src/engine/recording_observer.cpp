// SPDX-License-Identifier: Apache-2.0
#include "engine/recording_observer.hpp"

#include "tocsin_idl/topics.hpp"

namespace tocsin::experiment {
namespace {

template <class Topic>
const typename Topic::Message& message_of(const simulation::Written& written) {
  return *static_cast<const typename Topic::Message*>(written.message);
}

void add_decision(const simulation::Written& written, report::Recording& recording) {
  const auto& message = message_of<topic::TransmissionState>(written);
  recording.decisions.push_back({to_seconds(written.time), message.active(), message.policy(),
                                 message.reason(), static_cast<double>(message.qni())});
}

void add_quality(const simulation::Written& written, report::Recording& recording) {
  const auto& message = message_of<topic::NetworkQuality>(written);
  recording.qualities.push_back(
      {to_seconds(written.time), static_cast<double>(message.per_percent()),
       static_cast<double>(message.signal_dbm()), static_cast<double>(message.rtt_mean_ms())});
}

void add_place(const simulation::Written& written, report::Recording& recording) {
  const auto& position = message_of<topic::Location>(written).pose().pose().position();
  recording.path.push_back({to_seconds(written.time), position.x(), position.y()});
}

void set_mission(const simulation::Written& written, report::Recording& recording) {
  const auto& message = message_of<topic::MissionStatus>(written);
  recording.mission = {message.mission(),
                       message.state(),
                       static_cast<int>(message.waypoint()),
                       static_cast<int>(message.waypoints()),
                       static_cast<int>(message.goals_sent()),
                       message.elapsed_s()};
}

/// Of an end whose topic has a class.
report::LinkClass class_of(const simulation::TopicEnd& end) {
  return {end.role, end.traffic_class.value()};
}

/// It came on `<topic>/backfilled`.
bool is_backfilled(const simulation::Delivered& delivered) {
  const std::string& topic = delivered.from.topic;
  const std::string& given_on = delivered.to.topic;
  return given_on.size() > topic.size() && given_on.compare(0, topic.size(), topic) == 0;
}

/// Airtime and bytes of both directions.
report::LinkState state_of(const radio::LinkReport& report, Time now) {
  const auto& up = report.uplink;
  const auto& down = report.downlink;
  return {to_seconds(now),
          report.mean_snr_db,
          report.busy_share,
          to_seconds(up.air.airtime + down.air.airtime),
          static_cast<double>(up.bytes_pushed + down.bytes_pushed),
          0};
}

}  // namespace

RecordingObserver::Writer RecordingObserver::writer_of(const simulation::TopicEnd& end) {
  Writer writer;
  writer.classified = end.traffic_class.has_value();
  const auto is = [&](Role role, const char* topic) {
    return end.role == role && end.topic == topic;
  };
  if (is(Role::gcs, topic::MissionStatus::info.name)) writer.kept = Kept::mission;
  if (is(Role::uxv, topic::TransmissionState::info.name)) writer.kept = Kept::decision;
  if (is(Role::uxv, topic::NetworkQuality::info.name)) writer.kept = Kept::quality;
  if (is(Role::uxv, topic::Location::info.name)) writer.kept = Kept::place;
  return writer;
}

RecordingObserver::Writer& RecordingObserver::writer(const simulation::TopicEnd& end) {
  const auto found = writers_.find(&end);
  return found != writers_.end() ? found->second
                                 : writers_.emplace(&end, writer_of(end)).first->second;
}

void RecordingObserver::keep(Kept kept, const simulation::Written& written) {
  switch (kept) {
    case Kept::no:
      return;
    case Kept::decision:
      return add_decision(written, recording_);
    case Kept::quality:
      return add_quality(written, recording_);
    case Kept::place:
      return add_place(written, recording_);
    case Kept::mission:
      return set_mission(written, recording_);
  }
}

void RecordingObserver::on_written(const simulation::Written& written) {
  if (!written.from.traffic_class) return;
  Writer& from = writer(written.from);
  if (!from.classified) return;
  if (from.written == nullptr) from.written = &recording_.written[class_of(written.from)];
  ++*from.written;
  keep(from.kept, written);
}

void RecordingObserver::on_delivered(const simulation::Delivered& delivered) {
  if (delivered.to.process != "recorder") return;
  Writer& from = writer(delivered.from);
  if (!from.classified) return;
  if (from.arrivals == nullptr) from.arrivals = &recording_.arrivals[class_of(delivered.from)];
  auto& arrivals =
      is_backfilled(delivered) ? recording_.backfilled[class_of(delivered.from)] : *from.arrivals;
  arrivals.push_back({to_seconds(delivered.sent_at), to_seconds(delivered.received),
                      delivered.from.topic, delivered.from.process, delivered.sequence,
                      static_cast<double>(delivered.bytes)});
}

void RecordingObserver::on_channel(const radio::LinkReport& report, Time now) {
  recording_.link.push_back(state_of(report, now));
}

void RecordingObserver::on_failure(const std::string& component, const std::string& what, Time) {
  if (failure_.empty()) failure_ = component + ": " + what;
}

}  // namespace tocsin::experiment
