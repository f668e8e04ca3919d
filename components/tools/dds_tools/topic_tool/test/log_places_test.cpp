// SPDX-License-Identifier: Apache-2.0
#include "log_places.hpp"

#include <gmock/gmock.h>

#include <yaml-cpp/yaml.h>

#include "deployment/running_host.hpp"
#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "log_folder.hpp"

namespace tocsin::topic_tool {
namespace {

using ::testing::HasSubstr;
using From = sample_log::LogStart::From;

constexpr std::int64_t now_ns = 1'700'000'000'000'000'000;

TEST(LogWish, SaysWhereToBegin) {
  LogWish sut;
  EXPECT_FALSE(sut.is_wanted());
  sut.consumer = "plot";
  EXPECT_TRUE(sut.is_wanted());
  EXPECT_EQ(sut.start(now_ns).from, From::end) << "a new consumer begins now";
  sut.from_start = true;
  EXPECT_EQ(sut.start(now_ns).from, From::beginning);
}

TEST(LogWish, CountsFromNow) {
  LogWish sut;
  sut.since_s = 2.5;
  EXPECT_EQ(sut.start(now_ns).from, From::time);
  EXPECT_EQ(sut.start(now_ns).value, static_cast<std::uint64_t>(now_ns) - 2'500'000'000U);
  sut.since_s = 9e9;
  EXPECT_EQ(sut.start(now_ns).value, 0U);
  LogWish last;
  last.last = 7;
  EXPECT_EQ(last.start(now_ns).from, From::last);
  EXPECT_EQ(last.start(now_ns).value, 7U);
}

deployment::RunningHost host_with(const std::string& parameters) {
  deployment::RunningHost host;
  host.deployment.run_dir = "/runs/1";
  host.host = "vehicle";
  deployment::Host one;
  one.name = "vehicle";
  one.role = Role::uxv;
  deployment::Container link;
  link.components.push_back(
      {"link_router", "link_router", std::make_shared<const YAML::Node>(YAML::Load(parameters))});
  one.containers.push_back(link);
  host.deployment.hosts.push_back(one);
  return host;
}

TEST(StoreFolder, IsTheRoutersOrThatOfTheRun) {
  EXPECT_EQ(store_folder(host_with("{store_directory: /var/lib/log}")), "/var/lib/log");
  EXPECT_EQ(store_folder(host_with("{}")), "/runs/1/uxv/store");
  deployment::RunningHost station = host_with("{}");
  station.deployment.vehicles = {"uxv1", "uxv2"};
  station.deployment.hosts[0].peers = {"10.0.0.1", "10.0.0.2"};
  station.deployment.hosts[0].role = Role::gcs;
  EXPECT_EQ(store_folder(station, "uxv2"), "/runs/1/uxv2/gcs/store");
}

TEST(FolderWith, IsTheFirstWhoseLogHasTheTopic) {
  const TemporaryFolder folder;
  const auto folders = folders_in(folder.path("store"));
  TextLog(folders[0], "/chatter").write({"a"});
  TextLog(folders[1], "/odom").write({"b"});
  EXPECT_EQ(folder_with(folders, "/odom", {}), folders[1]);
  EXPECT_EQ(folder_with(folders, "/chatter", {}), folders[0]);
  try {
    (void)folder_with(folders, "/camera", {});
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("has nothing of /camera; it has /chatter, /odom"));
  }
}

TEST(FolderWith, SaysThatALogIsEmpty) {
  try {
    (void)folder_with({"/nowhere"}, "/odom", {});
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "the log in /nowhere has nothing of /odom (lists store, log and keep of the "
                 "traffic file)");
  }
}

}  // namespace
}  // namespace tocsin::topic_tool
