// SPDX-License-Identifier: Apache-2.0
#include "link/flow_text.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <tuple>
#include <vector>

namespace tocsin {
namespace {

Flow flow() {
  Flow flow;
  flow.topic = "goal";
  flow.type = "Goal";
  flow.reliable = true;
  flow.transient_local = true;
  flow.depth = 3;
  flow.lifespan_s = 2.5;
  flow.user_data = "tocsinlayout=0a1b;";
  return flow;
}

/// What a peer reads of an announcement.
Flow read(const std::string& announcement) {
  Flow flow;
  flow.user_data = announcement;
  read_announcement(flow);
  return flow;
}

TEST(FlowText, APeerReadsWhatWasAnnounced) {
  EXPECT_EQ(announcement_of(flow()),
            "tocsinlayout=0a1b;tocsinflow=reliable,transient_local,3,2.5;");
  Flow endless = flow();
  endless.lifespan_s = std::numeric_limits<double>::infinity();
  for (const Flow& told : {flow(), endless}) {
    Flow back = read(announcement_of(told));
    back.topic = "goal";
    back.type = "Goal";
    EXPECT_EQ(back, told);
  }
}

TEST(FlowText, WhatElseAWriterAnnouncesIsKept) {
  Flow odd = flow();
  odd.user_data = "mine";
  for (const auto& [text, user_data, reliable, depth] :
       std::vector<std::tuple<std::string, const char*, bool, int>>{
           {announcement_of(odd), "mine;", true, 3},
           {"a=1;tocsinflow=reliable,volatile,1,inf;b=2;", "a=1;b=2;", true, 1},
           {"typehash=RIHS01_ab;", "typehash=RIHS01_ab;", false, 1}}) {
    const Flow back = read(text);
    EXPECT_EQ(back.user_data, user_data);
    EXPECT_EQ(back.reliable, reliable) << text;
    EXPECT_EQ(back.depth, depth) << text;
  }
}

TEST(FlowText, TellsThatAFlowIsStored) {
  Flow stored = flow();
  stored.stored = true;
  EXPECT_EQ(announcement_of(stored),
            "tocsinlayout=0a1b;tocsinflow=reliable,transient_local,3,2.5,stored;");
  EXPECT_TRUE(read(announcement_of(stored)).stored);
  EXPECT_FALSE(read(announcement_of(flow())).stored);
  EXPECT_FALSE(read("tocsinflow=reliable,volatile,1,inf,storm;").stored);
  stored.lifespan_s = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(read(announcement_of(stored)).stored);
}

TEST(FlowText, TellsThatAWriterIsOfTheSecondPath) {
  for (const bool stored : {false, true}) {
    Flow second = flow();
    second.path = 1;
    second.stored = stored;
    const Flow back = read(announcement_of(second));
    EXPECT_EQ(back.path, 1);
    EXPECT_EQ(back.stored, stored);
    EXPECT_EQ(back.user_data, flow().user_data);
  }
  EXPECT_EQ(read("tocsinflow=reliable,volatile,1,inf,third;").path, 0);
}

TEST(FlowText, WhatMakesNoSenseChangesNothing) {
  for (const char* text :
       {"tocsinflow=", "tocsinflow=;", "tocsinflow=reliable", "tocsinflow=,,,;",
        "tocsinflow=reliable,volatile,0,1;", "tocsinflow=reliable,volatile,-3,1;",
        "tocsinflow=reliable,volatile,99999,1;", "tocsinflow=reliable,volatile,1,-1;",
        "tocsinflow=reliable,volatile,1,x;"}) {
    const Flow back = read(text);
    EXPECT_FALSE(back.reliable) << text;
    EXPECT_EQ(back.depth, 1) << text;
    EXPECT_EQ(back.lifespan_s, std::numeric_limits<double>::infinity()) << text;
  }
}

TEST(FlowText, NoBytesOfAPeerDoHarm) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const std::string whole = announcement_of(flow());
  for (int i = 0; i < 5000; ++i) {
    std::string text = whole;
    for (int change = 0; change < 4; ++change) {
      text[random() % text.size()] = static_cast<char>(random() % 256);
    }
    text.resize(random() % (text.size() + 1));
    const Flow back = read(text);
    EXPECT_GE(back.depth, 1);
    EXPECT_GT(back.lifespan_s, 0);
  }
}

TEST(Flows, DifferInAnyOfTheirParts) {
  const auto changed = [](const auto& change) {
    Flow other = flow();
    change(other);
    return other != flow();
  };
  EXPECT_EQ(flow(), flow());
  EXPECT_TRUE(changed([](Flow& f) { f.topic = "x"; }));
  EXPECT_TRUE(changed([](Flow& f) { f.type = "x"; }));
  EXPECT_TRUE(changed([](Flow& f) { f.reliable = false; }));
  EXPECT_TRUE(changed([](Flow& f) { f.transient_local = false; }));
  EXPECT_TRUE(changed([](Flow& f) { f.depth = 4; }));
  EXPECT_TRUE(changed([](Flow& f) { f.lifespan_s = 4; }));
  EXPECT_TRUE(changed([](Flow& f) { f.user_data = "x"; }));
}

}  // namespace
}  // namespace tocsin
