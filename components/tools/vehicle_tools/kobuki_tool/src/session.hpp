// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "devices/serial_device.hpp"
#include "event_wait.hpp"
#include "kobuki_driver/kobuki_driver.hpp"

namespace tocsin::kobuki {

/// How a session lost its base.
enum class Loss {
  none,
  port,   ///< the device is gone, as when its cable is pulled
  frames  ///< nothing was heard for 3 s
};

/// A driver on a port, for the commands of tocsin-kobuki. One thread. Leaves the base standing. A
/// base that was lost stays lost.
class Session {
 public:
  /// `name` stands for the port in messages. `wait` must outlive this.
  Session(std::unique_ptr<SerialDevice> port, std::string name, EventWait& wait);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Runs the driver until `done` holds, a key was pressed that `done` did not ask for, `limit` has
  /// passed, or the session is over. Whether `done` holds.
  bool run_until(const std::function<bool()>& done, Duration limit);
  void run_for(Duration duration);
  /// Waits for another frame, whatever keys are pressed; false when the session is over instead.
  [[nodiscard]] bool hears_base();
  /// The key pressed last since the last call.
  [[nodiscard]] std::optional<char> key();

  /// The user ended it, or the base was lost.
  [[nodiscard]] bool over() const { return lost() || interrupted(); }
  [[nodiscard]] bool lost() const { return loss_ != Loss::none; }
  [[nodiscard]] bool interrupted() const { return wait_.interrupted(); }
  /// Throws EnvironmentError, naming the port, when the base was lost.
  void check() const;

  [[nodiscard]] KobukiDriver& driver() { return driver_; }
  [[nodiscard]] const KobukiDriver& driver() const { return driver_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  /// Null before the first frame.
  [[nodiscard]] const Reading* last() const { return readings_ > 0 ? &last_ : nullptr; }
  /// Called with each frame from now on.
  void on_reading(std::function<void(const Reading&)> sink) { sink_ = std::move(sink); }
  [[nodiscard]] Time now() const { return wait_.now(); }

 private:
  /// Waits for bytes, a key or `until`, and reads and commands the base.
  void turn(Time until);
  void read(Time now);
  void send(ByteView bytes);
  void lose(Loss loss);

  std::unique_ptr<SerialDevice> port_;
  std::string name_;
  EventWait& wait_;
  KobukiDriver driver_{KobukiDriver::Params{}};
  std::optional<char> key_;
  std::function<void(const Reading&)> sink_ = [](const Reading&) {};
  Reading last_;
  std::uint64_t readings_ = 0;
  Time heard_;  ///< the last frame, or the start
  Loss loss_ = Loss::none;
};

}  // namespace tocsin::kobuki
