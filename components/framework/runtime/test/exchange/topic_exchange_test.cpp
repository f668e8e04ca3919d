// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/topic_exchange.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>
#include <utility>
#include <vector>

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const Time t0{std::chrono::hours(1)};

/// Notes the sequence numbers it gets.
class Notes : public Receiver {
 public:
  void receive(const Sample& sample) override { sequences.push_back(sample.sequence); }
  std::vector<std::uint64_t> sequences;
};

Sample sample(std::uint64_t source, std::uint64_t sequence, Time received = t0) {
  Sample one;
  one.message = std::make_shared<const int>(0);
  one.source = source;
  one.sequence = sequence;
  one.received = received;
  return one;
}

/// Moves from the sample when it may.
class Owner : public Receiver {
 public:
  void receive(const Sample& sample) override { message = sample.message; }
  void receive_last(Sample&& sample) override { message = std::move(sample.message); }
  std::shared_ptr<const void> message;
};

QosProfile keeping(int depth) {
  QosProfile qos;
  qos.durability = Durability::transient_local;
  qos.depth = depth;
  return qos;
}

TEST(TopicExchange, DeliversInOrderToEveryReceiverUntilItDetaches) {
  TopicExchange sut{QosProfile{}};
  Notes a;
  Notes b;
  sut.attach(a);
  sut.attach(b);
  sut.deliver(sample(1, 1));
  sut.detach(b);
  sut.deliver(sample(1, 2));
  EXPECT_THAT(a.sequences, ElementsAre(1, 2));
  EXPECT_THAT(b.sequences, ElementsAre(1));
}

TEST(TopicExchange, EveryReceiverGetsTheMessageAndNobodyElseHoldsIt) {
  TopicExchange sut{QosProfile{}};
  Owner a;
  Owner b;
  Owner c;
  for (Owner* one : {&a, &b, &c}) sut.attach(*one);
  sut.deliver(sample(1, 1));
  ASSERT_NE(a.message, nullptr);
  EXPECT_EQ(b.message, a.message);
  EXPECT_EQ(c.message, a.message);
  EXPECT_EQ(a.message.use_count(), 3);
}

TEST(TopicExchange, AReceiverThatMovesFromTheSampleLeavesTheKeptOneWhole) {
  TopicExchange sut{keeping(1)};
  Owner first;
  sut.attach(first);
  sut.deliver(sample(1, 1));
  Owner late;
  sut.attach(late);
  EXPECT_NE(late.message, nullptr);
  EXPECT_EQ(late.message, first.message);
}

TEST(TopicExchange, AnOwnWriterOfTwoThreadsDeliversItsNumbersInOrder) {
  constexpr std::uint64_t each = 20000;
  TopicExchange sut{QosProfile{}};
  Notes notes;
  sut.attach(notes);
  std::uint64_t delivered = 0;
  const auto write = [&] {
    for (std::uint64_t i = 0; i < each; ++i) sut.deliver(sample(1, 0), delivered);
  };
  std::thread other(write);
  write();
  other.join();
  ASSERT_EQ(notes.sequences.size(), 2 * each);
  for (std::uint64_t i = 0; i < 2 * each; ++i) ASSERT_EQ(notes.sequences[i], i + 1);
}

TEST(TopicExchange, AVolatileTopicKeepsNothingForLateReceivers) {
  TopicExchange sut{QosProfile{}};
  sut.deliver(sample(1, 1));
  Notes late;
  sut.attach(late);
  EXPECT_THAT(late.sequences, IsEmpty());
}

TEST(TopicExchange, ALateReceiverGetsTheLastSamplesOfEachWriterUpToTheDepth) {
  TopicExchange sut(keeping(2));
  for (std::uint64_t i = 1; i <= 3; ++i) sut.deliver(sample(1, i));
  sut.deliver(sample(2, 10));
  Notes late;
  sut.attach(late);
  EXPECT_THAT(late.sequences, ElementsAre(2, 3, 10));
}

TEST(TopicExchange, WhatAGoneWriterWroteIsNotKept) {
  TopicExchange sut(keeping(1));
  sut.deliver(sample(1, 1));
  sut.deliver(sample(2, 2));
  sut.forget(1);
  Notes late;
  sut.attach(late);
  EXPECT_THAT(late.sequences, ElementsAre(2));
}

TEST(TopicExchange, ALateReceiverGetsNothingOlderThanTheLifespan) {
  QosProfile qos = keeping(2);
  qos.lifespan_s = 1;
  TopicExchange sut(qos);
  sut.deliver(sample(1, 1, t0));
  sut.deliver(sample(1, 2, t0 + Duration{1}));
  Notes late;
  sut.attach(late, t0 + Duration{1} + seconds(1));
  EXPECT_THAT(late.sequences, ElementsAre(2));
}

TEST(TopicExchange, SeparationAndDeadlineCountWhereverASampleCameFrom) {
  QosProfile qos;
  qos.minimum_separation_s = 0.1;
  qos.deadline_s = 0.5;
  TopicExchange sut(qos);
  Notes notes;
  sut.attach(notes);
  sut.deliver(sample(1, 1, t0));
  sut.deliver(sample(1, 2, t0 + seconds(0.05)));
  sut.deliver(sample(1, 3, t0 + seconds(0.1)));
  EXPECT_THAT(notes.sequences, ElementsAre(1, 3));
  const auto account = sut.account(t0 + seconds(0.1) + seconds(1.1));
  EXPECT_EQ(account.samples, 2U);
  EXPECT_EQ(account.thinned, 1U);
  EXPECT_EQ(account.deadlines_missed, 2U);
  EXPECT_EQ(account.last, t0 + seconds(0.1));
}

TEST(TopicExchange, TellsWhetherSomebodyReceives) {
  TopicExchange sut{QosProfile{}};
  EXPECT_FALSE(sut.has_receivers());
  Notes receiver;
  sut.attach(receiver);
  EXPECT_TRUE(sut.has_receivers());
  sut.detach(receiver);
  EXPECT_FALSE(sut.has_receivers());
}

TEST(TopicExchange, AChangedSeparationLifespanAndDeadlineHoldFromThenOn) {
  TopicExchange sut(keeping(1));
  Notes early;
  sut.attach(early);
  sut.deliver(sample(1, 1));
  QosProfile strict = keeping(1);
  strict.lifespan_s = 1;
  strict.deadline_s = 0.1;
  sut.change(strict, t0);
  EXPECT_EQ(sut.account(t0 + seconds(1)).deadlines_missed, 9U);
  Notes late;
  sut.attach(late, t0 + seconds(1.1));
  EXPECT_THAT(late.sequences, IsEmpty());
  strict.minimum_separation_s = 0.05;
  sut.change(strict, t0 + seconds(1));
  sut.deliver(sample(1, 2, t0 + seconds(2)));
  sut.deliver(sample(1, 3, t0 + seconds(2.01)));
  EXPECT_THAT(early.sequences, ElementsAre(1, 2));
}

/// Notes samples as instance and number, ends as instance and state.
class InstanceNotes : public Receiver {
 public:
  void receive(const Sample& sample) override {
    seen.push_back(std::to_string(sample.instance) + "." + std::to_string(sample.sequence));
  }
  void instance_ended(const Sample& sample) override {
    seen.push_back(std::to_string(sample.instance) +
                   (sample.state == InstanceState::disposed ? " disposed" : " no writers"));
  }
  std::vector<std::string> seen;
};

Sample of_instance(std::uint64_t instance, Sample one) {
  one.instance = instance;
  return one;
}

Sample end_of(std::uint64_t instance, std::uint64_t source, InstanceState state) {
  Sample end = of_instance(instance, sample(source, 0));
  end.message = nullptr;
  end.state = state;
  return end;
}

TEST(TopicExchange, KeepsTheLastOfEachInstance) {
  TopicExchange sut(keeping(1));
  sut.deliver(of_instance(7, sample(1, 1)));
  sut.deliver(of_instance(8, sample(1, 2)));
  sut.deliver(of_instance(7, sample(1, 3)));
  InstanceNotes late;
  sut.attach(late);
  EXPECT_THAT(late.seen, ElementsAre("7.3", "8.2"));
}

TEST(TopicExchange, ADisposedInstanceIsToldAndNotKept) {
  TopicExchange sut(keeping(1));
  InstanceNotes early;
  sut.attach(early);
  sut.deliver(of_instance(7, sample(1, 1)));
  sut.end_instance(end_of(7, 2, InstanceState::disposed));
  sut.end_instance(end_of(7, 2, InstanceState::disposed));
  EXPECT_THAT(early.seen, ElementsAre("7.1", "7 disposed"));
  InstanceNotes late;
  sut.attach(late);
  EXPECT_THAT(late.seen, IsEmpty());
}

TEST(TopicExchange, AnInstanceHasNoWritersWhenTheLastHasUnregisteredItOrIsGone) {
  TopicExchange sut(QosProfile{});
  InstanceNotes notes;
  sut.attach(notes);
  sut.deliver(of_instance(7, sample(1, 1)));
  sut.deliver(of_instance(7, sample(2, 1)));
  sut.deliver(of_instance(8, sample(2, 2)));
  sut.end_instance(end_of(7, 1, InstanceState::no_writers));
  EXPECT_EQ(notes.seen.size(), 3U) << "source 2 still writes it";
  sut.forget(2);
  EXPECT_EQ(notes.seen.size(), 5U);
  EXPECT_EQ(notes.seen[3], "7 no writers");
  EXPECT_EQ(notes.seen[4], "8 no writers");
}

TEST(TopicExchange, MinimumSeparationHoldsForEachInstanceApart) {
  QosProfile qos;
  qos.minimum_separation_s = 1;
  TopicExchange sut(qos);
  InstanceNotes notes;
  sut.attach(notes);
  sut.deliver(of_instance(7, sample(1, 1)));
  sut.deliver(of_instance(8, sample(1, 2)));
  sut.deliver(of_instance(7, sample(1, 3)));
  EXPECT_THAT(notes.seen, ElementsAre("7.1", "8.2"));
}

}  // namespace
}  // namespace tocsin
