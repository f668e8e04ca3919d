// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <vector>

namespace tocsin {

/// A command of an operator, in a process group of its own; what is typed reaches its input.
/// It is killed in the end.
class OperatorProcess {
 public:
  /// `output` is a file that gets what it prints.
  OperatorProcess(const std::vector<std::string>& words, const std::string& output);
  ~OperatorProcess();
  OperatorProcess(const OperatorProcess&) = delete;
  OperatorProcess& operator=(const OperatorProcess&) = delete;

  /// 0 when it has ended.
  [[nodiscard]] pid_t pid() const { return pid_ > 0 ? pid_ : 0; }
  void type(const std::string& keys) const;
  /// Asks it and its children to end, and waits up to 10 s for it.
  void end_all();
  /// Kills it with all its children at once, without a chance to say anything.
  void kill_all() const;
  /// The exit code; -1 when it did not end within `limit`.
  int exit_code(std::chrono::seconds limit);

 private:
  pid_t pid_ = -1;
  int input_ = -1;
  int code_ = -1;
};

}  // namespace tocsin
