// SPDX-License-Identifier: Apache-2.0
// Bulk, capacity, budget, thinning.
#include "link_pair.hpp"

namespace tocsin::router {
namespace {

TEST(Adaptation, BulkWaitsUntilTheRadioHasSentTheOneBefore) {
  LinkRouterParams params;
  params.bulk_under_way = 2;
  LinkPair link(params);
  StreamRule camera = rule_of(TrafficClass::low);
  link.add(1, camera);
  link.add(2, rule_of(TrafficClass::critical));
  learn_capacity(link, 1);
  const std::size_t before = link.sent.size();
  const std::size_t pieces = count_pieces(picture_bytes, largest_piece);
  link.offer(1, 100, picture_bytes);
  link.run(ms);
  link.offer(1, 101, picture_bytes);
  link.offer(2, 1);
  link.run(3 * ms);
  ASSERT_EQ(link.sent.size(), before + pieces + 1)
      << "the second picture waits, the small one does not";
  EXPECT_EQ(link.sent.back().stream, 2U);
  link.run(40 * ms);
  EXPECT_EQ(link.sent.back().sample.origin.sequence, 101U);
}

TEST(Adaptation, AFreezeOfTheSenderIsNotTakenForASlowRadio) {
  LinkPair link;
  link.add(1, rule_of(TrafficClass::low));
  learn_capacity(link, 1);
  const double capacity = link.sender.capacity_bytes_per_s(link.now);
  link.offer(1, 100, picture_bytes);
  link.run(ms);
  link.freeze(std::chrono::seconds(5));
  link.run(200 * ms);
  EXPECT_GE(link.sender.capacity_bytes_per_s(link.now), capacity);
  link.offer(1, 101, picture_bytes);
  link.run(200 * ms);
  EXPECT_EQ(link.delivered[1].back(), 101U);
}

TEST(Adaptation, BulkWaitsForTheAcknowledgementOfTheOneBefore) {
  LinkPair link;
  link.add(1, rule_of(TrafficClass::low));
  learn_capacity(link, 1);
  const std::size_t pieces = count_pieces(picture_bytes, largest_piece);
  link.offer(1, 100, picture_bytes);
  link.run(static_cast<int>(pieces) * ms + 5 * ms);
  ASSERT_EQ(link.delivered[1].back(), 100U);
  link.offer(1, 101, picture_bytes);
  link.run(10 * ms);
  EXPECT_EQ(link.sent.back().sample.origin.sequence, 100U) << "nothing has named it yet";
  link.run(60 * ms);
  EXPECT_EQ(link.sent.back().sample.origin.sequence, 101U);
}

TEST(Adaptation, OfThoseThatGoWholeTwoMayBeUnderWay) {
  LinkPair link;
  link.add(1, rule_of(TrafficClass::low));
  learn_capacity(link, 1);
  link.sender.set_largest_piece(0);
  link.loses = [](const Transmission& one) { return one.stream == 1; };
  const std::size_t before = link.count_sent(1);
  for (std::uint64_t i = 100; i < 103; ++i) {
    link.offer(1, i, picture_bytes);
    link.run(60 * ms);
  }
  EXPECT_EQ(link.count_sent(1), before + 2);
}

TEST(Adaptation, AnAdaptiveSourceHoldsWhileItsLastSampleWaits) {
  LinkPair link;
  StreamRule camera = rule_of(TrafficClass::low);
  camera.adaptive = true;
  link.add(1, camera);
  for (std::uint64_t sequence = 1; sequence < 3; ++sequence) link.offer(1, sequence, picture_bytes);
  EXPECT_TRUE(link.sender.budgets(link.now).at(0).hold);
  link.run(ms);
  link.offer(1, 3, picture_bytes);
  link.run(ms);
  EXPECT_TRUE(link.sender.budgets(link.now).at(0).hold);
  link.run(1000 * ms);
  EXPECT_FALSE(link.sender.budgets(link.now).at(0).hold);
}

/// Offers a picture each 50 ms for ten seconds. Returns how many crossed.
std::size_t pictures_in_ten_seconds(LinkPair& link) {
  std::uint64_t sequence = 1000;
  const std::size_t before = link.delivered[1].size();
  for (int i = 0; i < 200; ++i) {
    link.offer(1, sequence++, picture_bytes);
    link.offer(2, sequence);
    link.run(50 * ms);
  }
  return link.delivered[1].size() - before;
}

TEST(Adaptation, BulkKeepsToItsShareOfTheAir) {
  LinkPair link;
  link.add(1, rule_of(TrafficClass::low));
  link.add(2, rule_of(TrafficClass::critical));
  learn_capacity(link, 1);
  const std::size_t all = pictures_in_ten_seconds(link);
  link.sender.set_airtime_share(0.1);
  const std::size_t urgent = link.count_sent(2);
  const std::size_t some = pictures_in_ten_seconds(link);
  // A picture of 34 packets takes 34 ms of the air, 36 ms with its delay.
  EXPECT_NEAR(static_cast<double>(some), 10 * 0.1 / 0.035, 5);
  EXPECT_GT(all, 3 * some);
  EXPECT_EQ(link.count_sent(2) - urgent, 200U) << "what is urgent is not bounded";
  EXPECT_NEAR(link.sender.airtime_used(link.now), 0.1, 0.04);
}

TEST(Adaptation, AnAdaptiveSourceFillsItsShareOfTheAir) {
  LinkPair link;
  StreamRule camera = rule_of(TrafficClass::low);
  camera.adaptive = true;
  link.add(1, camera);
  link.add(2, rule_of(TrafficClass::critical));
  learn_capacity(link, 1);
  EXPECT_EQ(link.sender.budgets(link.now).at(0).scale, 1);
  link.sender.set_airtime_share(0.12);  // of one in seven; the camera wants about two
  (void)pictures_in_ten_seconds(link);
  EXPECT_LT(link.sender.budgets(link.now).at(0).scale, 0.7);
}

}  // namespace
}  // namespace tocsin::router
