// SPDX-License-Identifier: Apache-2.0
#include "graph_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"

namespace tocsin::topic_tool {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

GraphEnd end(const std::string& topic, bool writer, const std::string& name = "String") {
  GraphEnd made;
  made.topic = topic;
  made.type = "std_msgs::msg::dds_::" + name + "_";
  made.participant = "talker";
  made.gid = {1, 15, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3};
  made.writer = writer;
  made.qos.reliability = Reliability::reliable;
  return made;
}

const std::vector<GraphEnd> ends{end("rt/chatter", true),       end("rt/chatter", false),
                                 end("rt/chatter", false),      end("rt/_hidden", true),
                                 end("rt/alarm", true, "Bool"), end("rq/spinRequest", false)};

TEST(ListText, HasTopicsOfRosByName) { EXPECT_EQ(list_text(ends, {}), "/alarm\n/chatter\n"); }

TEST(InfoText, ShowsTheQosOfEachEndWhenItIsVerbose) {
  GraphEnd late = end("rt/state", true);
  late.qos.durability = Durability::transient_local;
  late.qos.deadline_s = 0.5;
  late.lifespan_s = 5;
  const std::string sut = info_text({late}, {}, "/state", true);
  EXPECT_THAT(sut, HasSubstr("Topic type: std_msgs/msg/String\nTopic type hash: INVALID\n"
                             "Endpoint type: PUBLISHER\n"
                             "GID: 01.0f.00.00.00.00.00.00.00.00.00.00.00.00.00.03\n"
                             "QoS profile:\n  Reliability: RELIABLE\n"));
  EXPECT_THAT(sut, HasSubstr("  Durability: TRANSIENT_LOCAL\n  Lifespan: 5000000000 nanoseconds\n"
                             "  Deadline: 500000000 nanoseconds\n  Liveliness: AUTOMATIC\n"));
}

TEST(InfoText, NamesTheNodesThatHaveAnEndAndItsTypeHash) {
  GraphEnd one = end("rt/state", true);
  one.user_data = "tocsinlayout=77;typehash=RIHS01_ab;";
  const std::vector<GraphNode> nodes{{"/uxv", "mux", {}, {one.gid}},
                                     {"/uxv", "smoother", {}, {one.gid}},
                                     {"/uxv", "other", {one.gid}, {}}};
  EXPECT_THAT(info_text({one}, nodes, "/state", true),
              HasSubstr("\nNode name: mux, smoother\nNode namespace: /uxv\n"
                        "Topic type: std_msgs/msg/String\nTopic type hash: RIHS01_ab\n"));
  EXPECT_THAT(info_text({one}, {}, "/state", true),
              HasSubstr("\nNode name: _NODE_NAME_UNKNOWN_\n"
                        "Node namespace: _NODE_NAMESPACE_UNKNOWN_\n"));
}

TEST(InfoText, SaysWhatAReaderRequestsAndThatItHasNoLifespan) {
  GraphEnd reader = end("rt/state", false);
  reader.qos.reliability = Reliability::best_effort;
  reader.qos.liveliness_lease_s = 2;
  reader.lifespan_s = 5;
  const std::string sut = info_text({reader}, {}, "/state", true);
  EXPECT_THAT(sut, HasSubstr("Publisher count: 0\n\nSubscription count: 1\n"));
  EXPECT_THAT(sut, HasSubstr("Endpoint type: SUBSCRIPTION\n"));
  EXPECT_THAT(sut, HasSubstr("  Reliability: BEST_EFFORT\n"));
  EXPECT_THAT(sut, HasSubstr("  Lifespan: Infinite\n"));
  EXPECT_THAT(sut, HasSubstr("  Liveliness lease duration: 2000000000 nanoseconds\n"));
}

TEST(Types, OfATopicAndTopicsOfAType) {
  std::vector<GraphEnd> two = ends;
  two.push_back(end("rt/chatter", true, "Bool"));
  EXPECT_THAT(types_of(two, "/chatter"), ElementsAre("std_msgs/msg/Bool", "std_msgs/msg/String"));
  EXPECT_THAT(types_of(two, "/nothing"), IsEmpty());
  EXPECT_THAT(topics_of_type(two, "std_msgs/msg/Bool"), ElementsAre("/alarm", "/chatter"));
}

TEST(Readable, IsWhatAllWritersOffer) {
  GraphEnd reliable = end("rt/x", true);
  reliable.qos.durability = Durability::transient_local;
  EXPECT_TRUE(readable({reliable}, "/x").reliable);
  EXPECT_TRUE(readable({reliable}, "/x").transient_local);
  GraphEnd best_effort = end("rt/x", true);
  best_effort.qos.reliability = Reliability::best_effort;
  EXPECT_FALSE(readable({reliable, best_effort}, "/x").reliable);
  EXPECT_FALSE(readable({reliable, best_effort}, "/x").transient_local);
  EXPECT_FALSE(readable({end("rt/x", false)}, "/x").reliable) << "writers are to come";
  EXPECT_EQ(readable({reliable}, "/x").name, "rt/x");
  EXPECT_EQ(readable({reliable}, "/x").type, "std_msgs::msg::dds_::String_");
}

TEST(Readable, NeedsSomebodyWhoKnowsTheType) {
  EXPECT_THROW((void)readable(ends, "/nothing"), EnvironmentError);
}

}  // namespace
}  // namespace tocsin::topic_tool
