// SPDX-License-Identifier: Apache-2.0
#include "fetching.hpp"

#include <gmock/gmock.h>

#include "bag/bag_reader.hpp"
#include "fake_graph.hpp"
#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "idl_support/decode.hpp"
#include "idl_support/encode.hpp"
#include "ros_idl/std_msgs.hpp"

namespace tocsin::log_tool {
namespace {

using ::testing::ElementsAre;
using String = std_msgs::msg::String;
constexpr std::int64_t second_ns = 1'000'000'000;
constexpr const char* states_topic = "rt/link_state";
constexpr const char* requests_topic = "rt/log_request";

tocsin_msgs::msg::LogRequest request() {
  tocsin_msgs::msg::LogRequest request;
  request.id(41);
  request.topic("notes");
  request.from_ns(100 * second_ns);
  request.to_ns(200 * second_ns);
  return request;
}

RawSample state(const char* word, std::uint64_t found) {
  tocsin_msgs::msg::LogFetch fetch;
  fetch.id(41);
  fetch.state(word);
  fetch.found(found);
  tocsin_msgs::msg::LinkState state;
  state.role("uxv");
  state.fetches({fetch});
  RawSample sample;
  sample.bytes = std::make_shared<const std::vector<std::uint8_t>>(
      encode(type_info<tocsin_msgs::msg::LinkState>(), &state));
  sample.received = Time(std::chrono::hours(1));
  return sample;
}

RawSample note(std::uint64_t sequence, std::int64_t sent_s) {
  String text;
  text.data("note " + std::to_string(sequence));
  RawSample sample;
  sample.bytes =
      std::make_shared<const std::vector<std::uint8_t>>(encode(type_info<String>(), &text));
  sample.source = 9;
  sample.sequence = sequence;
  sample.sent_wall_ns = sent_s * second_ns;
  return sample;
}

/// Time that passes when it is waited for.
class VirtualTime {
 public:
  [[nodiscard]] Waiting waiting() {
    return {[this] { return now_; }, [this](Time due) { now_ = due; }};
  }

 private:
  Time now_{std::chrono::hours(1)};
};

TEST(Fetching, AsksAndWritesWhatIsFilledInUntilItIsDone) {
  const TemporaryFolder folder;
  VirtualTime time;
  FakeGraph graph;
  StateListener states(graph);
  Fetching sut(graph, states, request(), folder.path("fetched"), time.waiting());
  graph.add_writer("rt/notes/backfilled", type_info<String>().name);
  graph.on_write = [&graph](const std::string& topic) {
    if (topic != requests_topic || graph.written[topic].size() != 2) return;
    // It has been reading since it asked first.
    for (const auto& [sequence, sent_s] : {std::pair{1, 50}, {2, 100}, {3, 150}, {4, 250}}) {
      graph.give("rt/notes/backfilled", note(static_cast<std::uint64_t>(sequence), sent_s));
    }
    graph.give(states_topic, state("done", 2));
  };
  EXPECT_TRUE(sut.run());
  EXPECT_EQ(sut.written(), 2U) << "two are of another request";
  EXPECT_EQ(sut.lost(), 0U);
  EXPECT_EQ(sut.fetch().found(), 2U);
  const auto asked =
      decode(type_info<tocsin_msgs::msg::LogRequest>(), graph.written[requests_topic].at(0));
  ASSERT_TRUE(asked);
  EXPECT_EQ(static_cast<const tocsin_msgs::msg::LogRequest*>(asked.get())->topic(), "notes");

  bag::BagReader bag(folder.path("fetched"));
  ASSERT_EQ(bag.topics().size(), 1U);
  EXPECT_EQ(bag.topics()[0].topic.name, "/notes") << "so that it can be merged with what came live";
  EXPECT_EQ(bag.topics()[0].topic.type, "std_msgs/msg/String");
  std::vector<std::int64_t> times;
  const auto messages = bag.messages();
  while (const auto one = messages->next()) {
    times.push_back(one->message.log_time_ns / second_ns);
    EXPECT_EQ(one->message.writer, 9U);
  }
  EXPECT_THAT(times, ElementsAre(100, 150));
}

TEST(Fetching, IsDoneWithoutAWriterWhenThereIsNothing) {
  const TemporaryFolder folder;
  VirtualTime time;
  FakeGraph graph;
  StateListener states(graph);
  Fetching sut(graph, states, request(), folder.path("fetched"), time.waiting());
  graph.on_write = [&graph](const std::string&) { graph.give(states_topic, state("done", 0)); };
  EXPECT_TRUE(sut.run());
  EXPECT_EQ(sut.written(), 0U);
  EXPECT_EQ(sut.fetch().found(), 0U);
}

TEST(Fetching, RefusesABagThatIsThere) {
  const TemporaryFolder folder;
  (void)folder.write("fetched/precious", "x");
  FakeGraph graph;
  StateListener states(graph);
  EXPECT_THROW(Fetching(graph, states, request(), folder.path("fetched")), ConfigError);
}

TEST(StateListener, KnowsTheTopicsOfItsNamespace) {
  FakeGraph graph;
  const StateListener sut(graph, "uxv3");
  EXPECT_EQ(sut.on_wire("log_request"), "rt/uxv3/log_request");
  EXPECT_EQ(StateListener(graph).on_wire("log_request"), "rt/log_request");
}

TEST(StateListener, GivesEachStateOnceAndLeavesOutWhatIsNone) {
  FakeGraph graph;
  StateListener sut(graph);
  graph.give(states_topic, state("searching", 1));
  RawSample damaged = state("done", 1);
  damaged.bytes = std::make_shared<const std::vector<std::uint8_t>>(3);
  graph.give(states_topic, damaged);
  graph.give(states_topic, state("sending", 1));
  const auto heard = sut.take();
  ASSERT_EQ(heard.size(), 2U);
  EXPECT_EQ(heard[0].state.fetches().at(0).state(), "searching");
  EXPECT_EQ(heard[1].state.fetches().at(0).state(), "sending");
  EXPECT_TRUE(sut.take().empty());
}

}  // namespace
}  // namespace tocsin::log_tool
