// SPDX-License-Identifier: Apache-2.0
#include "equipment.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cerrno>

#include "foundation/temporary_folder.hpp"

namespace tocsin::doctor {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

deployment::Deployment one_host() {
  deployment::Deployment deployment;
  deployment::Host& host = deployment.hosts.emplace_back();
  host.name = "uxv";
  host.address = "10.1.2.3";
  return deployment;
}

class EquipmentTest : public ::testing::Test {
 protected:
  /// What is said of a vehicle with one component of these parameters.
  [[nodiscard]] Advices judged(const std::string& parameters) const {
    deployment::Deployment deployment = one_host();
    deployment.hosts[0].containers = {
        {"drive",
         false,
         {{"driver", "driver", std::make_shared<YAML::Node>(YAML::Load(parameters))}}}};
    return judge_equipment(deployment, equipment_);
  }
  int device_error_ = 0;
  bool is_there_ = true;
  Equipment equipment_{[this](const std::string&) { return is_there_; },
                       [this](const std::string&) { return is_there_; },
                       [this](const std::string&) { return device_error_; },
                       [this](const std::filesystem::path&) { return is_there_; }};
};

TEST_F(EquipmentTest, IsWhatTheFileNames) {
  std::vector<std::string> texts;
  for (const Advice& one :
       judged("{device_port: /dev/kobuki, interface_name: wlan0, store_directory: /var/x}")) {
    EXPECT_EQ(one.fitness, Fitness::good);
    texts.push_back(one.text);
  }
  EXPECT_THAT(texts, ElementsAre("uxv: address 10.1.2.3", "uxv/driver: /dev/kobuki",
                                 "uxv/driver: interface wlan0", "uxv/driver: folder /var/x"));
  EXPECT_EQ(judged("{other: 1, device_port: []}").size(), 1U);
}

TEST_F(EquipmentTest, WhatIsNotThereIsBad) {
  is_there_ = false;
  for (const Advice& one : judged("{interface_name: wlan0, store_directory: /var/x}")) {
    EXPECT_EQ(one.fitness, Fitness::bad) << one.text;
    EXPECT_NE(one.remedy, "");
  }
}

TEST_F(EquipmentTest, TellsADeviceThatIsAbsentFromOneThatIsForbidden) {
  device_error_ = ENOENT;
  const Advice absent = judged("{device_port: /dev/kobuki}")[1];
  EXPECT_EQ(absent.fitness, Fitness::bad);
  EXPECT_THAT(absent.text, HasSubstr("/dev/kobuki: No such file"));
  EXPECT_THAT(absent.remedy, HasSubstr("plugged in"));
  device_error_ = EACCES;
  EXPECT_THAT(judged("{device_port: /dev/kobuki}")[1].remedy, HasSubstr("dialout"));
}

TEST_F(EquipmentTest, AnEmulatedRadioNeedsNoneOfIt) {
  deployment::Deployment deployment = one_host();
  deployment.radio = deployment::Radio{};
  EXPECT_THAT(judge_equipment(deployment, equipment_), IsEmpty());
}

TEST_F(EquipmentTest, OfThisComputerIsLookedAt) {
  const Equipment own = own_equipment();
  EXPECT_TRUE(own.is_running("127.0.0.1"));
  EXPECT_FALSE(own.is_running("192.0.2.1"));
  EXPECT_FALSE(own.is_running("localhost"));
  EXPECT_TRUE(own.has_interface("lo"));
  EXPECT_FALSE(own.has_interface("absent0"));
  EXPECT_EQ(own.error_of_device("/dev/null"), 0);
  EXPECT_EQ(own.error_of_device("/dev/absent"), ENOENT);
  const TemporaryFolder folder;
  EXPECT_TRUE(own.may_write(folder.path("a/b")));
  EXPECT_FALSE(own.may_write("/dev/null/b"));
}

TEST(Upgrade, AProgramThatWasReplacedIsBad) {
  EXPECT_EQ(
      judge_upgrade({"/usr/bin/x (deleted)", "/usr/lib/tocsin/bin/tocsin-container"})[0].fitness,
      Fitness::good);
  const Advice bad = judge_upgrade({"/usr/lib/tocsin/bin/tocsin-container (deleted)",
                                    "/usr/lib/tocsin/bin/tocsin-launch (deleted)"})[0];
  EXPECT_EQ(bad.fitness, Fitness::bad);
  EXPECT_THAT(bad.text, HasSubstr("2 processes"));
  EXPECT_THAT(running_programs(), ::testing::Contains(HasSubstr("test")));
}

}  // namespace
}  // namespace tocsin::doctor
