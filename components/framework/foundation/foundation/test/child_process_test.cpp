// SPDX-License-Identifier: Apache-2.0
#include "foundation/child_process.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

namespace tocsin {
namespace {

using Streams = ChildSetup::Streams;

/// All that it writes until it ends.
std::string output_of(const Child& child) {
  std::string text;
  std::array<char, 256> block{};
  for (;;) {
    pollfd waiting{child.output.get(), POLLIN, 0};
    if (::poll(&waiting, 1, 20'000) != 1) return text + " (and no end)";
    const ssize_t size = ::read(child.output.get(), block.data(), block.size());
    if (size == 0) return text;
    if (size > 0) text.append(block.data(), static_cast<std::size_t>(size));
  }
}

TEST(ChildProcess, ItsExitCodeIsTold) {
  EXPECT_EQ(wait_for_child(start_child({{"/bin/sh", "-c", "exit 7"}}).pid), 7);
  EXPECT_EQ(wait_for_child(start_child({{"/bin/sh", "-c", "kill -9 $$"}}).pid), 128 + 9);
}

TEST(ChildProcess, ArgumentsArePassedOnAsTheyAreWithoutAShell) {
  const Child child = start_child({{"/bin/echo", "a b", "$HOME", "'\"; exit 3"}, Streams::piped});
  EXPECT_EQ(output_of(child), "a b $HOME '\"; exit 3\n");
  EXPECT_EQ(wait_for_child(child.pid), 0);
}

TEST(ChildProcess, PipedStreamsAreBothOutputsAndAnEmptyInput) {
  const Child child =
      start_child({{"/bin/sh", "-c", "cat; echo out; echo err >&2"}, Streams::piped});
  EXPECT_EQ(output_of(child), "out\nerr\n");
  EXPECT_EQ(wait_for_child(child.pid), 0);
}

TEST(ChildProcess, OnlyErrorsArePipedFromAProgramThatHasTheTerminal) {
  ::testing::internal::CaptureStdout();
  const Child child =
      start_child({{"/bin/sh", "-c", "echo out; echo err >&2"}, Streams::errors_piped});
  EXPECT_EQ(output_of(child), "err\n");
  EXPECT_EQ(wait_for_child(child.pid), 0);
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "out\n");
}

TEST(ChildProcess, AProgramThatCannotBeExecutedIsNamed) {
  const Child child = start_child({{"/nowhere/program"}, Streams::piped});
  EXPECT_EQ(output_of(child), "/nowhere/program: No such file or directory\n");
  EXPECT_EQ(wait_for_child(child.pid), 127);
}

TEST(ChildProcess, ANamespaceThatIsNoneIsSaidAndNothingIsStarted) {
  const FileDescriptor no_namespace(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  const Child child =
      start_child({{"/bin/echo", "started"}, Streams::piped, SIGTERM, no_namespace.get(), {}});
  const std::string told = output_of(child);
  EXPECT_EQ(told.rfind("cannot enter the network namespace: ", 0), 0U) << told;
  EXPECT_EQ(told.find("started"), std::string::npos);
  EXPECT_EQ(wait_for_child(child.pid), 127);
}

TEST(ChildProcess, APipedOneHasAGroupOfItsOwnTheOtherIsInOurs) {
  const Child apart = start_child({{"/bin/sleep", "60"}, Streams::piped});
  const Child ours = start_child({{"/bin/sleep", "60"}});
  EXPECT_EQ(::getpgid(apart.pid), apart.pid);
  EXPECT_EQ(::getpgid(ours.pid), ::getpgrp());
  EXPECT_FALSE(ours.output);
  for (const pid_t pid : {apart.pid, ours.pid}) {
    ::kill(pid, SIGKILL);
    EXPECT_EQ(wait_for_child(pid), 128 + SIGKILL);
  }
}

TEST(ChildProcess, InheritsOnlyTheDescriptorsThatItShall) {
  const FileDescriptor given(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  const FileDescriptor kept(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  const std::string look = "for fd in " + std::to_string(given.get()) + " " +
                           std::to_string(kept.get()) +
                           "; do test -e /proc/self/fd/$fd && echo $fd; done";
  const Child child =
      start_child({{"/bin/sh", "-c", look}, Streams::piped, SIGTERM, {}, {given.get()}});
  EXPECT_EQ(output_of(child), std::to_string(given.get()) + "\n");
  (void)wait_for_child(child.pid);
}

TEST(ChildProcess, NoSignalIsBlockedOrIgnoredInIt) {
  sigset_t blocked, before;
  sigemptyset(&blocked);
  sigaddset(&blocked, SIGCHLD);
  ::sigprocmask(SIG_BLOCK, &blocked, &before);
  const auto old = std::signal(SIGINT, SIG_IGN);
  const Child child =
      start_child({{"/bin/grep", "-E", "^Sig(Blk|Ign)", "/proc/self/status"}, Streams::piped});
  const std::string told = output_of(child);
  (void)wait_for_child(child.pid);
  std::signal(SIGINT, old);
  ::sigprocmask(SIG_SETMASK, &before, nullptr);
  EXPECT_NE(told.find("SigBlk:\t0000000000000000"), std::string::npos) << told;
  const unsigned long ignored = std::stoul(told.substr(told.find("SigIgn:") + 8), nullptr, 16);
  EXPECT_EQ(ignored & (1UL << (SIGINT - 1)), 0U) << told;
}

/// A process that starts a child and dies; who reads the pipe sees the end of both.
TEST(ChildProcess, EndsWhenItsParentDies) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const pid_t parent = ::fork();
  if (parent == 0) {
    ::close(ends[0]);
    const Child child = start_child({{"/bin/sleep", "60"}, Streams::ours, SIGKILL, {}, {ends[1]}});
    ::_exit(child.pid > 0 ? 0 : 1);
  }
  ::close(ends[1]);
  EXPECT_EQ(wait_for_child(parent), 0);
  pollfd closed{ends[0], POLLIN, 0};
  EXPECT_EQ(::poll(&closed, 1, 20'000), 1) << "the child lives on";
  ::close(ends[0]);
}

}  // namespace
}  // namespace tocsin
