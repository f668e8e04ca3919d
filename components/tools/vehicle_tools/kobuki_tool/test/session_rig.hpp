// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <deque>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "kobuki_model/base_model.hpp"
#include "kobuki_model/serial_line.hpp"
#include "session.hpp"
#include "simulator_control.hpp"

namespace tocsin::kobuki {

/// A base on a cable in virtual time: the port, the clock and the simulator's control of a session.
class SessionRig final : public EventWait, public SimulatorControl {
 public:
  explicit SessionRig(const ModelParams& base = {})
      : model_(base, open_floor(), {}, 1, now_), line_(LineParams{}, 2, now_) {}

  /// A session on this base; one at a time.
  [[nodiscard]] std::unique_ptr<Session> open() {
    return std::make_unique<Session>(std::make_unique<Port>(*this), "/dev/test", *this);
  }

  [[nodiscard]] Time now() const override { return now_; }
  std::optional<char> wait(std::optional<int>, Time until) override;
  [[nodiscard]] bool interrupted() const override { return now_ >= interrupt_at; }
  [[nodiscard]] std::optional<std::string> ask(const std::string& line) override;

  [[nodiscard]] BaseModel& model() { return model_; }
  [[nodiscard]] double elapsed_s() const { return to_seconds(now_ - start); }
  static constexpr Time start = Time{} + std::chrono::seconds(1000);

  Time unplug_at = never;     ///< the device is gone
  Time silent_at = never;     ///< the base sends nothing more
  Time deaf_at = never;       ///< the base gets nothing more
  Time interrupt_at = never;  ///< Ctrl-C
  std::multimap<Time, char> keys;
  std::string refuses;  ///< a `set` that begins so does nothing

 private:
  class Port final : public SerialDevice {
   public:
    explicit Port(SessionRig& rig) : rig_(rig) {}
    std::optional<std::size_t> read(std::uint8_t* to, std::size_t size) override;
    bool write(const std::uint8_t* bytes, std::size_t size) override;

   private:
    SessionRig& rig_;
  };
  void set(std::istringstream& words);

  Time now_ = start;
  BaseModel model_;
  SerialLine line_;
  std::deque<std::uint8_t> arrived_;
};

inline std::optional<std::size_t> SessionRig::Port::read(std::uint8_t* to, std::size_t size) {
  if (rig_.now_ >= rig_.unplug_at) return std::nullopt;
  const std::size_t count = std::min(size, rig_.arrived_.size());
  std::copy_n(rig_.arrived_.begin(), count, to);
  rig_.arrived_.erase(rig_.arrived_.begin(),
                      rig_.arrived_.begin() + static_cast<std::ptrdiff_t>(count));
  return count;
}

inline bool SessionRig::Port::write(const std::uint8_t* bytes, std::size_t size) {
  if (rig_.now_ >= rig_.unplug_at) return false;
  if (rig_.now_ < rig_.deaf_at) rig_.model_.receive({bytes, size}, rig_.now_);
  return true;
}

inline std::optional<char> SessionRig::wait(std::optional<int>, Time until) {
  do {
    now_ += std::chrono::milliseconds(1);
    model_.step(now_, [&](Time sent, ByteView frame) {
      if (sent < silent_at) line_.send(frame, sent);
    });
    line_.deliver(now_, [&](ByteView packet) {
      arrived_.insert(arrived_.end(), packet.begin(), packet.end());
    });
    if (!keys.empty() && keys.begin()->first <= now_) {
      return keys.extract(keys.begin()).mapped();
    }
  } while (arrived_.empty() && now_ < std::min({until, unplug_at, interrupt_at}));
  return std::nullopt;
}

inline std::optional<std::string> SessionRig::ask(const std::string& line) {
  std::istringstream words(line);
  std::string verb;
  words >> verb;
  if (verb == "set") set(words);
  const nlohmann::json state{{"outputs", model_.outputs().outputs.bits},
                             {"sounds", model_.outputs().sounds},
                             {"x", model_.pose().x_m},
                             {"y", model_.pose().y_m}};
  return state.dump();
}

inline void SessionRig::set(std::istringstream& words) {
  std::string word;
  words >> word;
  if (!refuses.empty() && word.rfind(refuses, 0) == 0) return;
  const std::string field = word.substr(0, word.find('='));
  const auto value = static_cast<std::uint8_t>(std::stoi(word.substr(word.find('=') + 1)));
  const std::map<std::string, std::uint8_t BaseInputs::*> fields{
      {"buttons", &BaseInputs::buttons},
      {"bumper", &BaseInputs::bumper},
      {"cliff", &BaseInputs::cliff},
      {"wheel_drop", &BaseInputs::wheel_drop}};
  model_.inputs().*fields.at(field) = value;
}

}  // namespace tocsin::kobuki
