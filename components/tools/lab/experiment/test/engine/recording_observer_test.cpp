// SPDX-License-Identifier: Apache-2.0
#include "engine/recording_observer.hpp"

#include <gtest/gtest.h>

#include "tocsin_idl/topics.hpp"

namespace tocsin::experiment {
namespace {

const Time t0{std::chrono::seconds(100)};

simulation::TopicEnd end_of(const char* role, const char* process, const char* topic,
                            std::optional<TrafficClass> traffic_class) {
  simulation::TopicEnd end;
  end.host = role;
  end.role = role_of(role).value();
  end.process = process;
  end.topic = topic;
  end.traffic_class = traffic_class;
  end.scope = Scope::link;
  return end;
}

TEST(RecordingObserver, KeepsTheVehiclesDecisions) {
  topic::TransmissionState::Message message;
  message.active(false);
  message.policy("tocp");
  message.reason("cusum_alarm");
  message.qni(30);
  const auto vehicle = end_of("uxv", "link", "transmission_state", TrafficClass::critical);
  const auto ground = end_of("gcs", "link", "transmission_state", TrafficClass::critical);
  RecordingObserver sut;
  sut.on_written({vehicle, t0, 1, 50, &message});
  sut.on_written({ground, t0, 1, 50, &message});
  ASSERT_EQ(sut.recording().decisions.size(), 1U);
  EXPECT_EQ(sut.recording().decisions[0].time_s, 100);
  EXPECT_FALSE(sut.recording().decisions[0].active);
  EXPECT_EQ(sut.recording().decisions[0].qni, 30);
}

TEST(RecordingObserver, CountsWhatWasWrittenWhetherItWasSentOrNot) {
  topic::BatteryState::Message message;
  const auto from = end_of("uxv", "drive", "battery_state", TrafficClass::low);
  RecordingObserver sut;
  sut.on_written({from, t0, 1, 50, &message});
  sut.on_written({from, t0, 2, 50, &message});
  EXPECT_EQ(sut.recording().written.at({Role::uxv, TrafficClass::low}), 2U);
}

TEST(RecordingObserver, TakesArrivalsAtTheRecorderOnly) {
  const auto from = end_of("uxv", "drive", "location", TrafficClass::high);
  const auto recorder = end_of("gcs", "recorder", "location", std::nullopt);
  const auto other = end_of("gcs", "mission", "location", std::nullopt);
  RecordingObserver sut;
  sut.on_delivered({from, recorder, 7, 7, t0, t0, t0 + seconds(0.5), 300, nullptr});
  sut.on_delivered({from, other, 7, 7, t0, t0, t0 + seconds(0.5), 300, nullptr});
  const auto& arrivals = sut.recording().arrivals.at({Role::uxv, TrafficClass::high});
  ASSERT_EQ(arrivals.size(), 1U);
  EXPECT_EQ(arrivals[0].sequence, 7U);
  EXPECT_DOUBLE_EQ(arrivals[0].received_s - arrivals[0].sent_s, 0.5);
  EXPECT_EQ(arrivals[0].bytes, 300);
}

TEST(RecordingObserver, KeepsWhatWasFilledInApartFromWhatCameLive) {
  const auto from = end_of("uxv", "drive", "location", TrafficClass::high);
  const auto live = end_of("gcs", "recorder", "location", std::nullopt);
  const auto later = end_of("gcs", "recorder", "location/backfilled", std::nullopt);
  RecordingObserver sut;
  sut.on_delivered({from, live, 7, 7, t0, t0, t0 + seconds(0.5), 300, nullptr});
  sut.on_delivered({from, later, 6, 6, t0, t0, t0 + seconds(60), 300, nullptr});
  const report::LinkClass high{Role::uxv, TrafficClass::high};
  ASSERT_EQ(sut.recording().arrivals.at(high).size(), 1U);
  EXPECT_EQ(sut.recording().arrivals.at(high)[0].sequence, 7U);
  ASSERT_EQ(sut.recording().backfilled.at(high).size(), 1U);
  EXPECT_EQ(sut.recording().backfilled.at(high)[0].sequence, 6U);
  EXPECT_EQ(sut.recording().backfilled.at(high)[0].topic, "location");
}

TEST(RecordingObserver, IgnoresTopicsThatStayOnTheirHost) {
  topic::Odom::Message message;
  const auto from = end_of("uxv", "drive", "odom", std::nullopt);
  RecordingObserver sut;
  sut.on_written({from, t0, 1, 0, &message});
  EXPECT_TRUE(sut.recording().written.empty());
}

TEST(RecordingObserver, FollowsTheChannel) {
  radio::LinkReport report{};
  report.mean_snr_db = 12;
  report.uplink.bytes_pushed = 100;
  report.downlink.bytes_pushed = 20;
  report.uplink.air.airtime = seconds(1);
  report.downlink.air.airtime = seconds(0.5);
  RecordingObserver sut;
  sut.on_channel(report, t0);
  ASSERT_EQ(sut.recording().link.size(), 1U);
  EXPECT_EQ(sut.recording().link[0].bytes, 120);
  EXPECT_DOUBLE_EQ(sut.recording().link[0].airtime_s, 1.5);
}

TEST(RecordingObserver, NamesTheFirstComponentThatThrew) {
  RecordingObserver sut;
  EXPECT_EQ(sut.failure(), "");
  sut.on_failure("policy", "one", t0);
  sut.on_failure("driver", "two", t0);
  EXPECT_EQ(sut.failure(), "policy: one");
}

TEST(RecordingObserver, KeepsMeasurementsOfTheLinkInTheirUnits) {
  topic::NetworkQuality::Message message;
  message.per_percent(12.5);
  message.signal_dbm(-70);
  message.rtt_mean_ms(8);
  const auto from = end_of("uxv", "link", "network_quality", TrafficClass::high);
  RecordingObserver sut;
  sut.on_written({from, t0 + seconds(1.5), 1, 50, &message});
  ASSERT_EQ(sut.recording().qualities.size(), 1U);
  EXPECT_EQ(sut.recording().qualities[0].time_s, 101.5);
  EXPECT_EQ(sut.recording().qualities[0].per_percent, 12.5);
  EXPECT_EQ(sut.recording().qualities[0].signal_dbm, -70);
  EXPECT_EQ(sut.recording().qualities[0].rtt_mean_ms, 8);
}

TEST(RecordingObserver, FollowsThePath) {
  topic::Location::Message message;
  message.pose().pose().position().x(3);
  message.pose().pose().position().y(-4);
  const auto from = end_of("uxv", "drive", "location", TrafficClass::high);
  RecordingObserver sut;
  sut.on_written({from, t0, 1, 50, &message});
  ASSERT_EQ(sut.recording().path.size(), 1U);
  EXPECT_EQ(sut.recording().path[0].x_m, 3);
  EXPECT_EQ(sut.recording().path[0].y_m, -4);
}

TEST(RecordingObserver, KeepsTheLastStateOfTheMission) {
  topic::MissionStatus::Message message;
  message.mission("square");
  const auto from = end_of("gcs", "mission", "mission_status", TrafficClass::critical);
  RecordingObserver sut;
  for (const char* state : {"running", "done"}) {
    message.state(state);
    message.elapsed_s(message.elapsed_s() + 40);
    sut.on_written({from, t0, 1, 50, &message});
  }
  EXPECT_EQ(sut.recording().mission.name, "square");
  EXPECT_EQ(sut.recording().mission.state, "done");
  EXPECT_EQ(sut.recording().mission.elapsed_s, 80);
}

TEST(RecordingObserver, IgnoresAMissionThatTheVehicleTells) {
  topic::MissionStatus::Message message;
  message.state("done");
  const auto from = end_of("uxv", "mission", "mission_status", TrafficClass::critical);
  RecordingObserver sut;
  sut.on_written({from, t0, 1, 50, &message});
  EXPECT_EQ(sut.recording().mission.state, "");
}

TEST(RecordingObserver, CountsEachClassOfEachSideByItself) {
  topic::BatteryState::Message message;
  const auto low = end_of("uxv", "drive", "battery_state", TrafficClass::low);
  const auto more = end_of("uxv", "drive", "cpu_load", TrafficClass::low);
  const auto high = end_of("uxv", "drive", "docking/status", TrafficClass::high);
  const auto ground = end_of("gcs", "mission", "goal", TrafficClass::low);
  RecordingObserver sut;
  for (const auto* from : {&low, &more, &high, &ground}) {
    sut.on_written({*from, t0, 1, 50, &message});
  }
  EXPECT_EQ(sut.recording().written.at({Role::uxv, TrafficClass::low}), 2U);
  EXPECT_EQ(sut.recording().written.at({Role::uxv, TrafficClass::high}), 1U);
  EXPECT_EQ(sut.recording().written.at({Role::gcs, TrafficClass::low}), 1U);
}

TEST(RecordingObserver, IgnoresLinkTopicsWithoutAClass) {
  topic::BatteryState::Message message;
  const auto from = end_of("uxv", "drive", "battery_state", std::nullopt);
  const auto recorder = end_of("gcs", "recorder", "battery_state", std::nullopt);
  RecordingObserver sut;
  sut.on_written({from, t0, 1, 50, &message});
  sut.on_delivered({from, recorder, 1, 1, t0, t0, t0, 300, nullptr});
  EXPECT_TRUE(sut.recording().written.empty());
  EXPECT_TRUE(sut.recording().arrivals.empty());
}

TEST(RecordingObserver, KeepsArrivalsOfAClassTogetherInTheOrderOfTheirComing) {
  const auto one = end_of("uxv", "drive", "location", TrafficClass::high);
  const auto other = end_of("uxv", "link", "network_quality", TrafficClass::high);
  const auto recorder = end_of("gcs", "recorder", "", std::nullopt);
  RecordingObserver sut;
  sut.on_delivered({one, recorder, 1, 1, t0, t0, t0 + seconds(1), 300, nullptr});
  sut.on_delivered({other, recorder, 5, 5, t0, t0, t0 + seconds(2), 80, nullptr});
  sut.on_delivered({one, recorder, 2, 2, t0, t0, t0 + seconds(3), 300, nullptr});
  const auto& arrivals = sut.recording().arrivals.at({Role::uxv, TrafficClass::high});
  ASSERT_EQ(arrivals.size(), 3U);
  EXPECT_EQ(arrivals[1].topic, "network_quality");
  EXPECT_EQ(arrivals[1].writer, "link");
  EXPECT_EQ(arrivals[2].sequence, 2U);
}

TEST(RecordingObserver, CountsFromTheTimeOfSendingNotOfWriting) {
  // The gate held it back for 10 s.
  const auto from = end_of("uxv", "drive", "location", TrafficClass::high);
  const auto recorder = end_of("gcs", "recorder", "location", std::nullopt);
  RecordingObserver sut;
  sut.on_delivered({from, recorder, 1, 1, t0, t0 + seconds(10), t0 + seconds(11), 300, nullptr});
  EXPECT_EQ(sut.recording().arrivals.at({Role::uxv, TrafficClass::high})[0].sent_s, 110);
}

}  // namespace
}  // namespace tocsin::experiment
