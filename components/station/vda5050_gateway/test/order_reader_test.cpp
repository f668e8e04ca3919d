// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "order_texts.hpp"
#include "vda5050_gateway/order.hpp"

namespace tocsin::vda5050 {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using Change = std::function<void(json&)>;

class OrderReaderTest : public ::testing::TestWithParam<Version> {
 protected:
  [[nodiscard]] std::variant<Order, Fault> read(const std::string& text) const {
    return read_order(text, texts_.identity(), {});
  }
  [[nodiscard]] Fault fault_of(const Change& change) const {
    json order = texts_.order(3, 2);
    change(order);
    const auto read_back = read(order.dump());
    const auto* fault = std::get_if<Fault>(&read_back);
    if (fault == nullptr) ADD_FAILURE() << "taken: " << order;
    return fault == nullptr ? Fault{} : *fault;
  }
  [[nodiscard]] bool takes(const Change& change) const {
    json order = texts_.order(3, 2);
    change(order);
    return std::holds_alternative<Order>(read(order.dump()));
  }
  const OrderTexts texts_{GetParam()};
};
INSTANTIATE_TEST_SUITE_P(Versions, OrderReaderTest, ::testing::Values(Version::v2_1, Version::v3_0),
                         [](const auto& one) { return one.param == Version::v2_1 ? "v2" : "v3"; });

TEST_P(OrderReaderTest, ReadsNodesAndEdges) {
  const auto order = std::get<Order>(read(texts_.order(3, 2).dump()));
  EXPECT_EQ(order.id, "o1");
  EXPECT_EQ(order.update, 0u);
  ASSERT_EQ(order.nodes.size(), 3u);
  EXPECT_EQ(order.nodes[1].id, "b");
  EXPECT_EQ(order.nodes[1].sequence, 2u);
  EXPECT_TRUE(order.nodes[1].released);
  EXPECT_FALSE(order.nodes[2].released);
  EXPECT_EQ(order.nodes[2].pose.x_m, 2);
  ASSERT_EQ(order.edges.size(), 2u);
  EXPECT_EQ(order.edges[1].id, "bc");
}

TEST_P(OrderReaderTest, ANodeWithoutAHeadingHasThatOfTheWayToIt) {
  json text = texts_.order(3, 3);
  text["nodes"][1]["nodePosition"]["y"] = 1;
  text["nodes"][2]["nodePosition"]["theta"] = -2.0;
  const auto order = std::get<Order>(read(text.dump()));
  EXPECT_NEAR(order.nodes[1].pose.heading_rad, 0.7854, 1e-4);
  EXPECT_EQ(order.nodes[2].pose.heading_rad, -2.0);
}

struct Bad {
  const char* change;  // JSON patch
  ErrorType type;
  const char* says;
};

class BadOrderTest : public OrderReaderTest {};
INSTANTIATE_TEST_SUITE_P(Versions, BadOrderTest, ::testing::Values(Version::v2_1, Version::v3_0),
                         [](const auto& one) { return one.param == Version::v2_1 ? "v2" : "v3"; });

TEST_P(BadOrderTest, IsRefusedByTheFieldThatIsWrong) {
  constexpr auto invalid = ErrorType::validation_failure;
  constexpr auto unsupported = ErrorType::unsupported_parameter;
  const Bad rows[] = {
      {R"({"op":"remove","path":"/headerId"})", invalid, "headerId is missing"},
      {R"({"op":"replace","path":"/headerId","value":-1})", invalid, "headerId is not a whole"},
      {R"({"op":"replace","path":"/timestamp","value":7})", invalid, "timestamp is not a string"},
      {R"({"op":"replace","path":"/version","value":"1.1.0"})", invalid, "version is '1.1.0'"},
      {R"({"op":"replace","path":"/serialNumber","value":"uxv2"})", invalid, "not 'uxv1'"},
      {R"({"op":"replace","path":"/manufacturer","value":"x"})", invalid, "not 'tocsin'"},
      {R"({"op":"replace","path":"/orderId","value":""})", invalid, "orderId is empty"},
      {R"({"op":"replace","path":"/orderUpdateId","value":4294967296})", invalid, "more than"},
      {R"({"op":"replace","path":"/orderUpdateId","value":1.5})", invalid, "not a whole number"},
      {R"({"op":"replace","path":"/nodes","value":[]})", invalid, "nodes is empty"},
      {R"({"op":"replace","path":"/nodes","value":{}})", invalid, "nodes is not an array"},
      {R"({"op":"remove","path":"/edges/1"})", invalid, "edges has 1 items for 3 nodes"},
      {R"({"op":"replace","path":"/nodes/1/sequenceId","value":4})", invalid,
       "nodes[1].sequenceId is 4, not 2"},
      {R"({"op":"replace","path":"/edges/1/sequenceId","value":2})", invalid,
       "edges[1].sequenceId is 2, not 3"},
      {R"({"op":"replace","path":"/nodes/0/released","value":false})", invalid,
       "nodes[0].released"},
      {R"({"op":"replace","path":"/nodes/2/released","value":true})", invalid,
       "not as that of the edge before"},
      {R"({"op":"replace","path":"/nodes/1/released","value":"yes"})", invalid,
       "nodes[1].released is not true or false"},
      {R"({"op":"remove","path":"/nodes/1/nodePosition"})", invalid,
       "nodes[1].nodePosition is missing"},
      {R"({"op":"replace","path":"/nodes/1/nodePosition/x","value":null})", invalid,
       "nodes[1].nodePosition.x is not a number"},
      {R"({"op":"add","path":"/nodes/1/nodePosition/theta","value":3.2})", invalid,
       "theta is 3.2, outside"},
      {R"({"op":"add","path":"/nodes/1/nodePosition/allowedDeviationXY","value":-1})", invalid,
       "allowedDeviationXY"},
      {R"({"op":"replace","path":"/nodes/1/nodePosition/mapId","value":"hall"})",
       ErrorType::unknown_map_id, "mapId is 'hall', not 'map'"},
      {R"({"op":"remove","path":"/nodes/2/actions"})", invalid, "nodes[2].actions is missing"},
      {R"({"op":"add","path":"/edges/0/maxSpeed","value":0.2})", unsupported,
       "edges[0].maxSpeed is 0.2, less than the vehicle's 0.5"},
      {R"({"op":"add","path":"/edges/0/trajectory","value":{}})", unsupported, "not supported"},
      {R"({"op":"add","path":"/edges/0/corridor","value":{}})", unsupported, "not supported"},
      {R"({"op":"add","path":"/edges/0/orientation","value":0})", unsupported, "not supported"},
      {R"({"op":"add","path":"/edges/0/rotationAllowed","value":false})", unsupported, "be true"},
      {R"({"op":"add","path":"/edges/0/maxHeight","value":0.1})", unsupported, "maxHeight"},
      {R"({"op":"add","path":"/zoneSetId","value":"z"})", unsupported, "zoneSetId"},
  };
  for (const Bad& row : rows) {
    const Fault fault =
        fault_of([&](json& order) { order = order.patch(json::array({json::parse(row.change)})); });
    EXPECT_EQ(fault.type, row.type) << row.change << fault.description;
    EXPECT_THAT(fault.description, HasSubstr(row.says)) << row.change;
  }
}

TEST_P(BadOrderTest, AnActionThatTheVehicleCannotDoIsNamed) {
  const auto with = [](const json& action, const char* where) {
    return [=](json& order) { order[where][0]["actions"].push_back(action); };
  };
  const Fault pick = fault_of(with(OrderTexts::action("pick", "p1"), "nodes"));
  EXPECT_EQ(pick.type, ErrorType::invalid_order_action);
  EXPECT_THAT(pick.description, HasSubstr("'pick'"));
  EXPECT_EQ(fault_of(with(OrderTexts::action("startCharging", "c1"), "edges")).type,
            ErrorType::invalid_order_action);
  EXPECT_TRUE(takes(with(OrderTexts::action("startCharging", "c1"), "nodes")));
  json wrong = OrderTexts::action("startCharging", "c1");
  wrong["blockingType"] = "MAYBE";
  EXPECT_EQ(fault_of(with(wrong, "nodes")).type, ErrorType::validation_failure);
}

TEST_P(BadOrderTest, AnActionIdIsThereOnce) {
  const Fault fault = fault_of([](json& order) {
    order["nodes"][0]["actions"].push_back(OrderTexts::action("startCharging", "c1"));
    order["nodes"][1]["actions"].push_back(OrderTexts::action("startCharging", "c1"));
  });
  EXPECT_THAT(fault.description, HasSubstr("'c1' is there twice"));
}

TEST_P(BadOrderTest, NamesTheOrderThatItIsAbout) {
  const Fault fault = fault_of([](json& order) { order["nodes"][0]["released"] = false; });
  ASSERT_EQ(fault.references.size(), 2u);
  EXPECT_EQ(fault.references[0].second, "o1");
}

TEST_P(OrderReaderTest, TakesLimitsThatTheVehicleKeepsAnyway) {
  EXPECT_TRUE(takes([](json& order) {
    json& edge = order["edges"][0];
    edge["maxSpeed"] = 0.5;
    edge["maximumSpeed"] = 2;
    edge["maxRotationSpeed"] = 1.5;
    edge["maxHeight"] = 2;
    edge["minHeight"] = 0;
    edge["length"] = 1;
    edge["rotationAllowed"] = true;
    edge["edgeDescription"] = "by the window";
    edge["fieldOfALaterVersion"] = {1, 2};
  }));
}

TEST_P(OrderReaderTest, RefusesWhatIsNoJsonOrTooLarge) {
  for (const std::string& text : {std::string(), std::string("{"), std::string("[]"),
                                  std::string("\xff\xfe"), std::string("{\"headerId\": 1e999}")}) {
    EXPECT_EQ(std::get<Fault>(read(text)).type, ErrorType::validation_failure) << text;
  }
  const auto large = std::get<Fault>(read(std::string(most_message_bytes + 1, ' ')));
  EXPECT_THAT(large.description, HasSubstr("more than 262144"));
  EXPECT_EQ(std::get<Fault>(read(std::string(100000, '['))).type, ErrorType::validation_failure);
}

TEST_P(OrderReaderTest, MoreNodesThanTheVehicleHoldsAreTooMany) {
  json order = texts_.order(1, 1);
  for (std::size_t i = 1; i <= most_nodes; ++i) order["nodes"].push_back(order["nodes"][0]);
  EXPECT_EQ(std::get<Fault>(read(order.dump())).type, ErrorType::insufficient_memory);
}

/// Whatever a byte of an order becomes, it is an order or has a fault.
TEST_P(OrderReaderTest, SurvivesAnyByte) {
  const std::string text = texts_.order(4, 3).dump();
  std::mt19937 random(7);
  for (int i = 0; i < 5000; ++i) {
    std::string changed = text;
    for (int k = 0; k < 1 + i % 3; ++k) {
      changed[random() % changed.size()] = static_cast<char>(random() % 256);
    }
    const auto result = read(changed);
    if (const auto* order = std::get_if<Order>(&result)) {
      EXPECT_EQ(order->edges.size() + 1, order->nodes.size());
    }
  }
}

TEST(AllowedDeviationTest, IsACircleInOneVersionAndAnEllipseInTheOther) {
  json old = OrderTexts(Version::v2_1).order(1, 1);
  old["nodes"][0]["nodePosition"]["allowedDeviationXY"] = 0.7;
  const auto circle =
      std::get<Order>(read_order(old.dump(), OrderTexts(Version::v2_1).identity(), {}));
  EXPECT_EQ(circle.nodes[0].deviation_b_m, 0.7);
  json text = OrderTexts().order(1, 1);
  text["nodes"][0]["nodePosition"]["allowedDeviationXY"] = {{"a", 2}, {"b", 1}, {"theta", 0.5}};
  const auto ellipse = std::get<Order>(read_order(text.dump(), OrderTexts().identity(), {}));
  EXPECT_EQ(ellipse.nodes[0].deviation_a_m, 2);
  EXPECT_EQ(ellipse.nodes[0].deviation_b_m, 1);
  EXPECT_EQ(ellipse.nodes[0].deviation_rad, 0.5);
}

TEST(EdgeEndsTest, MustBeTheNodesBesideItWhereTheyAreNamed) {
  json order = OrderTexts(Version::v2_1).order(2, 2);
  order["edges"][0]["endNodeId"] = "z";
  const auto fault =
      std::get<Fault>(read_order(order.dump(), OrderTexts(Version::v2_1).identity(), {}));
  EXPECT_THAT(fault.description, HasSubstr("edges[0].endNodeId is not 'b'"));
}

TEST(InstantActionsReaderTest, ReadsParametersByTheirKey) {
  const OrderTexts texts;
  const auto actions = std::get<std::vector<Action>>(read_instant_actions(
      texts.instant("cancelOrder", "i1", {{"orderId", "o1"}}), texts.identity()));
  ASSERT_EQ(actions.size(), 1u);
  EXPECT_EQ(actions[0].text("orderId"), "o1");
  EXPECT_EQ(actions[0].number("orderId"), std::nullopt);
  EXPECT_TRUE(
      std::holds_alternative<Fault>(read_instant_actions("{\"actions\": 1}", texts.identity())));
}

}  // namespace
}  // namespace tocsin::vda5050
