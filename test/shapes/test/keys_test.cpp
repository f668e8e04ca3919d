// SPDX-License-Identifier: Apache-2.0
// Instances over real DDS: what two processes hear of each other's. Each test has a domain of its
// own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <thread>

#include "runtime/host_control.hpp"
#include "runtime/port.hpp"
#include "shape_bus.hpp"

namespace tocsin::shapes {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;

template <class Condition>
bool eventually(const Condition& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(8);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

/// Notes colours and sizes, and the ends of instances by the colour that they had.
class Notes : public Receiver {
 public:
  void receive(const Sample& sample) override {
    const Shape shape = shape_of(*static_cast<const ShapeType*>(sample.message.get()));
    const std::lock_guard<std::mutex> lock(mutex_);
    colors_[sample.instance] = shape.color;
    seen_.push_back(shape.color + std::to_string(shape.size));
  }
  void instance_ended(const Sample& sample) override {
    if (on_end) on_end(sample);
    const std::lock_guard<std::mutex> lock(mutex_);
    seen_.push_back(colors_[sample.instance] +
                    (sample.state == InstanceState::disposed ? " disposed" : " no writers"));
  }
  [[nodiscard]] std::vector<std::string> seen() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return seen_;
  }
  /// Set before a reader is there.
  std::function<void(const Sample&)> on_end;

 private:
  std::mutex mutex_;
  std::map<std::uint64_t, std::string> colors_;
  std::vector<std::string> seen_;
};

std::shared_ptr<const void> shape(const std::string& color, int size) {
  Shape one;
  one.color = color;
  one.size = size;
  return std::make_shared<const ShapeType>(message_of(one));
}

class Keys : public ::testing::Test {
 protected:
  static ShapeOptions options() {
    static int next = 200;
    ShapeOptions options;
    options.domain = ++next;
    options.qos.history = History::keep_all;
    return options;
  }
  static bool is_matched(Bus& bus) {
    const auto health = bus.host_control().health();
    return std::any_of(health.begin(), health.end(),
                       [](const EndpointHealth& one) { return one.matched > 0; });
  }
};

const Endpoint square = shape_endpoint("Square");

TEST_F(Keys, AWriterThatIsGoneLeavesItsInstancesWithoutWriters) {
  const ShapeOptions both = options();
  auto a = make_shape_bus(both);
  const auto b = make_shape_bus(both);
  Notes notes;
  auto writer = a->advertise(square);
  std::unique_ptr<Subscription> reader;
  std::atomic<bool> knows_writer{false};
  notes.on_end = [&](const Sample& sample) {
    knows_writer = reader->writer(sample.source).has_value();
  };
  reader = b->subscribe(square, notes);
  ASSERT_TRUE(eventually([&] { return is_matched(*a) && is_matched(*b); }));
  EXPECT_EQ(writer->write(shape("RED", 1)), Status::ok);
  ASSERT_TRUE(eventually([&] { return notes.seen().size() == 1; }));
  writer.reset();
  EXPECT_TRUE(eventually([&] { return notes.seen().size() == 2; }));
  EXPECT_THAT(notes.seen(), ElementsAre("RED1", "RED no writers"));
  EXPECT_TRUE(knows_writer);
}

TEST_F(Keys, ALateReaderGetsTheLastOfEachInstanceOnceFromEitherSide) {
  ShapeOptions state = options();
  state.qos = {};
  state.qos.durability = Durability::transient_local;
  const auto a = make_shape_bus(state);
  const auto b = make_shape_bus(state);
  const auto writer = a->advertise(square);
  for (const int size : {1, 2}) {
    for (int i = 0; i < 20; ++i) {
      EXPECT_EQ(writer->write(shape("C" + std::to_string(i) + "_", size)), Status::ok);
    }
  }
  Notes far;
  Notes near;
  const auto reader = b->subscribe(square, far);
  const auto reader_beside = a->subscribe(square, near);
  EXPECT_TRUE(eventually([&] { return far.seen().size() == 20; }));
  EXPECT_THAT(far.seen(), Contains("C19_2"));
  EXPECT_THAT(far.seen(), Not(Contains("C19_1")));
  EXPECT_EQ(near.seen().size(), 20U);
}

TEST_F(Keys, AnInstanceThatWasNeverWrittenCannotEnd) {
  const auto bus = make_shape_bus(options());
  const auto writer = bus->advertise(square);
  EXPECT_EQ(writer->write(shape("RED", 1)), Status::ok);
  Notes notes;
  const auto reader = bus->subscribe(square, notes);
  (void)writer->end_instance(shape("BLUE", 0), InstanceState::disposed);
  EXPECT_THAT(notes.seen(), IsEmpty());
}

}  // namespace
}  // namespace tocsin::shapes
