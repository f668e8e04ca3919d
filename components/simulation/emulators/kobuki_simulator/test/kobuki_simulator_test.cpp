// SPDX-License-Identifier: Apache-2.0
/// The program as a user runs it, over its pseudo-terminal and sockets. Waits for conditions only.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "foundation/datagram_socket.hpp"
#include "foundation/file_descriptor.hpp"
#include "foundation/temporary_folder.hpp"
#include "kobuki_protocol/command.hpp"
#include "kobuki_protocol/reassembler.hpp"

extern char** environ;

namespace tocsin::kobuki {
namespace {

using Clock = std::chrono::steady_clock;

/// Polls the descriptor until `done` or the deadline; false at the deadline.
bool wait_for(int descriptor, double limit_s, const std::function<bool()>& done) {
  const auto end = Clock::now() + std::chrono::duration<double>(limit_s);
  while (!done()) {
    if (Clock::now() > end) return false;
    pollfd asked{descriptor, POLLIN, 0};
    ::poll(&asked, 1, 10);
  }
  return true;
}

struct Program : ::testing::Test {
  void TearDown() override {
    if (pid > 0) end(SIGKILL);
  }

  void start(std::vector<std::string> more = {}) {
    std::vector<std::string> words{
        "kobuki_simulator",  "--link", link, "--control", folder + "/control", "--position",
        folder + "/position"};
    words.insert(words.end(), more.begin(), more.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    ASSERT_EQ(::posix_spawn(&pid, SIMULATOR_PROGRAM, nullptr, nullptr, argv.data(), environ), 0);
  }

  /// Exit code, or minus the signal that ended it.
  int end(int signal) {
    if (signal != 0) ::kill(pid, signal);
    int status = 0;
    ::waitpid(pid, &status, 0);
    pid = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  bool open_port(double limit_s = 5) {
    return wait_for(-1, limit_s, [&] {
      port.reset(::open(link.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK));
      return static_cast<bool>(port);
    });
  }

  bool receive_frames(std::uint64_t count, double limit_s = 10) {
    const std::uint64_t target = reassembler.counts().frames + count;
    return wait_for(port.get(), limit_s, [&] {
      std::uint8_t bytes[512];
      const auto got = ::read(port.get(), bytes, sizeof bytes);
      if (got > 0) {
        reassembler.feed({bytes, static_cast<std::size_t>(got)},
                         [&](ByteView payload) { last = decode_feedback(payload, counts); });
      }
      return reassembler.counts().frames >= target;
    });
  }

  void send(const Command& command) {
    const Frame frame = encode_command(command);
    ASSERT_GT(::write(port.get(), frame.bytes().data, frame.bytes().size), 0);
  }

  std::string ask(const std::string& text) {
    DatagramSocket client(folder + "/client");
    (void)client.send(folder + "/control", text);
    std::string answer;
    wait_for(client.descriptor(), 5, [&] {
      if (auto message = client.receive()) answer = message->text;
      return !answer.empty();
    });
    return answer;
  }

  const TemporaryFolder temporary;
  const std::string folder = temporary.path();
  const std::string link = folder + "/port";
  pid_t pid = -1;
  FileDescriptor port;
  Reassembler reassembler;
  DecodeCounts counts;
  Feedback last;
};

TEST_F(Program, SendsFiftyFramesASecondAndLosesNone) {
  start();
  ASSERT_TRUE(open_port());
  ASSERT_TRUE(receive_frames(1));
  const auto begin = Clock::now();
  ASSERT_TRUE(receive_frames(50));
  const double took_s = std::chrono::duration<double>(Clock::now() - begin).count();
  EXPECT_NEAR(took_s, 1.0, 0.3);
  EXPECT_EQ(reassembler.counts().rejected, 0U);
}

TEST_F(Program, ObeysCommandsAndTellsItsPosition) {
  DatagramSocket position(folder + "/position");
  start({"--start", "1,2,0"});
  ASSERT_TRUE(open_port());
  send(BaseControl{500, 0});
  double x = 0;
  EXPECT_TRUE(wait_for(position.descriptor(), 5, [&] {
    double y = 0;
    while (const auto message = position.receive()) {
      EXPECT_EQ(std::sscanf(message->text.c_str(), "pos %lf %lf", &x, &y), 2);
      EXPECT_NEAR(y, 2, 0.1);
    }
    return x > 1.2;
  }));
}

TEST_F(Program, TakesControlCommands) {
  start();
  ASSERT_TRUE(open_port());
  EXPECT_EQ(ask("set bumper=2"), "ok");
  ASSERT_TRUE(wait_for(port.get(), 5,
                       [&] { return receive_frames(1) && last.core && last.core->bumper == 2; }));
  EXPECT_EQ(ask("get").front(), '{');
}

TEST_F(Program, PlaysAScriptOfFaults) {
  std::ofstream(folder + "/walls") << "0.1 set bumper=4\n0.2 set cliff=1\n";
  start({"--script", folder + "/walls"});
  ASSERT_TRUE(open_port());
  EXPECT_TRUE(wait_for(port.get(), 5, [&] {
    return receive_frames(1) && last.core && last.core->bumper == 4 && last.core->cliff == 1;
  }));
}

TEST_F(Program, RemovesItsLinkAndSocketsOnSigterm) {
  start();
  ASSERT_TRUE(open_port());
  ASSERT_EQ(ask("plug"), "ok");
  EXPECT_EQ(end(SIGTERM), 0);
  EXPECT_NE(::access(link.c_str(), F_OK), 0);
  EXPECT_NE(::access((folder + "/control").c_str(), F_OK), 0);
}

TEST_F(Program, ReplacesWhatAKilledRunLeftAndResumes) {
  start({"--state", folder + "/state", "--start", "5,0,0"});
  ASSERT_TRUE(open_port());
  ASSERT_EQ(ask("place 7 3 0"), "ok");
  ASSERT_TRUE(wait_for(-1, 5, [&] {
    double x = 0;
    std::ifstream in(folder + "/state");
    return in >> x && x == 7;
  }));
  EXPECT_EQ(end(SIGKILL), -SIGKILL);
  start({"--state", folder + "/state", "--start", "5,0,0"});
  reassembler.clear();
  ASSERT_TRUE(wait_for(-1, 5, [&] { return open_port() && receive_frames(1, 0.5); }));
  EXPECT_NE(ask("get").find("\"x\":7.0"), std::string::npos);
}

TEST_F(Program, ComesBackAfterUnplugging) {
  start();
  ASSERT_TRUE(open_port());
  ASSERT_TRUE(receive_frames(1));
  ASSERT_EQ(ask("unplug 0.3"), "ok");
  EXPECT_TRUE(wait_for(-1, 5, [&] { return ::access(link.c_str(), F_OK) != 0; }));
  reassembler.clear();
  ASSERT_TRUE(open_port());
  EXPECT_TRUE(receive_frames(5));
}

TEST_F(Program, GivesAFreshTerminalAfterAnExclusiveUserDied) {
  start();
  ASSERT_TRUE(open_port());
  ASSERT_TRUE(receive_frames(1));
  ASSERT_EQ(::ioctl(port.get(), TIOCEXCL), 0);
  char before[64] = {};
  ASSERT_GT(::readlink(link.c_str(), before, sizeof before - 1), 0);
  port.reset();
  EXPECT_TRUE(wait_for(-1, 5, [&] {
    char after[64] = {};
    return ::readlink(link.c_str(), after, sizeof after - 1) > 0 && std::string(after) != before;
  }));
  ASSERT_TRUE(open_port());
  reassembler.clear();
  EXPECT_TRUE(receive_frames(5));
}

TEST_F(Program, EndsWithCode2ForBadFiles) {
  start({"--walls", "/nonexistent.yaml"});
  EXPECT_EQ(end(0), 2);
  std::ofstream(folder + "/walls") << "soon reset\n";
  start({"--script", folder + "/walls"});
  EXPECT_EQ(end(0), 2);
  start({"--start", "here"});
  EXPECT_EQ(end(0), 2);
  std::ofstream(link) << "a file of the user";
  start();
  EXPECT_EQ(end(0), 2);
  EXPECT_EQ(::access(link.c_str(), F_OK), 0);
}

}  // namespace
}  // namespace tocsin::kobuki
