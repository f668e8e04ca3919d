// SPDX-License-Identifier: Apache-2.0
// The QoS file: profiles, overrides, and every error with its line.
#include "runtime/middleware/qos_profile.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>

#include "foundation/parameters.hpp"
#include "qos/config_file.hpp"
#include "runtime/middleware/qos_matching.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string error_of_file(const std::string& text) {
  const ConfigFile file(text);
  return error_of([&] { QosProfiles{file.path()}; });
}

const std::string config = std::string(TOCSIN_REPOSITORY) + "/config";

template <class Topic>
void expect_profile(const QosProfiles& profiles) {
  EXPECT_EQ(error_of([&] { (void)profiles.of(Topic::info.qos, Topic::info.name); }), "no error");
}
template <class... Topics>
void expect_profiles(const QosProfiles& profiles, topic::List<Topics...>) {
  (expect_profile<Topics>(profiles), ...);
}

std::string text_of(QosProfile profile) {
  ParameterPrinter printer;
  profile.visit(printer);
  return printer.text();
}

TEST(QosProfiles, TheBuiltInOnesAreThoseOfTheShippedFileInEveryPartition) {
  const QosProfiles shipped(config + "/qos.yaml");
  const QosProfiles sut;
  for (const char* name : {"sensor", "command", "state", "event", "telemetry", "stream", "log"}) {
    QosProfile built_in = sut.of(name, "x");
    EXPECT_THAT(built_in.partition, ElementsAre("", "*")) << name;
    built_in.partition.clear();
    EXPECT_EQ(text_of(built_in), text_of(shipped.of(name, "x"))) << name;
  }
  EXPECT_THAT(error_of([&] { (void)sut.of("mine", "x"); }), HasSubstr("the built-in profiles"));
}

TEST(QosProfiles, ShippedFileHasTheProfileOfEveryLinkTopicAndOfHostTopics) {
  const QosProfiles sut(config + "/qos.yaml");
  expect_profiles(sut, topic::AllLinkTopics{});
  expect_profile<topic::CmdVel>(sut);
  expect_profile<topic::Odom>(sut);
  expect_profile<topic::Tf>(sut);
}

/// ROS 2's default for publishers and subscribers (rmw_qos_profile_default).
const QosContract ros_default;

template <class Topic>
void expect_ros_reads_and_is_read(const QosProfiles& profiles) {
  const QosProfile offered = profiles.of(Topic::info.qos, Topic::info.name);
  EXPECT_THAT(incompatibilities(offered, ros_default), IsEmpty()) << Topic::info.name;
  // A state is not heard of who would not tell it to late readers; the file says why.
  const bool late_readers = offered.keeps_last() && Topic::info.requests == Requests::profile;
  const std::vector<std::string> expected(late_readers ? 1 : 0, "durability");
  EXPECT_EQ(incompatibilities(ros_default, requested(Topic::info, offered)), expected)
      << Topic::info.name;
}
template <class... Topics>
void expect_ros_reads_and_is_read(const QosProfiles& profiles, topic::List<Topics...>) {
  (expect_ros_reads_and_is_read<Topics>(profiles), ...);
}

TEST(QosProfiles, EveryTopicIsReadByRos2AsItSubscribesByDefaultAndHeardButForStates) {
  const QosProfiles sut(config + "/qos.yaml");
  expect_ros_reads_and_is_read(sut, topic::AllHostTopics{});
  expect_ros_reads_and_is_read(sut, topic::AllLinkTopics{});
}

TEST(QosProfiles, MeasurementsAreHeardOfRos2sSensorsAndTransformsAndRead) {
  QosContract sensor_data;
  sensor_data.reliability = Reliability::best_effort;
  const QosProfiles sut(config + "/qos.yaml");
  for (const char* const name : {"sensor", "telemetry", "stream"}) {
    const QosProfile offered = sut.of(name, "x");
    const QosProfile heard = requested({"x", name, Scope::host}, offered);
    EXPECT_THAT(incompatibilities(sensor_data, heard), IsEmpty()) << name;
    EXPECT_THAT(incompatibilities(offered, sensor_data), IsEmpty()) << name;
  }
}

TEST(QosProfiles, AMissingProfileNamesTopicAndFile) {
  const ConfigFile file("sensor: {depth: 5}\n");
  const QosProfiles sut(file.path());
  const std::string text = error_of([&] { (void)sut.of("state", "goal"); });
  EXPECT_THAT(text, HasSubstr("topic goal: QoS profile 'state' is not in " + file.path()));
  EXPECT_THAT(text, HasSubstr("it has: sensor"));
}

TEST(QosProfiles, AFileMayExtendAnother) {
  const ConfigFile file(
      "extends: base.yaml\nstate: {depth: 3}\nlidar: {depth: 2}\nlog: ~\ntopics: {odom: ~}\n");
  file.write("base.yaml",
             "state: {durability: transient_local, depth: 1}\nlog: {depth: 9}\n"
             "topics: {odom: {max_rate_hz: 5}, scan: {max_rate_hz: 4}}\n");
  const QosProfiles sut(file.path());
  EXPECT_EQ(sut.of("state", "goal").depth, 3);
  EXPECT_TRUE(sut.of("state", "goal").keeps_last());
  EXPECT_EQ(sut.of("lidar", "scan").max_rate_hz, 4);
  EXPECT_THAT(sut.overridden_topics(), ElementsAre("scan"));
  EXPECT_THAT(error_of([&] { (void)sut.of("log", "rosout"); }), HasSubstr("'log' is not in"));
}

TEST(QosProfiles, APolicyThatFastDdsIgnoresIsRefusedWithTheReasonAndItsLine) {
  const std::string text = error_of_file("sensor:\n  depth: 5\n  latency_budget_s: 0.1\n");
  EXPECT_THAT(text, HasSubstr("sensor.latency_budget_s: not supported: Fast DDS 2.9.1 announces"));
  EXPECT_THAT(text, HasSubstr(":3)"));
}

TEST(QosProfiles, AnUnreadableFileIsNamed) {
  EXPECT_THAT(error_of([] { QosProfiles{"/nowhere/qos.yaml"}; }),
              HasSubstr("/nowhere/qos.yaml: cannot be read"));
}

TEST(QosProfiles, EveryPolicyReachesTheProfile) {
  const ConfigFile file(
      default_yaml<QosProfile>().empty()
          ? ""
          : "all:\n  reliability: best_effort\n  deadline_s: 2\n  partition: [a, b]\n"
            "  history: keep_all\n  max_samples: 7\n  nack_suppression_s: 0.5\n"
            "  ownership_strength: 3\n  ownership: exclusive\n  user_data: x=1\n");
  const QosProfile sut = QosProfiles(file.path()).of("all", "any");
  EXPECT_FALSE(sut.reliable());
  EXPECT_EQ(sut.deadline_s, 2);
  EXPECT_THAT(sut.partition, ElementsAre("a", "b"));
  EXPECT_TRUE(sut.keeps_all());
  EXPECT_EQ(sut.max_samples, 7);
  EXPECT_EQ(sut.nack_suppression_s, 0.5);
  EXPECT_EQ(sut.ownership_strength, 3);
  EXPECT_EQ(sut.user_data, "x=1");
}

TEST(QosProfiles, ATopicMayHaveItsOwnRateAndSeparation) {
  const ConfigFile file(
      "a: {max_rate_hz: 50}\ntopics:\n  slow: {max_rate_hz: 2}\n"
      "  sparse: {minimum_separation_s: 0.5}\n");
  const QosProfiles sut(file.path());
  EXPECT_EQ(sut.of("a", "other").max_rate_hz, 50);
  EXPECT_EQ(sut.of("a", "slow").max_rate_hz, 2);
  EXPECT_EQ(sut.of("a", "sparse").max_rate_hz, 50);
  EXPECT_EQ(sut.of("a", "sparse").minimum_separation_s, 0.5);
  EXPECT_THAT(sut.overridden_topics(), ElementsAre("slow", "sparse"));
}

TEST(QosProfiles, AnOverrideThatContradictsTheProfileIsAnError) {
  const ConfigFile file("a: {durability: transient_local}\ntopics: {slow: {max_rate_hz: 2}}\n");
  const QosProfiles sut(file.path());
  EXPECT_EQ(error_of([&] { (void)sut.of("a", "other"); }), "no error");
  EXPECT_THAT(error_of([&] { (void)sut.of("a", "slow"); }),
              AllOf(HasSubstr("topics.slow.max_rate_hz: drops samples, and durability"),
                    HasSubstr(", with the profile a (" + file.path() + ":2)")));
}

TEST(QosProfiles, AMistakeIsAnErrorWithItsLine) {
  for (const auto& [text, error, place] : std::vector<std::array<std::string, 3>>{
           {"sensor:\n  depth: 5\n  deadlinex: 1\n", "sensor.deadlinex: unknown key", ":3)"},
           {"a: {durability: persistent}",
            "a.durability: not supported: Fast DDS 2.9.1 does not support it", ":1)"},
           {"a: {durability: eternal}", "'eternal' is not one of", ":1)"},
           {"a:\n  depth: 5\n  max_samples: 4\n", "a.max_samples: is less than depth", ":3)"},
           {"sensor: {depth: 0}", "sensor.depth: 0 is outside [1, 10000]", ":1)"},
           {"a: {}\ntopics: {slow: {depth: 2}}\n", "topics.slow.depth: unknown key", ":2)"},
           {"extends: base.yaml\nstate: {depth: 3}\n", "deadlinex", "base.yaml:2)"},
           {"a: {flow_controller: radio}", "a.flow_controller: not supported: a process", ":1)"}}) {
    const ConfigFile file(text);
    file.write("base.yaml", "state:\n  deadlinex: 1\n");
    EXPECT_THAT(error_of([&] { QosProfiles{file.path()}; }),
                AllOf(HasSubstr(error), HasSubstr(place)))
        << text;
  }
}

}  // namespace
}  // namespace tocsin
