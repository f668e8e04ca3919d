// SPDX-License-Identifier: Apache-2.0
// QoS that changes while the ends exist. Real Fast DDS on loopback; each test has a domain of its
// own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fast_dds/bus_fixture.hpp"
#include "foundation/error.hpp"
#include "ros_idl/std_msgs.hpp"
#include "runtime/host_control.hpp"
#include "runtime/middleware/qos_change.hpp"

namespace tocsin {
namespace {

const Endpoint text{{"text", "sensor", Scope::host}, &type_info<std_msgs::msg::String>()};

class LiveQos : public ::testing::Test {
 protected:
  static int domain() {
    static int next = 190;
    return ++next;
  }
  static QosChange writers(const std::string& settings) { return {"text", true, false, settings}; }
  static QosChange readers(const std::string& settings) { return {"text", false, true, settings}; }
  static int matched(Bus& bus, bool writer) { return health_of(bus, "text", writer).matched; }
};

std::shared_ptr<const void> said(const std::string& words) {
  auto message = std::make_shared<std_msgs::msg::String>();
  message->data(words);
  return message;
}

TEST_F(LiveQos, ADeadlineThatIsNoLongerOfferedUnmatchesAndIsNamedUntilItIsOfferedAgain) {
  const int one = domain();
  const auto a = make_test_bus(one, "sensor: {deadline_s: 1}\n");
  const auto b = make_test_bus(one, "sensor: {deadline_s: 1}\n");
  Samples samples;
  const auto writer = a->advertise(text);
  const auto reader = b->subscribe(text, samples);
  ASSERT_TRUE(eventually([&] { return matched(*a, true) == 1 && matched(*b, false) == 1; }));
  EXPECT_EQ(a->host_control().change_qos(writers("deadline_s: 2")), 1);
  EXPECT_TRUE(eventually([&] { return matched(*a, true) == 0 && matched(*b, false) == 0; }));
  EXPECT_TRUE(eventually([&] { return health_of(*b, "text", false).misfit == "deadline (test)"; }));
  EXPECT_EQ(health_of(*a, "text", true).misfit, "deadline (test)");
  EXPECT_EQ(b->host_control().change_qos(readers("deadline_s: 3")), 1);
  EXPECT_TRUE(eventually([&] { return matched(*a, true) == 1 && matched(*b, false) == 1; }));
  EXPECT_EQ(health_of(*a, "text", true).misfit, "");
}

TEST_F(LiveQos, AnEndMovesToAnotherPartitionAndBackAndTakesNoOtherTopicAlong) {
  const int one = domain();
  const auto a = make_test_bus(one, "sensor: {partition: [left]}\n");
  const auto b = make_test_bus(one, "sensor: {partition: [left]}\n");
  const Endpoint other{{"other", "sensor", Scope::host}, text.type};
  Samples samples;
  Samples others;
  const auto writer = a->advertise(text);
  const auto writer_of_other = a->advertise(other);
  const auto reader = b->subscribe(text, samples);
  const auto reader_of_other = b->subscribe(other, others);
  const auto others_matched = [&] { return health_of(*a, "other", true).matched; };
  ASSERT_TRUE(eventually([&] { return matched(*a, true) == 1 && others_matched() == 1; }));
  EXPECT_EQ(a->host_control().change_qos(writers("partition: [right]")), 1);
  EXPECT_TRUE(eventually([&] { return matched(*a, true) == 0; }));
  EXPECT_EQ(others_matched(), 1);
  EXPECT_EQ(a->host_control().change_qos(writers("partition: []")), 1);
  EXPECT_EQ(b->host_control().change_qos(readers("partition: []")), 1);
  ASSERT_TRUE(eventually([&] { return matched(*a, true) == 1 && matched(*b, false) == 1; }));
  EXPECT_EQ(writer->write(said("again")), Status::ok);
  EXPECT_TRUE(samples.wait_for(1));
}

TEST_F(LiveQos, TheOwnerChangesWithTheStrength) {
  const int one = domain();
  const auto strong = make_test_bus(one, "sensor: {ownership: exclusive, ownership_strength: 5}\n");
  const auto weak = make_test_bus(one, "sensor: {ownership: exclusive, ownership_strength: 1}\n");
  const auto listening = make_test_bus(one, "sensor: {ownership: exclusive}\n");
  Samples samples;
  const auto first = strong->advertise(text);
  const auto second = weak->advertise(text);
  const auto reader = listening->subscribe(text, samples);
  ASSERT_TRUE(eventually([&] { return matched(*listening, false) == 2; }));
  const auto newest = [&] {
    (void)first->write(said("strong"));
    (void)second->write(said("weak"));
    const auto all = samples.all();
    return all.empty()
               ? ""
               : static_cast<const std_msgs::msg::String*>(all.back().message.get())->data();
  };
  ASSERT_TRUE(eventually([&] { return newest() == "strong"; }));
  EXPECT_EQ(weak->host_control().change_qos(writers("ownership_strength: 9")), 1);
  EXPECT_TRUE(eventually([&] { return newest() == "weak"; }));
}

TEST_F(LiveQos, ALaterReaderOfTheTopicRequestsWhatWasChanged) {
  const int one = domain();
  const auto a = make_test_bus(one, "sensor: {deadline_s: 1}\n");
  const auto b = make_test_bus(one, "sensor: {deadline_s: 1}\n");
  Samples samples;
  const auto writer = a->advertise(text);
  {
    const auto reader = b->subscribe(text, samples);
    ASSERT_TRUE(eventually([&] { return matched(*a, true) == 1; }));
    EXPECT_EQ(b->host_control().change_qos(readers("deadline_s: 0.5")), 1);
    ASSERT_TRUE(eventually([&] { return matched(*a, true) == 0; }));
  }
  const auto reader = b->subscribe(text, samples);
  EXPECT_TRUE(eventually([&] { return health_of(*a, "text", true).misfit == "deadline (test)"; }));
}

TEST_F(LiveQos, TheRateOfAWriterCanChange) {
  const auto bus = make_test_bus(domain(), "sensor: {}\n");
  Samples samples;
  const auto writer = bus->advertise(text);
  const auto reader = bus->subscribe(text, samples);
  EXPECT_EQ(bus->host_control().change_qos(writers("max_rate_hz: 0.001")), 1);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(writer->write(said("x")), Status::ok);
  EXPECT_EQ(samples.all().size(), 2U) << "one may come early";
  EXPECT_EQ(health_of(*bus, "text", true).thinned, 3U);
}

TEST_F(LiveQos, ARequestForNeitherEndIsCheckedOnly) {
  const auto bus = make_test_bus(domain(), "sensor: {max_rate_hz: 10}\n");
  const auto writer = bus->advertise(text);
  EXPECT_EQ(bus->host_control().change_qos({"text", false, false, "max_rate_hz: 0.001"}), 0);
  EXPECT_THROW(bus->host_control().change_qos({"text", false, false, "deadline_s: 0.01"}),
               ConfigError);
  for (int i = 0; i < 2; ++i) EXPECT_EQ(writer->write(said("x")), Status::ok);
  EXPECT_EQ(health_of(*bus, "text", true).thinned, 0U) << "the old rate lets two pass";
}

TEST_F(LiveQos, ATopicThatNobodyHasAndAPolicyThatIsFixedChangeNothing) {
  const auto bus = make_test_bus(domain(), "sensor: {}\n");
  EXPECT_EQ(bus->host_control().change_qos(writers("deadline_s: 1")), 0);
  const auto writer = bus->advertise(text);
  EXPECT_EQ(bus->host_control().change_qos(readers("deadline_s: 1")), 0) << "it has no reader";
  EXPECT_THROW(bus->host_control().change_qos(writers("durability: transient_local")), ConfigError);
}

}  // namespace
}  // namespace tocsin
