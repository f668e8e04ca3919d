// SPDX-License-Identifier: Apache-2.0
#include "session.hpp"

#include <algorithm>
#include <array>

#include "foundation/error.hpp"

namespace tocsin::kobuki {
namespace {

constexpr Duration silence = std::chrono::seconds(3);

}  // namespace

Session::Session(std::unique_ptr<SerialDevice> port, std::string name, EventWait& wait)
    : port_(std::move(port)), name_(std::move(name)), wait_(wait), heard_(wait.now()) {
  driver_.on_port_open();
}

Session::~Session() {
  if (loss_ != Loss::port) driver_.farewell([this](ByteView bytes) { send(bytes); });
}

std::optional<char> Session::key() {
  const auto pressed = key_;
  key_.reset();
  return pressed;
}

void Session::lose(Loss loss) {
  if (loss_ != Loss::none) return;
  loss_ = loss;
  if (loss == Loss::port) driver_.on_port_lost();
}

void Session::check() const {
  if (loss_ == Loss::port) throw EnvironmentError(name_ + ": the port was lost: is its cable out?");
  if (loss_ != Loss::frames) return;
  throw EnvironmentError(name_ + (last() == nullptr ? ": no base is sending there"
                                                    : ": no frame for 3 s: is the base off?"));
}

void Session::send(ByteView bytes) {
  if (!port_->write(bytes.data, bytes.size)) lose(Loss::port);
}

void Session::read(Time now) {
  std::array<std::uint8_t, 1024> bytes{};
  const auto count = port_->read(bytes.data(), bytes.size());
  if (!count) return lose(Loss::port);
  driver_.on_bytes({bytes.data(), *count}, now, [&](const Reading& reading) {
    last_ = reading;
    ++readings_;
    heard_ = now;
    sink_(reading);
  });
  if (now - heard_ > silence) lose(Loss::frames);
}

void Session::turn(Time until) {
  if (const auto pressed = wait_.wait(port_->descriptor(), until)) key_ = pressed;
  read(now());
  driver_.run(now(), [this](ByteView bytes) { send(bytes); });
}

bool Session::run_until(const std::function<bool()>& done, Duration limit) {
  const Time end = now() + limit;
  while (!done()) {
    if (over() || key_ || now() >= end) return false;
    turn(std::min(end, driver_.next_deadline()));
  }
  return true;
}

void Session::run_for(Duration duration) {
  (void)run_until([] { return false; }, duration);
}

bool Session::hears_base() {
  const std::uint64_t before = readings_;
  while (!over() && readings_ == before) turn(heard_ + silence + Duration{1});
  return readings_ > before;
}

}  // namespace tocsin::kobuki
