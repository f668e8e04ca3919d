// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <functional>

#include "foundation/file_descriptor.hpp"

namespace tocsin {

/// "nobody" of Debian: a user without rights, who is not the one of the tests.
inline constexpr uid_t stranger = 65'534;

/// Only root can become somebody else.
inline bool can_become_stranger() { return ::geteuid() == 0; }

/// A child process of `user` that acts and then keeps what it has open until this ends. To be
/// made while there is one thread only.
class ProcessOf {
 public:
  ProcessOf(uid_t user, const std::function<int()>& act) {
    std::array<int, 2> to_child{};
    std::array<int, 2> to_parent{};
    if (::pipe(to_child.data()) != 0 || ::pipe(to_parent.data()) != 0) return;
    pid_ = ::fork();
    const FileDescriptor wait_here(to_child[0]);
    const FileDescriptor say_here(to_parent[1]);
    life_.reset(to_child[1]);
    heard_.reset(to_parent[0]);
    if (pid_ == 0) live(user, act, wait_here, say_here);
  }
  ~ProcessOf() {
    life_.reset();
    int status = 0;
    if (pid_ > 0) ::waitpid(pid_, &status, 0);
  }
  ProcessOf(const ProcessOf&) = delete;
  ProcessOf& operator=(const ProcessOf&) = delete;
  /// What `act` has returned, once it has; -1 when the process could not become `user`.
  [[nodiscard]] int result() {
    int code = -1;
    return ::read(heard_.get(), &code, sizeof code) == sizeof code ? code : -1;
  }

 private:
  [[noreturn]] void live(uid_t user, const std::function<int()>& act, const FileDescriptor& wait,
                         const FileDescriptor& say) {
    life_.reset();
    const bool is_user = user == ::geteuid() || ::setresuid(user, user, user) == 0;
    const int code = is_user ? act() : -1;
    char end = 0;
    const bool said = ::write(say.get(), &code, sizeof code) == sizeof code;
    while (said && ::read(wait.get(), &end, 1) > 0) {
    }
    ::_exit(0);
  }
  pid_t pid_ = -1;
  FileDescriptor life_;
  FileDescriptor heard_;
};

}  // namespace tocsin
