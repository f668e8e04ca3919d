// SPDX-License-Identifier: Apache-2.0
#include "foundation/privileges.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/capability.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <fstream>
#include <functional>
#include <sstream>

#include "foundation/child_process.hpp"
#include "foundation/error.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;

constexpr uid_t user = 65'533;
const Account account{"", user, user};

/// The exit code of a child that has become the user and then does this.
int as_user(const Capabilities& kept, const std::function<bool()>& body) {
  const pid_t child = ::fork();
  if (child == 0) {
    become_user(account, kept);
    ::_exit(body() ? 0 : 1);
  }
  return wait_for_child(child);
}

std::string status() {
  std::ostringstream text;
  text << std::ifstream("/proc/thread-self/status").rdbuf();
  return text.str();
}

bool has(const std::string& line) { return status().find(line) != std::string::npos; }

/// Whether this thread may make a network namespace.
bool may_make_network() { return ::unshare(CLONE_NEWNET) == 0; }

/// Has the kernel refuse capset(2) from now on, as the sandbox of a service does.
bool forbid_capset() {
  std::array<sock_filter, 4> program{
      {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
       BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_capset, 0, 1),
       BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM),
       BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)}};
  const sock_fprog filter{program.size(), program.data()};
  return ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

class Privileges : public ::testing::Test {
 protected:
  void SetUp() override {
    if (::geteuid() != 0) GTEST_SKIP() << "only root can become another user";
  }
};

TEST_F(Privileges, WhoPassesNoneOnNeedsNoRightToDoSo) {
  EXPECT_EQ(as_user({},
                    [] {
                      return forbid_capset() && pass_on_capabilities({}) &&
                             !pass_on_capabilities({CAP_NET_ADMIN});
                    }),
            0);
}

TEST_F(Privileges, AnOrdinaryUserHasNoneAndGetsNone) {
  EXPECT_EQ(as_user({},
                    [] {
                      return has("Uid:\t65533\t65533\t65533\t65533") &&
                             has("Gid:\t65533\t65533\t65533\t65533") && has("Groups:\t \n") &&
                             has("CapPrm:\t0000000000000000") && has("CapEff:\t0000000000000000") &&
                             has("CapAmb:\t0000000000000000") && has("NoNewPrivs:\t1");
                    }),
            0);
  EXPECT_EQ(as_user({}, [] { return ::setresuid(0, 0, 0) != 0 && !may_make_network(); }), 0);
}

TEST_F(Privileges, WhatIsKeptSleepsUntilItIsAwake) {
  EXPECT_EQ(as_user({CAP_SYS_ADMIN},
                    [] {
                      if (may_make_network()) return false;
                      {
                        const AwakeCapabilities awake;
                        if (!may_make_network()) return false;
                      }
                      return !may_make_network();
                    }),
            0);
}

TEST_F(Privileges, WhatIsGivenUpDoesNotComeBack) {
  EXPECT_EQ(as_user({CAP_SYS_ADMIN, CAP_NET_ADMIN},
                    [] {
                      keep_only({CAP_NET_ADMIN});
                      const AwakeCapabilities awake;
                      return !may_make_network() && has("CapPrm:\t0000000000001000");
                    }),
            0);
}

TEST_F(Privileges, AProgramHasOnlyWhatItIsGiven) {
  const auto effective = [](const Capabilities& given, const std::string& wanted) {
    return as_user({CAP_SYS_ADMIN, CAP_NET_ADMIN}, [&] {
      ChildSetup setup{{"/bin/grep", "-q", "CapEff:." + wanted, "/proc/self/status"}};
      setup.capabilities = given;
      return wait_for_child(start_child(setup).pid) == 0;
    });
  };
  EXPECT_EQ(effective({}, "0000000000000000"), 0);
  EXPECT_EQ(effective({CAP_NET_ADMIN}, "0000000000001000"), 0);
}

TEST_F(Privileges, AChildThatIsGivenNothingEntersANetworkAllTheSame) {
  const FileDescriptor network(::open("/proc/self/ns/net", O_RDONLY | O_CLOEXEC));
  EXPECT_EQ(
      as_user(
          {CAP_SYS_ADMIN},
          [&] {
            ChildSetup setup{{"/bin/grep", "-q", "CapEff:.0000000000000000", "/proc/self/status"}};
            setup.network = network.get();
            return wait_for_child(start_child(setup).pid) == 0;
          }),
      0);
}

TEST_F(Privileges, OfRootNothingChanges) {
  const std::string before = status();
  { const AwakeCapabilities awake; }
  const auto capabilities = [](const std::string& text) {
    const auto at = text.find("CapEff");
    return text.substr(at, text.find('\n', at) - at);
  };
  EXPECT_EQ(capabilities(status()), capabilities(before));
}

}  // namespace
}  // namespace tocsin
