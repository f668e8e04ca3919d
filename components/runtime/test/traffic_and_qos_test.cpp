// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "foundation/error.hpp"
#include "runtime/middleware/qos_profile.hpp"
#include "runtime/middleware/traffic_rules.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;

/// A file that is gone with the test.
class File {
 public:
  explicit File(const std::string& text)
      : path_(::testing::TempDir() + "/traffic_" + std::to_string(getpid()) + ".yaml") {
    std::ofstream(path_) << text;
  }
  ~File() { unlink(path_.c_str()); }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

template <class Call>
std::string error_of(const Call& call) {
  try {
    call();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

const std::string config = std::string(TOCSIN_SOURCE_DIR) + "/../../config";

template <class Topic>
void expect_profile(const QosProfiles& profiles) {
  EXPECT_EQ(error_of([&] { (void)profiles.of(Topic::info.qos, Topic::info.name); }), "no error");
}

TEST(QosProfiles, ShippedFileHasTheProfileOfEveryTopic) {
  const QosProfiles sut(config + "/qos.yaml");
  expect_profile<topic::CmdVel>(sut);
  expect_profile<topic::Odom>(sut);
  expect_profile<topic::Location>(sut);
  expect_profile<topic::NavigationStatus>(sut);
  expect_profile<topic::CameraImage>(sut);
  expect_profile<topic::Goal>(sut);
  expect_profile<topic::TransmissionState>(sut);
  expect_profile<topic::TrafficReport>(sut);
}

TEST(QosProfiles, AMissingProfileNamesTopicAndFile) {
  const File file("sensor: {depth: 5}\n");
  const QosProfiles sut(file.path());
  const std::string text = error_of([&] { (void)sut.of("state", "goal"); });
  EXPECT_THAT(text, HasSubstr("topic goal: QoS profile 'state' is not in " + file.path()));
  EXPECT_THAT(text, HasSubstr("it has: sensor"));
}

TEST(QosProfiles, AnUnknownPolicyNamesItsLine) {
  const File file("sensor:\n  depth: 5\n  deadlinex: 1\n");
  EXPECT_THAT(error_of([&] { QosProfiles{file.path()}; }),
              HasSubstr("sensor.deadlinex: unknown key"));
  EXPECT_THAT(error_of([&] { QosProfiles{file.path()}; }), HasSubstr(":3)"));
}

TEST(QosProfiles, DepthMustBePositive) {
  const File file("sensor: {depth: 0}");
  EXPECT_THAT(error_of([&] { QosProfiles{file.path()}; }),
              HasSubstr("sensor.depth: 0 is outside [1, 10000]"));
}

TEST(QosProfiles, AnUnreadableFileIsNamed) {
  EXPECT_THAT(error_of([] { QosProfiles{"/nowhere/qos.yaml"}; }),
              HasSubstr("/nowhere/qos.yaml: cannot be read"));
}

TEST(TrafficRules, ShippedFilePausesTheCameraAndKeepsTheNewestGoal) {
  const TrafficRules uxv(config + "/traffic.yaml", "uxv");
  EXPECT_EQ(uxv.of(topic::CameraImage::info.name).while_poor, WhilePoor::drop);
  EXPECT_EQ(uxv.of(topic::Location::info.name).while_poor, WhilePoor::send);
  const TrafficRules gcs(config + "/traffic.yaml", "gcs");
  EXPECT_EQ(gcs.of(topic::Goal::info.name).while_poor, WhilePoor::latest);
  EXPECT_EQ(gcs.of(topic::EmergencyStop::info.name).while_poor, WhilePoor::send);
}

TEST(TrafficRules, ATopicWithoutClassIsAnError) {
  const File file("uxv:\n  low: {while_poor: drop, topics: [a]}\n");
  const TrafficRules sut(file.path(), "uxv");
  EXPECT_THAT(error_of([&] { (void)sut.of("b"); }),
              HasSubstr("topic b: crosses the link, but has no traffic class for role uxv"));
}

TEST(TrafficRules, ATopicInTwoClassesIsAnError) {
  const File file("uxv:\n  low: {topics: [a]}\n  high: {topics: [a]}\n");
  EXPECT_THAT(error_of([&] { TrafficRules(file.path(), "uxv"); }),
              HasSubstr("a is in two classes"));
}

TEST(TrafficRules, AnUnknownRoleIsAnError) {
  const File file("uxv: {}\n");
  EXPECT_THAT(error_of([&] { TrafficRules(file.path(), "boat"); }),
              HasSubstr("has no map for the role 'boat'"));
}

TEST(TrafficRules, AnUnknownActionIsAnError) {
  const File file("uxv:\n  low: {while_poor: delete}\n");
  EXPECT_THAT(error_of([&] { TrafficRules(file.path(), "uxv"); }),
              HasSubstr("'delete' is not one of: send, latest, drop"));
}

}  // namespace
}  // namespace tocsin
