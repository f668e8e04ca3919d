// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "keys.hpp"
#include "kobuki_driver/byte_port.hpp"
#include "kobuki_driver/kobuki_driver.hpp"

namespace tocsin::kobuki {

/// A driver on a port in real time, for the commands of tocsin-kobuki. One thread. Leaves the base
/// standing.
class Session {
 public:
  /// Throws EnvironmentError, naming the holder, when the port is absent or in use.
  explicit Session(const std::string& port);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Runs the driver until `done` holds, a key was pressed that `done` did not ask for, or `limit`
  /// has passed. Whether `done` holds.
  bool run_until(const std::function<bool()>& done, Duration limit);
  void run_for(Duration duration);
  /// The key pressed last since the last call.
  [[nodiscard]] std::optional<char> key();
  /// Ctrl-C, SIGTERM, or the port was lost.
  [[nodiscard]] bool over() const;

  [[nodiscard]] KobukiDriver& driver() { return driver_; }
  /// Null before the first frame.
  [[nodiscard]] const Reading* last() const { return readings_ > 0 ? &last_ : nullptr; }
  [[nodiscard]] std::uint64_t readings() const { return readings_; }
  /// Called with each frame from now on.
  void on_reading(std::function<void(const Reading&)> sink) { sink_ = std::move(sink); }
  [[nodiscard]] static Time now() { return std::chrono::steady_clock::now(); }

 private:
  void wait(Time until);
  void read(Time now);
  void send(ByteView bytes);

  std::unique_ptr<BytePort> port_;
  KobukiDriver driver_{KobukiDriver::Params{}};
  Keys keys_;
  std::optional<char> key_;
  std::function<void(const Reading&)> sink_ = [](const Reading&) {};
  Reading last_;
  std::uint64_t readings_ = 0;
  bool lost_ = false;
};

}  // namespace tocsin::kobuki
