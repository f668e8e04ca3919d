// SPDX-License-Identifier: Apache-2.0
#include "experiment/tape.hpp"

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

/// Whether the traffic file puts it into a class; a recording is read by classes, too.
bool is_classified(const simulation::TopicEnd& end) {
  return !end.traffic_class.empty() && end.traffic_class != "none";
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

void Tape::on_written(const simulation::Written& written) {
  const simulation::TopicEnd& from = written.from;
  if (!is_classified(from)) return;
  ++recording_.written[from.role + " " + from.traffic_class];
  if (from.role == "gcs") {
    if (from.topic == topic::MissionStatus::info.name) set_mission(written, recording_);
    return;
  }
  if (from.topic == topic::TransmissionState::info.name) add_decision(written, recording_);
  if (from.topic == topic::NetworkQuality::info.name) add_quality(written, recording_);
  if (from.topic == topic::Location::info.name) add_place(written, recording_);
}

void Tape::on_delivered(const simulation::Delivered& delivered) {
  const simulation::TopicEnd& from = delivered.from;
  if (delivered.to.process != "recorder" || !is_classified(from)) return;
  recording_.arrivals[from.role + " " + from.traffic_class].push_back(
      {to_seconds(delivered.sent_at), to_seconds(delivered.received), from.topic, from.process,
       delivered.sequence, static_cast<double>(delivered.bytes)});
}

void Tape::on_channel(const radio::LinkReport& report, Time now) {
  recording_.link.push_back(state_of(report, now));
}

void Tape::on_failure(const std::string& component, const std::string& what, Time) {
  if (failure_.empty()) failure_ = component + ": " + what;
}

}  // namespace tocsin::experiment
