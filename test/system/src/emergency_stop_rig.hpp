// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "operator_process.hpp"
#include "peer.hpp"
#include "stack.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Somebody on a host who drives the base at 0.5 m/s, fifty times a second, past all components.
inline std::function<void(Bus&)> drive_past_all() {
  topic::CmdVel::Message message;
  message.linear().x(0.5);
  return repeat<topic::CmdVel>(message, std::chrono::milliseconds(20));
}

inline topic::EmergencyStop::Message word(bool pressed) {
  topic::EmergencyStop::Message message;
  message.data(pressed);
  return message;
}

/// The main job, its emergency stop, and the wheels as a peer sees them.
class EmergencyStopTest : public ::testing::Test {
 protected:
  static constexpr int domain = 40;  // of bringup/mission.yaml

  /// Starts Mission A and waits until the vehicle drives.
  void drive(const std::vector<std::string>& more = {}, int disk_mib = 0) {
    std::vector<std::string> arguments{bringup_,      "--seed",    "1",       "--without",
                                       "uxv/payload", "--without", "gcs/view"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    stack_.emplace(arguments, disk_mib);
    wheels_ = stack_->scratch() + "/wheels";
    (void)stack_->running("gcs/mission");  // the last process of the file
    watch_.emplace(stack_->running("uxv/recorder"), on_host(domain), watch_wheels(wheels_));
    ASSERT_TRUE(moves()) << stack_->output();
  }
  /// `tocsin estop` as a person types it, from a folder of no run; its exit code.
  int estop(const std::vector<std::string>& words) {
    std::vector<std::string> command{Stack::program("tocsin-estop")};
    command.insert(command.end(), words.begin(), words.end());
    said_ = stack_->scratch() + "/said";
    std::filesystem::remove(said_);
    return OperatorProcess(command, said_).exit_code(std::chrono::seconds(30));
  }
  [[nodiscard]] std::string said() const {
    std::ifstream file(said_);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  /// Whether the vehicle moves within the next half minute.
  bool moves() const {
    const double now = wall_s();
    return Stack::eventually(std::chrono::seconds(30), [&] { return last_moved(wheels_) > now; });
  }
  /// Whether it comes to rest within 1.5 s, stays so for a while, and is heard to stand.
  bool stands(double for_s = 3) const {
    const double rests = wall_s() + 1.5;
    return Stack::eventually(std::chrono::seconds(20),
                             [&] { return last_seen(wheels_) > rests + for_s; }) &&
           last_moved(wheels_) <= rests;
  }
  std::string bringup_ = "mission.yaml";
  std::optional<Stack> stack_;
  std::string wheels_;
  std::optional<Peer> watch_;
  std::string said_;
};

}  // namespace tocsin
