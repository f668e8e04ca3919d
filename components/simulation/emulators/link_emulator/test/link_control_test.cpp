// SPDX-License-Identifier: Apache-2.0
#include "control.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <fstream>

#include "foundation/error.hpp"

namespace tocsin::link {
namespace {

bool malformed(const std::string& text) {
  return std::holds_alternative<std::monostate>(parse_command(text));
}

bool set(radio::ChannelParams& params, const std::string& key, const std::string& value) {
  return set_parameter(params, {key, value});
}

TEST(Command, ReadsPositions) {
  const auto sut = std::get<MoveTo>(parse_command("pos 1.5 -2e1\n"));
  EXPECT_EQ(sut.x_m, 1.5);
  EXPECT_EQ(sut.y_m, -20);
}

TEST(Command, ReadsOutagesOfUpToADay) {
  EXPECT_EQ(std::get<BeginOutage>(parse_command("set outage 20")).length_s, 20);
  EXPECT_EQ(std::get<BeginOutage>(parse_command("set outage 86400")).length_s, 86400);
  EXPECT_TRUE(malformed("set outage 86401"));
  EXPECT_TRUE(malformed("set outage 0"));
  EXPECT_TRUE(malformed("set outage -1"));
}

TEST(Command, ReadsParametersUnchecked) {
  const auto sut = std::get<SetParameter>(parse_command("set loss x"));
  EXPECT_EQ(sut.key, "loss");
  EXPECT_EQ(sut.value, "x");
}

TEST(Command, TakesEverythingElseAsMalformed) {
  for (const char* text : {"", "pos", "pos 1", "pos 1 2 3", "pos x 2", "pos 1 nan", "pos inf 1",
                           "pos 1 2m", "set loss", "go 1 2", "\x01\xff 1 2"}) {
    EXPECT_TRUE(malformed(text)) << text;
  }
}

TEST(SetParameter, ChangesNumbersInsideTheirRange) {
  radio::ChannelParams sut;
  EXPECT_TRUE(set(sut, "loss", "1"));
  EXPECT_EQ(sut.loss, 1);
  EXPECT_FALSE(set(sut, "loss", "1.01"));
  EXPECT_FALSE(set(sut, "loss", "nan"));
  EXPECT_FALSE(set(sut, "loss", "much"));
  EXPECT_EQ(sut.loss, 1);
}

TEST(SetParameter, ChangesWholeNumbersToWholeNumbersOnly) {
  radio::ChannelParams sut;
  EXPECT_TRUE(set(sut, "queue_frames", "50"));
  EXPECT_EQ(sut.queue_frames, 50);
  EXPECT_FALSE(set(sut, "queue_frames", "50.5"));
  EXPECT_FALSE(set(sut, "queue_frames", "0"));
  EXPECT_EQ(sut.queue_frames, 50);
}

TEST(SetParameter, ChangesTheModeToAllowedWords) {
  radio::ChannelParams sut;
  EXPECT_TRUE(set(sut, "mode", "gilbert_elliott"));
  EXPECT_EQ(sut.mode, "gilbert_elliott");
  EXPECT_FALSE(set(sut, "mode", "magic"));
  EXPECT_EQ(sut.mode, "gilbert_elliott");
}

TEST(SetParameter, RefusesListsAndUnknownKeys) {
  radio::ChannelParams sut;
  EXPECT_FALSE(set(sut, "outages_s", "1"));
  EXPECT_FALSE(set(sut, "lost", "1"));
}

}  // namespace
}  // namespace tocsin::link
