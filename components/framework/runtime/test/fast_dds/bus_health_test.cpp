// SPDX-License-Identifier: Apache-2.0
// What a bus tells of its DDS endpoints, and the order of samples on all ways. Real Fast DDS on
// loopback; each test has a domain of its own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fast_dds/bus_fixture.hpp"
#include "foundation/error.hpp"
#include "ros_idl/builtin_interfaces.hpp"
#include "ros_idl/geometry_msgs.hpp"
#include "ros_idl/std_msgs.hpp"

namespace tocsin {
namespace {

using String = std_msgs::msg::String;
using ::testing::ElementsAre;

constexpr TopicInfo topic{"text", "sensor", Scope::host};
const Endpoint text{topic, &type_info<String>()};
const char* const plain = "sensor: {reliability: reliable, depth: 200}\n";

std::shared_ptr<const String> message(int number) {
  auto made = std::make_shared<String>();
  made->data(std::to_string(number));
  return made;
}

std::vector<std::string> texts(const std::vector<Sample>& samples) {
  std::vector<std::string> all;
  for (const Sample& one : samples) {
    all.push_back(std::static_pointer_cast<const String>(one.message)->data());
  }
  return all;
}

class BusHealthTest : public ::testing::Test {
 protected:
  static int domain() {
    static int next = 40;
    return ++next;
  }
};

TEST_F(BusHealthTest, EveryWayDeliversEachSampleOnceAndInOrder) {
  const int one = domain();
  const auto a = make_test_bus(one, plain);
  const auto b = make_test_bus(one, plain);
  Samples near;
  Samples far;
  const auto near_reader = a->subscribe(text, near);
  const auto far_reader = b->subscribe(text, far);
  const auto writer = a->advertise(text);
  const auto other_writer = b->advertise(text);  // its reader skips what it hears of itself
  ASSERT_TRUE(eventually([&] { return health_of(*a, "text", true).matched == 1; }));
  std::vector<std::string> expected;
  for (int i = 0; i < 150; ++i) {
    ASSERT_EQ(writer->write(message(i)), Status::ok);
    expected.push_back(std::to_string(i));
  }
  ASSERT_TRUE(far.wait_for(150));
  EXPECT_EQ(texts(near.all()), expected);
  EXPECT_EQ(texts(far.all()), expected);
  EXPECT_EQ(health_of(*b, "text", false).samples, 150U);
}

TEST_F(BusHealthTest, OwnEndsAreNotCountedAsMatched) {
  const auto bus = make_test_bus(domain(), plain);
  Samples samples;
  const auto reader = bus->subscribe(text, samples);
  const auto writer = bus->advertise(text);
  ASSERT_EQ(writer->write(message(1)), Status::ok);
  EXPECT_EQ(health_of(*bus, "text", true).matched, 0);
  EXPECT_EQ(health_of(*bus, "text", false).matched, 0);
  EXPECT_EQ(health_of(*bus, "text", false).samples, 1U);
}

TEST_F(BusHealthTest, IncompatibleQosIsCountedAndNamedOnBothSides) {
  const int one = domain();
  const auto a = make_test_bus(one, "sensor: {reliability: best_effort}\n");
  const auto b = make_test_bus(one, plain);
  Samples samples;
  const auto writer = a->advertise(text);
  const auto reader = b->subscribe(text, samples);
  // Fast DDS may find an end twice: by its announcement, and when it makes its own.
  ASSERT_TRUE(eventually([&] {
    return health_of(*a, "text", true).incompatible_qos >= 1 &&
           health_of(*b, "text", false).incompatible_qos >= 1;
  }));
  EXPECT_EQ(health_of(*a, "text", true).incompatible_policy, "reliability");
  EXPECT_EQ(health_of(*b, "text", false).incompatible_policy, "reliability");
  EXPECT_EQ(health_of(*b, "text", false).matched, 0);
}

TEST_F(BusHealthTest, DifferentPartitionsDoNotMeet) {
  const int one = domain();
  const auto a = make_test_bus(one, "sensor: {partition: [left]}\n");
  const auto b = make_test_bus(one, "sensor: {partition: [right]}\n");
  const auto c = make_test_bus(one, "sensor: {partition: [le*]}\n");
  Samples right;
  Samples any;
  const auto right_reader = b->subscribe(text, right);
  const auto any_reader = c->subscribe(text, any);
  const auto writer = a->advertise(text);
  ASSERT_TRUE(eventually([&] { return health_of(*a, "text", true).matched == 1; }));
  ASSERT_EQ(writer->write(message(1)), Status::ok);
  ASSERT_TRUE(any.wait_for(1));
  EXPECT_EQ(right.all().size(), 0U);
  EXPECT_EQ(health_of(*a, "text", true).misfit, "");
}

TEST_F(BusHealthTest, ATypeOfTheSameNameWithAnotherLayoutIsRejectedAndCounted) {
  const int one = domain();
  TypeInfo vector = type_info<geometry_msgs::msg::Vector3>();
  vector.name = text.type->name;
  const auto a = make_test_bus(one, plain);
  const auto b = make_test_bus(one, plain);
  Samples samples;
  const auto reader = b->subscribe(text, samples);
  const auto writer = a->advertise({topic, &vector});
  ASSERT_TRUE(eventually([&] { return health_of(*a, "text", true).matched == 1; }));
  auto wrong = std::make_shared<geometry_msgs::msg::Vector3>();
  wrong->x(1e300);  // read as a text, this has a length that no message can hold
  wrong->y(-1);
  ASSERT_EQ(writer->write(wrong), Status::ok);
  ASSERT_TRUE(eventually([&] { return health_of(*b, "text", false).rejected == 1; }));
  EXPECT_EQ(samples.all().size(), 0U);
}

/// As a text: 5 bytes. As this: two numbers, and every text of at least 8 bytes decodes.
TypeInfo text_of_numbers() {
  TypeInfo numbers = type_info<builtin_interfaces::msg::Time>();
  numbers.name = text.type->name;
  return numbers;
}

TEST_F(BusHealthTest, ATypeOfTheSameNameWithAnotherLayoutIsNamedAtBothEnds) {
  const int one = domain();
  const TypeInfo numbers = text_of_numbers();
  const auto a = make_test_bus(one, plain);
  const auto b = make_test_bus(one, plain);
  Samples samples;
  const auto reader = b->subscribe({topic, &numbers}, samples);
  const auto writer = a->advertise(text);
  const std::string other = std::string(text.type->name) + " with another layout (test)";
  ASSERT_TRUE(eventually([&] { return health_of(*a, "text", true).other_type == other; }));
  ASSERT_TRUE(eventually([&] { return health_of(*b, "text", false).other_type == other; }));
}

TEST_F(BusHealthTest, BytesOfAnotherLayoutThatDecodeByChanceAreRejected) {
  const int one = domain();
  const TypeInfo numbers = text_of_numbers();
  const auto a = make_test_bus(one, plain);
  const auto b = make_test_bus(one, plain);
  Samples samples;
  const auto reader = b->subscribe({topic, &numbers}, samples);
  const auto writer = a->advertise(text);
  ASSERT_TRUE(eventually([&] { return health_of(*a, "text", true).matched == 1; }));
  ASSERT_EQ(writer->write(message(123456789)), Status::ok);
  ASSERT_TRUE(eventually([&] { return health_of(*b, "text", false).rejected == 1; }));
  EXPECT_EQ(samples.all().size(), 0U);
}

TEST_F(BusHealthTest, AnotherTypeUnderTheTopicsNameIsNamedAtBothEndsUntilItIsGone) {
  const int one = domain();
  const auto a = make_test_bus(one, plain);
  auto b = make_test_bus(one, plain);
  Samples samples;
  auto reader = b->subscribe({topic, &type_info<geometry_msgs::msg::Vector3>()}, samples);
  const auto writer = a->advertise(text);
  ASSERT_TRUE(eventually([&] {
    return health_of(*a, "text", true).other_type == "geometry_msgs::msg::dds_::Vector3_ (test)";
  }));
  ASSERT_TRUE(eventually([&] {
    return health_of(*b, "text", false).other_type == "std_msgs::msg::dds_::String_ (test)";
  }));
  reader.reset();
  b.reset();
  EXPECT_TRUE(eventually([&] { return health_of(*a, "text", true).other_type.empty(); }));
}

TEST_F(BusHealthTest, ALateReaderOfAStateGetsTheLastOfEachWriterByEitherWay) {
  const int one = domain();
  const char* const state = "sensor: {durability: transient_local}\n";
  const auto a = make_test_bus(one, state);
  const auto b = make_test_bus(one, state);
  const auto near_writer = a->advertise(text);
  const auto far_writer = b->advertise(text);
  ASSERT_EQ(near_writer->write(message(1)), Status::ok);
  ASSERT_EQ(far_writer->write(message(2)), Status::ok);
  Samples first;
  const auto reader = a->subscribe(text, first);
  ASSERT_TRUE(first.wait_for(2));
  EXPECT_THAT(texts(first.all()), ElementsAre("1", "2"));
  Samples late;
  const auto late_reader = a->subscribe(text, late);
  EXPECT_THAT(texts(late.all()), ::testing::UnorderedElementsAre("1", "2"));
}

TEST_F(BusHealthTest, TheRateOfAWriterIsLimitedForAllReaders) {
  const auto bus = make_test_bus(domain(), "sensor: {max_rate_hz: 0.01}\n");
  Samples samples;
  const auto reader = bus->subscribe(text, samples);
  const auto writer = bus->advertise(text);
  for (int i = 0; i < 10; ++i) ASSERT_EQ(writer->write(message(i)), Status::ok);
  EXPECT_THAT(texts(samples.all()), ElementsAre("0", "1"));
  EXPECT_EQ(health_of(*bus, "text", true).thinned, 8U);
}

TEST_F(BusHealthTest, AMissedDeadlineIsCountedAtBothEnds) {
  const auto bus = make_test_bus(domain(), "sensor: {deadline_s: 0.01}\n");
  Samples samples;
  const auto reader = bus->subscribe(text, samples);
  const auto writer = bus->advertise(text);
  ASSERT_EQ(writer->write(message(1)), Status::ok);
  ASSERT_TRUE(eventually([&] { return health_of(*bus, "text", true).deadlines_missed > 1; }));
  EXPECT_GT(health_of(*bus, "text", false).deadlines_missed, 1U);
}

TEST_F(BusHealthTest, TheStrongestOwnerIsHeardAlone) {
  const int one = domain();
  const std::string exclusive = "sensor: {ownership: exclusive, ownership_strength: ";
  const auto strong = make_test_bus(one, exclusive + "5}\n");
  const auto weak = make_test_bus(one, exclusive + "1}\n");
  Samples samples;
  const auto reader = weak->subscribe(text, samples);
  const auto strong_writer = strong->advertise(text);
  const auto weak_writer = weak->advertise(text);
  ASSERT_TRUE(eventually([&] { return health_of(*strong, "text", true).matched == 1; }));
  ASSERT_EQ(strong_writer->write(message(1)), Status::ok);
  ASSERT_TRUE(samples.wait_for(1));
  ASSERT_EQ(weak_writer->write(message(2)), Status::ok);
  ASSERT_EQ(strong_writer->write(message(3)), Status::ok);
  ASSERT_TRUE(samples.wait_for(2));
  EXPECT_THAT(texts(samples.all()), ElementsAre("1", "3"));
}

TEST_F(BusHealthTest, OwnersOfALinkTopicAreAConfigError) {
  const auto bus = make_test_bus(domain(), "sensor: {ownership: exclusive}\n");
  Samples samples;
  Endpoint crossing = text;
  crossing.topic.scope = Scope::link;
  EXPECT_THROW((void)bus->subscribe(crossing, samples), ConfigError);
}

TEST_F(BusHealthTest, AnAsynchronousWriterDelivers) {
  const int one = domain();
  const char* const qos = "sensor: {publish_mode: asynchronous, depth: 50}\n";
  const auto a = make_test_bus(one, qos);
  const auto b = make_test_bus(one, qos);
  Samples samples;
  const auto reader = b->subscribe(text, samples);
  const auto writer = a->advertise(text);
  ASSERT_TRUE(eventually([&] { return health_of(*a, "text", true).matched == 1; }));
  for (int i = 0; i < 40; ++i) ASSERT_EQ(writer->write(message(i)), Status::ok);
  EXPECT_TRUE(samples.wait_for(40));
}

}  // namespace
}  // namespace tocsin
