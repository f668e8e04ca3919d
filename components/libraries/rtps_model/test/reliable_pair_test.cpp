// SPDX-License-Identifier: Apache-2.0
// A writer and its readers over a way that loses messages at random, with many seeds.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <queue>
#include <random>

#include "rtps_model/reliable_reader.hpp"
#include "rtps_model/reliable_writer.hpp"
#include "sent_messages.hpp"

namespace tocsin::rtps {
namespace {

using Sequences = std::vector<Sequence>;

struct Settings {
  WriterSettings writer;
  ReaderSettings reader;
};

Settings keep_last(std::size_t depth) {
  Settings settings;
  settings.writer.room = depth;
  settings.reader.depth = depth;
  settings.reader.room = depth + 1;
  return settings;
}

Settings keep_all(std::size_t room) {
  Settings settings = keep_last(room);
  settings.writer.keep_all = settings.reader.keep_all = true;
  settings.reader.room = room;
  return settings;
}

/// A writer, two readers, 10 ms each way, a share of all messages lost.
class Pair {
 public:
  Pair(const Settings& settings, double loss, std::uint64_t seed)
      : loss_(loss), random_(seed), writer_(settings.writer, to_readers_) {
    for (EndId id = 1; id <= 2; ++id) {
      readers_.push_back(std::make_unique<End>(*this, id, settings.reader));
    }
    for (auto& end : readers_) {
      end->model.match(0, now_);
      writer_.match(end->id, now_);
    }
  }
  /// False when there is no room.
  bool write(std::size_t bytes) {
    if (!writer_.has_room(now_)) return false;
    writer_.write(nullptr, bytes, now_);
    return true;
  }
  void run_for(double s) {
    const Time end = now_ + seconds(s);
    for (Time next = next_event(); next <= end; next = next_event()) step(next);
    now_ = end;
  }
  void set_loss(double loss) { loss_ = loss; }
  [[nodiscard]] const Sequences& got(std::size_t reader) const { return readers_[reader]->got; }
  [[nodiscard]] std::size_t messages() const { return messages_; }

 private:
  struct UnderWay {
    Time at;
    std::size_t number;
    bool to_writer;
    EndId reader;
    MessagePtr message;
    bool operator<(const UnderWay& other) const {
      return at != other.at ? at > other.at : number > other.number;
    }
  };
  struct ToReaders final : Sender {
    explicit ToReaders(Pair& its) : pair(its) {}
    void send(EndId to, const MessagePtr& message) override { pair.post(false, to, message); }
    Pair& pair;
  };
  struct End final : Sender {
    End(Pair& its, EndId number, const ReaderSettings& settings)
        : pair(its), id(number), model(settings, *this, [this](EndId, const SamplePtr& sample) {
            got.push_back(sample->sequence);
          }) {}
    void send(EndId, const MessagePtr& message) override { pair.post(true, id, message); }
    Pair& pair;
    EndId id;
    ReliableReader model;
    Sequences got;
  };

  void post(bool to_writer, EndId reader, const MessagePtr& message) {
    ++messages_;
    if (std::uniform_real_distribution<>()(random_) < loss_) return;
    under_way_.push({now_ + seconds(0.01), messages_, to_writer, reader, message});
  }
  [[nodiscard]] Time next_event() const {
    Time next = writer_.next_event();
    for (const auto& end : readers_) next = std::min(next, end->model.next_event());
    return under_way_.empty() ? next : std::min(next, under_way_.top().at);
  }
  void step(Time now) {
    now_ = std::max(now_, now);
    while (!under_way_.empty() && under_way_.top().at <= now_) {
      const UnderWay one = under_way_.top();
      under_way_.pop();
      if (one.to_writer) {
        writer_.on_message(one.reader, *one.message, now_);
      } else {
        readers_[one.reader - 1]->model.on_message(0, *one.message, now_);
      }
    }
    if (writer_.next_event() <= now_) writer_.on_time(now_);
    for (auto& end : readers_) {
      if (end->model.next_event() <= now_) end->model.on_time(now_);
    }
  }

  double loss_;
  std::mt19937_64 random_;
  Time now_ = t0;
  std::size_t messages_ = 0;
  std::priority_queue<UnderWay> under_way_;
  ToReaders to_readers_{*this};
  ReliableWriter writer_;
  std::vector<std::unique_ptr<End>> readers_;
};

Sequences up_to(Sequence last) {
  Sequences all(last);
  std::iota(all.begin(), all.end(), Sequence{1});
  return all;
}

constexpr std::uint64_t seeds = 40;

TEST(ReliablePair, WithoutLossADepthOneSampleCostsOneMessageAndOneAnswerPerReader) {
  Pair sut(keep_last(1), 0, 1);
  sut.run_for(1);
  const std::size_t greetings = sut.messages();
  sut.write(100);
  sut.run_for(10);
  EXPECT_EQ(sut.messages(), greetings + 4);
  EXPECT_EQ(sut.got(0), Sequences{1});
  EXPECT_EQ(sut.got(1), Sequences{1});
}

TEST(ReliablePair, ADeepHistoryComesCompleteAndInOrder) {
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    Pair sut(keep_last(100), 0.3, seed);
    for (int i = 0; i < 100; ++i) {
      sut.write(100);
      sut.run_for(0.05);
    }
    sut.run_for(30);
    for (const std::size_t reader : {0, 1}) EXPECT_EQ(sut.got(reader), up_to(100)) << seed;
  }
}

TEST(ReliablePair, KeepAllComesCompleteAndInOrder) {
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    Pair sut(keep_all(10), 0.3, seed);
    Sequence written = 0;
    for (int i = 0; i < 400; ++i) {
      written += sut.write(100);
      sut.run_for(0.05);
    }
    sut.run_for(30);
    EXPECT_GT(written, 100U) << seed;
    for (const std::size_t reader : {0, 1}) EXPECT_EQ(sut.got(reader), up_to(written)) << seed;
  }
}

TEST(ReliablePair, KeepLastOneEndsWithTheNewest) {
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    Pair sut(keep_last(1), 0.3, seed);
    for (int i = 0; i < 50; ++i) {
      sut.write(100);
      sut.run_for(0.02);
    }
    sut.run_for(30);
    for (const std::size_t reader : {0, 1}) {
      EXPECT_EQ(sut.got(reader).back(), 50U) << seed;
      EXPECT_TRUE(std::is_sorted(sut.got(reader).begin(), sut.got(reader).end())) << seed;
    }
  }
}

/// Messages until a sample of 33 fragments has come to both readers.
std::size_t cost_of_a_large_sample(bool piggyback, double loss, std::uint64_t seed) {
  Settings settings = keep_last(1);
  settings.writer.heartbeat_piggyback = piggyback;
  Pair sut(settings, loss, seed);
  sut.write(40'000);
  sut.run_for(60);
  for (const std::size_t reader : {0, 1}) EXPECT_EQ(sut.got(reader), Sequences{1}) << seed;
  return sut.messages();
}

TEST(ReliablePair, ALargeSampleComesWholePieceByPiece) {
  // Sent whole it would come with a probability of 0.7^33, once in 130,000 times.
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    EXPECT_LT(cost_of_a_large_sample(false, 0.3, seed), 250U) << seed;
  }
}

TEST(ReliablePair, AHeartbeatOnEachPieceAsksForAllThatAreStillUnderWay) {
  // Nothing is lost, and yet what each heartbeat brings back is sent again: 66 would do.
  EXPECT_GT(cost_of_a_large_sample(true, 0, 1), 2000U);
  EXPECT_LT(cost_of_a_large_sample(false, 0, 1), 80U);
}

TEST(ReliablePair, IsSilentWhenEverythingIsAcknowledged) {
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    Pair sut(keep_last(3), 0.3, seed);
    for (int i = 0; i < 10; ++i) sut.write(2000);
    sut.run_for(60);
    const std::size_t before = sut.messages();
    sut.run_for(60);
    EXPECT_EQ(sut.messages(), before) << seed;
  }
}

TEST(ReliablePair, ComesBackAfterADeadLink) {
  Pair sut(keep_last(2), 0, 1);
  sut.run_for(1);
  sut.set_loss(1);
  for (int i = 0; i < 10; ++i) {
    sut.write(100);
    sut.run_for(1);
  }
  sut.set_loss(0);
  sut.run_for(0.3);
  EXPECT_EQ(sut.got(0), (Sequences{9, 10}));
}

}  // namespace
}  // namespace tocsin::rtps
