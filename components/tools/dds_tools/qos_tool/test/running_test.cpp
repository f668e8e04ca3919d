// SPDX-License-Identifier: Apache-2.0
// Changes of a topic all over a host, on real DDS; each test has a domain of its own.
#include "running.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "neighbour.hpp"

namespace tocsin::qos_tool {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr Neighbour::Wish a_writer{true, true};
constexpr Neighbour::Wish a_reader{false, true};

Options setting(int domain, std::vector<std::string> settings) {
  Options options;
  options.host.domain = domain;
  options.one = "/chatter";
  options.settings = std::move(settings);
  return options;
}

template <class Condition>
bool eventually(const Condition& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(8);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

std::string refused(const Options& options) {
  try {
    (void)change_running(options);
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

TEST(WireName, IsOfTheHostsNamespace) {
  EXPECT_EQ(wire_name({}, "/odom"), "rt/odom");
  EXPECT_EQ(wire_name({}, "odom"), "rt/odom");
  HostChoice uxv;
  uxv.ros_namespace = "uxv";
  EXPECT_EQ(wire_name(uxv, "/odom"), "rt/uxv/odom");
}

TEST(Running, AShorterDeadlineIsOfferedBeforeItIsRequestedAndALongerOneAfter) {
  constexpr int domain = 97;
  Neighbour writer(domain, "writer", "{deadline_s: 1}", a_writer);
  Neighbour reader(domain, "reader", "{deadline_s: 1}", a_reader);
  ASSERT_TRUE(eventually([&] { return writer.matched() == 1; }));
  const Changed shorter = change_running(setting(domain, {"deadline_s=0.5"}));
  EXPECT_EQ(shorter.ends, 2);
  EXPECT_EQ(shorter.containers, 2);
  EXPECT_THAT(shorter.stopped, IsEmpty());
  EXPECT_THAT(reader.told(), ElementsAre("none", "writers", "readers"));
  const Changed longer = change_running(setting(domain, {"deadline_s=2"}));
  EXPECT_THAT(longer.stopped, IsEmpty());
  EXPECT_THAT(reader.told(),
              ElementsAre("none", "writers", "readers", "none", "readers", "writers"));
  EXPECT_EQ(writer.matched(), 1);
}

TEST(Running, EndsOfOtherProgramsStayAndAreNamedWhenTheyDoNotMatchAnyMore) {
  constexpr int domain = 98;
  Neighbour writer(domain, "writer", "{}", a_writer);
  Neighbour foreign(domain, "foreign", "{}", {false, false});
  ASSERT_TRUE(eventually([&] { return foreign.matched() == 1; }));
  const Changed moved = change_running(setting(domain, {"partition=[left]"}));
  EXPECT_EQ(moved.ends, 1);
  ASSERT_EQ(moved.stopped.size(), 1U);
  EXPECT_EQ(moved.stopped[0].reader.name, "the reader in foreign");
  EXPECT_THAT(moved.stopped[0].stopped_by(), ElementsAre("partition"));
  EXPECT_TRUE(eventually([&] { return foreign.matched() == 0; }));
}

TEST(Running, ARefusalComesBeforeAnybodyHasChanged) {
  constexpr int domain = 99;
  Neighbour writer(domain, "writer", "{}", a_writer);
  Neighbour reader(domain, "reader", "{minimum_separation_s: 1}", a_reader);
  ASSERT_TRUE(eventually([&] { return writer.matched() == 1; }));
  EXPECT_THAT(refused(setting(domain, {"depth=3"})), HasSubstr("depth: cannot change"));
  EXPECT_THAT(writer.told(), IsEmpty());
  EXPECT_THAT(refused(setting(domain, {"deadline_s=0.5"})),
              HasSubstr("minimum_separation_s: is longer than deadline_s"))
      << "the reader's own profile contradicts it";
  for (const std::string& ends : writer.told()) EXPECT_EQ(ends, "none");
  EXPECT_EQ(writer.matched(), 1);
}

TEST(Running, ATopicWithoutEndsOrWithForeignOnesOnlyIsSaid) {
  constexpr int domain = 92;
  Neighbour foreign(domain, "foreign", "{}", {true, false});
  Options options = setting(domain, {"deadline_s=1"});
  EXPECT_TRUE(eventually([&] {
    return refused(options).find("belong to programs that are no containers") != std::string::npos;
  }));
  options.one = "/silence";
  options.spin_s = 0.5;
  EXPECT_THAT(refused(options), HasSubstr("nobody writes or reads /silence here"));
  options.one = "/chater";
  EXPECT_THAT(refused(options), HasSubstr("did you mean '/chatter'?"));
}

}  // namespace
}  // namespace tocsin::qos_tool
