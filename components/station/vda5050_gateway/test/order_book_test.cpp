// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "order_texts.hpp"
#include "vda5050_gateway/order_book.hpp"

namespace tocsin::vda5050 {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Taken = OrderBook::Taken;

class OrderBookTest : public ::testing::Test {
 protected:
  /// The type of the fault; nothing: taken.
  std::optional<ErrorType> take(const json& text, Version version = Version::v3_0) {
    const OrderTexts texts(version);
    const auto order = std::get<Order>(read_order(text.dump(), texts.identity(), {}));
    const auto fault = sut_.take(order, start_, version, &taken_);
    return fault ? std::optional(fault->type) : std::nullopt;
  }
  static json update(json order, int number) {
    order["orderUpdateId"] = number;
    return order;
  }
  [[nodiscard]] std::vector<std::string> left() const {
    std::vector<std::string> ids;
    for (const Node& node : sut_.nodes()) ids.push_back(node.id + (node.released ? "" : "?"));
    return ids;
  }
  [[nodiscard]] std::vector<std::string> leg() const {
    std::vector<std::string> ids;
    for (const Node& node : sut_.leg()) ids.push_back(node.id);
    return ids;
  }
  const OrderTexts texts_;
  OrderBook::Start start_{geometry::Pose{}, 0.3};
  Taken taken_{};
  OrderBook sut_;
};

TEST_F(OrderBookTest, TheFirstNodeIsWhereTheVehicleStands) {
  EXPECT_TRUE(sut_.is_idle());
  EXPECT_EQ(take(texts_.order(4, 3)), std::nullopt);
  EXPECT_EQ(sut_.last_node(), "a");
  EXPECT_THAT(left(), ElementsAre("b", "c", "d?"));
  EXPECT_EQ(sut_.edges().size(), 3u);
  EXPECT_THAT(leg(), ElementsAre("b", "c"));
  EXPECT_FALSE(sut_.is_idle());
}

TEST_F(OrderBookTest, TraversesTheBaseAndWaitsForTheHorizon) {
  take(texts_.order(3, 2));
  sut_.traverse();
  EXPECT_EQ(sut_.last_node(), "b");
  EXPECT_EQ(sut_.last_sequence(), 2u);
  sut_.traverse();
  EXPECT_THAT(left(), ElementsAre("c?"));
  EXPECT_THAT(leg(), IsEmpty());
  EXPECT_FALSE(sut_.is_idle()) << "a horizon waits for its release";
}

TEST_F(OrderBookTest, AnUpdateBeginsWithTheLastNodeOfTheBaseAndReplacesTheHorizon) {
  take(texts_.order(4, 2));
  EXPECT_EQ(take(update(texts_.order(3, 2, 1), 1)), std::nullopt);
  EXPECT_EQ(taken_, Taken::update);
  EXPECT_THAT(left(), ElementsAre("b", "c", "d?"));
  EXPECT_EQ(sut_.update(), 1u);
}

TEST_F(OrderBookTest, AnOrderThatIsOverGoesOnByAnUpdate) {
  take(texts_.order(2, 2));
  sut_.traverse();
  EXPECT_TRUE(sut_.is_idle());
  EXPECT_EQ(take(update(texts_.order(3, 3, 1), 1)), std::nullopt);
  EXPECT_THAT(left(), ElementsAre("c", "d"));
}

TEST_F(OrderBookTest, ARepetitionIsIgnoredAndAnotherContentRefused) {
  take(texts_.order(3, 3));
  EXPECT_EQ(take(texts_.order(3, 3)), std::nullopt);
  EXPECT_EQ(taken_, Taken::repetition);
  EXPECT_EQ(take(texts_.order(4, 4)), ErrorType::same_order_update_id);
  EXPECT_THAT(left(), ElementsAre("b", "c"));
}

TEST_F(OrderBookTest, AnOutdatedUpdateIsRefused) {
  take(texts_.order(2, 2));
  take(update(texts_.order(2, 2, 1), 5));
  EXPECT_EQ(take(update(texts_.order(3, 3, 1), 4)), ErrorType::outdated_order_update);
  EXPECT_EQ(sut_.update(), 5u);
}

TEST_F(OrderBookTest, AnUpdateAfterALostOneIsRefused) {
  take(texts_.order(2, 2));
  EXPECT_EQ(take(update(texts_.order(3, 3, 2), 2)), ErrorType::validation_failure);
  EXPECT_THAT(left(), ElementsAre("b"));
}

TEST_F(OrderBookTest, ANewOrderWaitsForTheEndOfThePresentOne) {
  take(texts_.order(3, 2));
  json other = texts_.order(2, 2);
  other["orderId"] = "o2";
  EXPECT_EQ(take(other), ErrorType::other_order_active);
  sut_.traverse();
  EXPECT_EQ(take(other), ErrorType::other_order_active) << "it has a horizon";
  sut_.clear();
  EXPECT_EQ(take(other), std::nullopt);
  EXPECT_EQ(taken_, Taken::order);
}

TEST_F(OrderBookTest, AnUpdateOfACanceledOrderIsRefused) {
  take(texts_.order(3, 3));
  sut_.clear();
  EXPECT_TRUE(sut_.is_idle());
  EXPECT_EQ(sut_.id(), "o1") << "the standard keeps it";
  EXPECT_EQ(take(update(texts_.order(3, 3, 2), 1)), ErrorType::order_update_following_cancel);
}

TEST_F(OrderBookTest, BeginsWithinTheDeviationOfTheFirstNode) {
  start_.pose = geometry::Pose{0, 1.5, 0};
  json order = texts_.order(2, 2);
  EXPECT_EQ(take(order), ErrorType::start_node_out_of_range);
  json& position = order["nodes"][0]["nodePosition"];
  position["allowedDeviationXY"] = {{"a", 2}, {"b", 0.1}, {"theta", 0}};
  EXPECT_EQ(take(order), ErrorType::start_node_out_of_range) << "across the ellipse";
  position["allowedDeviationXY"]["theta"] = 1.570796;
  EXPECT_EQ(take(order), std::nullopt) << "along it";
}

TEST_F(OrderBookTest, NeedsToKnowWhereTheVehicleIs) {
  start_.pose.reset();
  EXPECT_EQ(take(texts_.order(2, 2)), ErrorType::start_node_out_of_range);
}

TEST_F(OrderBookTest, ANewOrderBeginsWithUpdateZeroInTheNewerVersionOnly) {
  EXPECT_EQ(take(update(texts_.order(2, 2), 3)), ErrorType::validation_failure);
  const OrderTexts old(Version::v2_1);
  EXPECT_EQ(take(update(old.order(2, 2), 3), Version::v2_1), std::nullopt);
}

TEST_F(OrderBookTest, ALegEndsWhereThereIsSomethingToDo) {
  json order = texts_.order(4, 4);
  order["nodes"][2]["actions"].push_back(OrderTexts::action("startCharging", "c1"));
  take(order);
  EXPECT_THAT(leg(), ElementsAre("b", "c"));
  EXPECT_EQ(sut_.due(), nullptr);
  sut_.traverse();
  sut_.traverse();
  ASSERT_NE(sut_.due(), nullptr);
  EXPECT_EQ(sut_.due()->action.id, "c1");
  sut_.due()->status = ActionStatus::finished;
  EXPECT_EQ(sut_.due(), nullptr);
  EXPECT_THAT(leg(), ElementsAre("d"));
}

TEST_F(OrderBookTest, ActionsOfAHorizonThatIsReplacedAreGone) {
  json order = texts_.order(3, 2);
  order["nodes"][1]["actions"].push_back(OrderTexts::action("startCharging", "base"));
  order["nodes"][2]["actions"].push_back(OrderTexts::action("startCharging", "horizon"));
  take(order);
  EXPECT_EQ(sut_.actions().size(), 2u);
  json next = update(texts_.order(2, 2, 1), 1);
  next["nodes"][1]["actions"].push_back(OrderTexts::action("startCharging", "base"));
  EXPECT_EQ(take(next), ErrorType::validation_failure) << "an id of the base";
  next["nodes"][1]["actions"][0]["actionId"] = "horizon";
  EXPECT_EQ(take(next), std::nullopt);
  EXPECT_EQ(sut_.actions().size(), 2u);
  sut_.clear();
  for (const ActionState& state : sut_.actions()) EXPECT_EQ(state.status, ActionStatus::failed);
}

TEST_F(OrderBookTest, ASuccessorHasAllOfIt) {
  json order = texts_.order(4, 3);
  order["nodes"][1]["actions"].push_back(OrderTexts::action("startCharging", "c1", {{"k", 2}}));
  take(order);
  sut_.traverse();
  sut_.due()->status = ActionStatus::running;
  auto restored = OrderBook::restore(json::parse(sut_.save().dump()));
  ASSERT_TRUE(restored);
  EXPECT_EQ(restored->due()->status, ActionStatus::waiting) << "it begins again";
  sut_ = *restored;
  EXPECT_THAT(left(), ElementsAre("c", "d?"));
  EXPECT_EQ(sut_.last_node(), "b");
  EXPECT_EQ(sut_.due()->action.number("k"), 2);
  take(order);
  EXPECT_EQ(taken_, Taken::repetition);
  EXPECT_EQ(take(update(texts_.order(2, 2, 2), 1)), std::nullopt);
}

TEST_F(OrderBookTest, WhatIsNoneIsNotRestored) {
  take(texts_.order(3, 3));
  const json saved = sut_.save();
  for (const auto& [key, value] : saved.items()) {
    json broken = saved;
    broken.erase(key);
    EXPECT_FALSE(OrderBook::restore(broken)) << key;
  }
  json uneven = saved;
  uneven["edges"].erase(0);
  EXPECT_FALSE(OrderBook::restore(uneven));
  EXPECT_FALSE(OrderBook::restore(json(3)));
}

}  // namespace
}  // namespace tocsin::vda5050
