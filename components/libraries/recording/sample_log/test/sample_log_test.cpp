// SPDX-License-Identifier: Apache-2.0
#include "sample_log/sample_log.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>

#include "mcap/reader.hpp"
#include "mcap/writer.hpp"

namespace tocsin::sample_log {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr Time t0{std::chrono::hours(1)};
constexpr std::int64_t wall0 = 1'700'000'000'000'000'000;
constexpr Duration s = std::chrono::seconds(1);

LoggedStream battery() {
  return {"battery|layout",
          "/battery_state",
          {0, "sensor_msgs/msg/BatteryState", "ros2msg", "f32"},
          {{"wire_type", "battery"}}};
}

class SampleLogTest : public ::testing::Test {
 protected:
  SampleLogTest() { start(); }
  void start() {
    sut_.emplace(files_, limits_, Instant{now_, wall0 + (now_ - t0).count()});
    sut_->add(battery());
  }
  /// The process is killed: nothing is closed.
  void kill_and_restart() {
    std::map<std::string, MemoryFiles::Bytes> left;
    for (const std::string& name : files_.names()) left[name] = files_.bytes_of(name);
    sut_.reset();
    for (const std::string& name : files_.names()) files_.remove(name);
    for (const auto& [name, bytes] : left) {
      (void)files_.make(name);
      files_.bytes_of(name) = bytes;
    }
    start();
  }
  [[nodiscard]] static SampleId id(std::uint64_t sequence, std::uint64_t source = 7) {
    return {stream_key("battery|layout"), source, sequence};
  }
  Logged append(const SampleId& which, std::size_t bytes = 4) {
    const std::vector<std::uint8_t> content(bytes, static_cast<std::uint8_t>(which.sequence));
    return sut_->append({{which, 1000 + static_cast<std::int64_t>(which.sequence), content}},
                        {now_, wall0 + (now_ - t0).count()})[0];
  }
  MemoryFiles files_;
  LogLimits limits_;
  Time now_ = t0;
  std::optional<SampleLog> sut_;
};

TEST_F(SampleLogTest, OutlivesAKill) {
  for (std::uint64_t i = 1; i <= 5; ++i) append(id(i));
  sut_->confirm({id(2), id(3)});
  kill_and_restart();
  EXPECT_THAT(sut_->waiting(), ElementsAre(id(1), id(4), id(5)));
  EXPECT_EQ(sut_->read({id(4)}).at(0).bytes, std::vector<std::uint8_t>(4, 4));
  EXPECT_THAT(sut_->take_problems(), IsEmpty());
  EXPECT_EQ(sut_->streams().at(stream_key("battery|layout")).facts.at("wire_type"), "battery");
}

TEST_F(SampleLogTest, KnowsASampleThatComesAgain) {
  append(id(1));
  append(id(2));
  EXPECT_EQ(append(id(1)), Logged::waiting);
  sut_->confirm({id(1)});
  kill_and_restart();
  EXPECT_EQ(append(id(1)), Logged::confirmed) << "confirmed by an earlier life";
  EXPECT_EQ(append(id(2)), Logged::waiting) << "in the log of an earlier life";
  EXPECT_THAT(sut_->waiting(), ElementsAre(id(2)));
}

TEST_F(SampleLogTest, KeepsTheOrderThoughTheClockIsSetBack) {
  (void)sut_->append({{id(1), 0, {1}}}, {now_, wall0});
  (void)sut_->append({{id(2), 0, {1}}}, {now_, wall0 - 1'000'000'000});
  kill_and_restart();
  (void)sut_->append({{id(3), 0, {1}}}, {now_, wall0 - 2'000'000'000});
  EXPECT_THAT(sut_->waiting(), ElementsAre(id(1), id(2), id(3)));
  EXPECT_EQ(sut_->read({id(1), id(2), id(3)}).size(), 3U);
}

TEST_F(SampleLogTest, TheOldestGoesBeyondTheBytes) {
  limits_.bytes = 64'000;
  start();
  std::vector<SampleId> retired;
  for (std::uint64_t i = 1; i <= 200; ++i) {
    EXPECT_EQ(append(id(i), 1000), Logged::kept);
    const auto gone = sut_->retire(now_);
    retired.insert(retired.end(), gone.begin(), gone.end());
    EXPECT_LE(sut_->bytes(), limits_.bytes);
  }
  ASSERT_FALSE(retired.empty());
  EXPECT_EQ(retired.front(), id(1));
  EXPECT_EQ(retired.size() + sut_->waiting().size(), 200U) << "all lost ones are told";
  EXPECT_GT(sut_->waiting().size(), 35U) << "most of the bytes are used";
  EXPECT_LE(files_.size(), limits_.bytes + 4000);
  EXPECT_TRUE(sut_->read({id(1)}).empty());
}

TEST_F(SampleLogTest, TheOldestGoesWithItsAge) {
  limits_.age = 100 * s;
  start();
  append(id(1));
  sut_->confirm({id(1)});
  append(id(2));
  now_ += 100 * s;
  EXPECT_THAT(sut_->retire(now_), IsEmpty());
  now_ += Duration{1};
  EXPECT_THAT(sut_->retire(now_), ElementsAre(id(2))) << "what was confirmed is not lost";
  EXPECT_EQ(sut_->bytes(), 0U);
  EXPECT_EQ(append(id(3)), Logged::kept);
}

TEST_F(SampleLogTest, AgesGoOnOverAKill) {
  limits_.age = 100 * s;
  append(id(1));
  now_ += 60 * s;
  kill_and_restart();
  now_ += 40 * s;
  EXPECT_THAT(sut_->retire(now_), IsEmpty());
  now_ += s;
  EXPECT_THAT(sut_->retire(now_), ElementsAre(id(1)));
}

TEST_F(SampleLogTest, AClockThatIsSetTakesNothingAway) {
  append(id(1));
  constexpr std::int64_t years = 60'000'000'000'000'000;
  (void)sut_->append({{id(2), 0, {1}}}, {now_, wall0 + years});
  EXPECT_THAT(sut_->retire(now_), IsEmpty());
}

TEST_F(SampleLogTest, AFullDiskIsSaidOnceAndTriedAgain) {
  append(id(1));
  (void)sut_->take_problems();
  files_.room = files_.size();
  EXPECT_EQ(append(id(2)), Logged::refused);
  EXPECT_EQ(append(id(3)), Logged::refused);
  EXPECT_THAT(sut_->take_problems(), ElementsAre(HasSubstr("no room")));
  files_.room += 10'000;
  EXPECT_EQ(append(id(4)), Logged::kept);
  EXPECT_THAT(sut_->take_problems(), ElementsAre(HasSubstr("can be stored again")));
  EXPECT_THAT(sut_->waiting(), ElementsAre(id(1), id(4)));
}

TEST_F(SampleLogTest, AFolderThatCannotBeWrittenIsSaidOnce) {
  files_.refuses_files = true;
  EXPECT_EQ(append(id(1)), Logged::refused);
  EXPECT_EQ(append(id(2)), Logged::refused);
  EXPECT_THAT(sut_->take_problems(),
              ElementsAre(HasSubstr("segment.00000001.mcap"), HasSubstr("no room")));
}

TEST_F(SampleLogTest, ADamagedSegmentTakesNoOtherWithIt) {
  append(id(1));
  kill_and_restart();
  append(id(2));
  files_.bytes_of("segment.00000001.mcap").assign(50, 0x5a);
  kill_and_restart();
  EXPECT_THAT(sut_->waiting(), ElementsAre(id(2)));
  EXPECT_THAT(sut_->take_problems(), ElementsAre(HasSubstr("segment.00000001.mcap")));
}

TEST_F(SampleLogTest, ADamagedChunkIsLeftOutAndSaid) {
  append(id(1), 100);
  append(id(2), 100);
  append(id(3), 100);
  auto& bytes = files_.bytes_of("segment.00000001.mcap");
  const std::vector<std::uint8_t> second(50, 2);
  const auto place = std::search(bytes.begin(), bytes.end(), second.begin(), second.end());
  ASSERT_NE(place, bytes.end());
  *place ^= 1;
  kill_and_restart();
  EXPECT_THAT(sut_->waiting(), ElementsAre(id(1), id(3)));
  EXPECT_THAT(sut_->take_problems(), ElementsAre(HasSubstr("1 chunks are damaged")));
}

TEST_F(SampleLogTest, ItsSegmentsAreMcapFilesWithTopicAndSchema) {
  append(id(1));
  sut_.reset();
  mcap::Reader reader(files_.open("segment.00000001.mcap"), "segment");
  ASSERT_EQ(reader.summary().channels.size(), 1U);
  EXPECT_EQ(reader.summary().channels.begin()->second.topic, "/battery_state");
  EXPECT_EQ(reader.summary().schemas.begin()->second.name, "sensor_msgs/msg/BatteryState");
  EXPECT_FALSE(reader.damage().no_summary) << "it was closed";
}

TEST_F(SampleLogTest, AFileOfAnotherToolIsLeftAlone) {
  const auto foreign = files_.make("segment.00000007.mcap");
  {
    const auto sink = files_.make("notes.txt");
    mcap::Writer writer(*foreign, {});
    const auto channel = writer.declare(mcap::Channel{0, 0, "/other", "json", {}});
    (void)writer.write(mcap::Message{*channel, 1, 1, 1, nullptr, 0});
  }
  kill_and_restart();
  EXPECT_THAT(sut_->waiting(), IsEmpty());
  EXPECT_EQ(append(id(1)), Logged::kept) << "behind it";
  EXPECT_THAT(files_.names(), ::testing::Contains("segment.00000008.mcap"));
  EXPECT_THAT(files_.names(), ::testing::Contains("notes.txt"));
}

/// Whatever is cut off the files of a killed process, what is left of the log is in its order and
/// holds what was written.
TEST_F(SampleLogTest, CutAnywhereItGivesABeginningOfWhatWasAppended) {
  for (std::uint64_t i = 1; i <= 6; ++i) append(id(i), 20);
  const auto whole = files_.bytes_of("segment.00000001.mcap");
  for (std::size_t size = 0; size <= whole.size(); size += 7) {
    MemoryFiles cut;
    (void)cut.make("segment.00000001.mcap");
    cut.bytes_of("segment.00000001.mcap")
        .assign(whole.begin(), whole.begin() + static_cast<long>(size));
    SampleLog log(cut, limits_, {now_, wall0});
    const auto waiting = log.waiting();
    for (std::size_t i = 0; i < waiting.size(); ++i) EXPECT_EQ(waiting[i], id(i + 1));
    EXPECT_EQ(log.read(waiting).size(), waiting.size());
  }
}

TEST_F(SampleLogTest, AtRandomItLosesNothingButByItsBounds) {
  std::mt19937 random(3);
  limits_.bytes = 200'000;
  start();
  std::set<SampleId> expected;
  std::uint64_t sequence = 0;
  for (int step = 0; step < 2000; ++step) {
    if (random() % 100 == 0) kill_and_restart();
    const SampleId next = id(++sequence, random() % 3);
    ASSERT_EQ(append(next, random() % 500), Logged::kept);
    expected.insert(next);
    if (random() % 3 == 0 && !expected.empty()) {
      const SampleId done =
          *std::next(expected.begin(), static_cast<long>(random() % expected.size()));
      sut_->confirm({done});
      expected.erase(done);
    }
    for (const SampleId& gone : sut_->retire(now_)) EXPECT_EQ(expected.erase(gone), 1U);
    if (step % 100 != 0) continue;
    const auto waiting = sut_->waiting();
    EXPECT_EQ(std::set<SampleId>(waiting.begin(), waiting.end()), expected);
    EXPECT_EQ(sut_->read(waiting).size(), waiting.size());
  }
  EXPECT_THAT(sut_->take_problems(), IsEmpty());
}

}  // namespace
}  // namespace tocsin::sample_log
