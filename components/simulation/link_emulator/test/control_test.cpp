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

TEST(ControlSocket, ReceivesDatagramsAndDisappearsAtTheEnd) {
  const std::string path = ::testing::TempDir() + "control_test_socket";
  {
    ControlSocket sut(path);
    std::string text;
    EXPECT_FALSE(sut.receive(text));
    const int sender = ::socket(AF_UNIX, SOCK_DGRAM, 0);
    sockaddr_un to{};
    to.sun_family = AF_UNIX;
    path.copy(to.sun_path, path.size());
    const auto* address = reinterpret_cast<const sockaddr*>(&to);
    EXPECT_EQ(::sendto(sender, "pos 1 2", 7, 0, address, sizeof to), 7);
    EXPECT_EQ(::sendto(sender, "", 0, 0, address, sizeof to), 0);
    ::close(sender);
    EXPECT_TRUE(sut.receive(text));
    EXPECT_EQ(text, "pos 1 2");
    EXPECT_TRUE(sut.receive(text));
    EXPECT_EQ(text, "");
  }
  EXPECT_NE(::access(path.c_str(), F_OK), 0);
}

TEST(ControlSocket, ReplacesALeftOverSocketButNoFile) {
  const std::string path = ::testing::TempDir() + "control_test_left_over";
  const ControlSocket first(path);
  EXPECT_NO_THROW(ControlSocket{path});
  const std::string file = ::testing::TempDir() + "control_test_file";
  std::ofstream(file) << "precious";
  EXPECT_THROW(ControlSocket{file}, ConfigError);
  EXPECT_EQ(::access(file.c_str(), F_OK), 0);
}

TEST(ControlSocket, RefusesPathsThatDoNotFit) {
  EXPECT_THROW(ControlSocket{"/tmp/" + std::string(120, 'a')}, ConfigError);
  EXPECT_THROW(ControlSocket{"/does/not/exist/socket"}, ConfigError);
}

}  // namespace
}  // namespace tocsin::link
