// SPDX-License-Identifier: Apache-2.0
#include "backfill/router_store.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "devices/computer.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

using sample_log::Logged;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr Time t0{std::chrono::hours(1)};

/// A disk that does nothing until it is told to.
struct SlowDisk {
  class Waiting final : public Background {
   public:
    explicit Waiting(SlowDisk& disk) : disk_(disk) {}
    void post(std::function<void()> work) override { disk_.posted.push_back(std::move(work)); }
    [[nodiscard]] std::size_t waiting() const override { return disk_.posted.size(); }

   private:
    SlowDisk& disk_;
  };
  void work() {
    for (auto& one : std::exchange(posted, {})) one();
  }
  std::vector<std::function<void()>> posted;
  Computer computer{Devices(), false, false, [this] { return std::make_unique<Waiting>(*this); }};
};

class RouterStoreTest : public ::testing::Test {
 protected:
  void start(const std::string& folder, sample_log::LogUse use = sample_log::LogUse::queue) {
    sut_.emplace(disk_.computer, StorePlace{folder, {}, use}, [this] { ++told_; });
    sut_->open({t0, 1000});
    sut_->add({"battery|", "/battery", {0, "Battery", "", ""}, {}});
  }
  [[nodiscard]] static sample_log::SampleId id(std::uint64_t sequence) {
    return {sample_log::stream_key("battery|"), 7, sequence};
  }
  void append(std::uint64_t sequence) { sut_->append({id(sequence), 5, {1, 2}}, {t0, 1000}); }
  template <class Answer>
  std::vector<Answer> take() {
    std::vector<Answer> found;
    while (auto answer = sut_->take()) {
      if (auto* one = std::get_if<Answer>(&*answer)) found.push_back(std::move(*one));
    }
    return found;
  }
  TemporaryFolder folder_;
  SlowDisk disk_;
  int told_ = 0;
  std::optional<RouterStore> sut_;
};

TEST_F(RouterStoreTest, NothingWaitsForTheDisk) {
  start(folder_.path("store"));
  append(1);
  sut_->read({id(1)});
  EXPECT_EQ(told_, 0);
  EXPECT_FALSE(sut_->take());
  disk_.work();
  EXPECT_EQ(told_, 3);
  const auto answers = take<store_answer::Read>();
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(answers[0].read.at(0).id, id(1));
}

TEST_F(RouterStoreTest, AnswersFirstWhatEarlierInstancesLeft) {
  start(folder_.path("store"));
  append(1);
  append(2);
  sut_->confirm({id(1)});
  sut_->note_delivered({{1, 2, 3}}, std::nullopt);
  disk_.work();
  sut_.reset();
  start(folder_.path("store"));
  disk_.work();
  const auto first = sut_->take();
  ASSERT_TRUE(first && std::holds_alternative<store_answer::Opened>(*first));
  const auto& opened = std::get<store_answer::Opened>(*first);
  EXPECT_THAT(opened.waiting, ElementsAre(id(2)));
  EXPECT_TRUE(opened.delivered.contains({1, 2, 3}));
  ASSERT_EQ(opened.streams.size(), 1U);
  EXPECT_EQ(opened.streams[0].name, "battery|");
}

TEST_F(RouterStoreTest, WhatWasDeliveredIsSafeWhenItsTokenIsAnswered) {
  start(folder_.path("store"));
  sut_->note_delivered({{1, 2, 3}}, 41);
  sut_->note_delivered({}, 42);
  disk_.work();
  const auto saved = take<store_answer::Saved>();
  ASSERT_EQ(saved.size(), 2U);
  EXPECT_EQ(saved[0].token, 41U);
  EXPECT_EQ(saved[1].token, 42U);
}

TEST_F(RouterStoreTest, ADiskThatDoesNotAnswerCostsWhatComesThenAndOneProblem) {
  start(folder_.path("store"));
  disk_.work();
  (void)take<store_answer::Opened>();
  for (std::uint64_t i = 0; i < 4100; ++i) append(i);
  std::size_t refused = 0;
  std::vector<std::string> problems;
  while (const auto answer = sut_->take()) {
    if (const auto* one = std::get_if<store_answer::Appended>(&*answer)) {
      refused += one->logged.at(0).second == Logged::refused ? 1 : 0;
    }
    if (const auto* one = std::get_if<store_answer::Problem>(&*answer)) {
      problems.push_back(one->text);
    }
  }
  EXPECT_EQ(refused, 4U);
  EXPECT_THAT(problems, ElementsAre(HasSubstr("does not keep up")));
}

TEST_F(RouterStoreTest, AFolderThatCannotBeMadeIsOneProblemAndEverythingIsRefused) {
  (void)folder_.write("file", "");
  start(folder_.path("file/store"));
  append(1);
  sut_->read({id(1)});
  sut_->keep(t0);
  sut_->note_delivered({{1, 2, 3}}, 1);
  disk_.work();
  std::size_t problems = 0;
  bool saved = false;
  while (const auto answer = sut_->take()) {
    if (const auto* one = std::get_if<store_answer::Problem>(&*answer)) {
      ++problems;
      EXPECT_THAT(one->text, HasSubstr("file/store"));
      EXPECT_THAT(one->text, HasSubstr("nothing is stored"));
    }
    if (const auto* one = std::get_if<store_answer::Appended>(&*answer)) {
      EXPECT_EQ(one->logged.at(0).second, Logged::refused);
    }
    if (const auto* one = std::get_if<store_answer::Read>(&*answer)) {
      EXPECT_TRUE(one->read.empty());
    }
    saved = saved || std::holds_alternative<store_answer::Saved>(*answer);
  }
  EXPECT_EQ(problems, 1U);
  EXPECT_TRUE(saved) << "what comes is delivered all the same";
}

TEST_F(RouterStoreTest, AHistoryTellsWhatItHasAndFindsIt) {
  start(folder_.path("history"), sample_log::LogUse::history);
  append(1);
  append(2);
  sut_->confirm({id(1)});
  sut_->keep(t0);
  sut_->find(41, {"/battery", 0, 2000});
  sut_->forget({id(2)});
  sut_->read({id(2)});
  disk_.work();
  bool told = false;
  bool found = false;
  while (const auto answer = sut_->take()) {
    if (const auto* one = std::get_if<store_answer::Contents>(&*answer)) {
      told = true;
      ASSERT_EQ(one->spans.size(), 1U);
      EXPECT_EQ(one->spans[0].samples, 2U);
    }
    if (const auto* one = std::get_if<store_answer::Found>(&*answer)) {
      found = true;
      EXPECT_EQ(one->search, 41U);
      EXPECT_THAT(one->finding.ids, ElementsAre(id(2))) << "the other one is on the other side";
    }
    if (const auto* one = std::get_if<store_answer::Read>(&*answer)) {
      EXPECT_TRUE(one->read.empty()) << "forgotten";
    }
  }
  EXPECT_TRUE(told && found);
}

TEST_F(RouterStoreTest, RequestsAreThereForTheNextInstance) {
  start(folder_.path("store"), sample_log::LogUse::history);
  sut_->keep_requests("7 1 2 stop odom\n");
  sut_->keep_requests("8 1 2 stop odom\n");
  disk_.work();
  EXPECT_THAT(take<store_answer::Problem>(), ::testing::IsEmpty());
  sut_.reset();
  start(folder_.path("store"), sample_log::LogUse::history);
  disk_.work();
  EXPECT_EQ(take<store_answer::Opened>().at(0).requests, "8 1 2 stop odom\n");
}

}  // namespace
}  // namespace tocsin
