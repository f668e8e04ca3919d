// SPDX-License-Identifier: Apache-2.0
// What a station's router keeps of what arrives, for readers that come late.
#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "backfill_fixture.hpp"
#include "sample_log/consumer.hpp"

namespace tocsin {
namespace {

using sample_log::Consumer;
using sample_log::LogStart;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr FlowId other_flow = 800;

class ArrivalLogTest : public StoreTest {
 protected:
  ArrivalLogTest()
      : StoreTest(
            "uxv: {normal: {topics: [goal, pose]}}\n"
            "gcs: {low: {topics: [goal, odom], store: [goal], keep: [goal]}}\n") {
    next_instance();
  }
  void next_instance() {
    start();
    meet();
    script_.happen(link_event::PeerFlow{peer_backfills, station, 9, flow(backfill_topic)});
    Flow stored = flow("goal");
    stored.stored = true;
    script_.happen(link_event::PeerFlow{peer_flow, station, 10, stored});
    script_.happen(link_event::PeerFlow{other_flow, station, 11, flow("odom")});
    run(0.2);  // readers have found the writers
  }
  /// All that a late reader finds, after the router has written it.
  [[nodiscard]] std::vector<std::uint64_t> kept(const std::string& topic = "/goal") {
    run(1);
    Consumer consumer(folder_.path("store/history"), {topic, ""}, {LogStart::From::beginning});
    std::vector<std::uint64_t> sequences;
    for (const auto& sample : consumer.read()) sequences.push_back(sample.id.sequence);
    return sequences;
  }
};

TEST_F(ArrivalLogTest, KeepsWhatWasLiveAndWhatWasBackfilled) {
  receive(1, 1);
  receive(2, 4);
  backfill(1, {2, 3});
  EXPECT_THAT(kept(), ElementsAre(1, 4, 2, 3)) << "as they arrived";
}

TEST_F(ArrivalLogTest, KeepsNothingThatIsNotListed) {
  CarriedSample sample;
  sample.bytes = 100;
  sample.source = 3;
  sample.sequence = 1;
  script_.happen(link_event::LinkSample{other_flow, 1, sample, host_->bus.now()});
  run(0);
  EXPECT_THAT(kept("/odom"), IsEmpty());
  begin("goal");
  write(1);
  EXPECT_THAT(kept(), IsEmpty()) << "of this host's own topics the list log says it";
}

TEST_F(ArrivalLogTest, EachSampleIsInItOnceOverInstancesOfBothSides) {
  receive(1, 1);
  EXPECT_THAT(kept(), ElementsAre(1));
  next_instance();
  receive(1, 1);
  receive(2, 2);
  EXPECT_THAT(kept(), ElementsAre(1, 2));
}

}  // namespace
}  // namespace tocsin
