// SPDX-License-Identifier: Apache-2.0
#include "feeder.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>

#include "foundation/error.hpp"
#include "kobuki_protocol/feedback.hpp"
#include "measure.hpp"

namespace tocsin::bench {
namespace {

kobuki::Frame frame_number(int i) {
  kobuki::Feedback feedback;
  kobuki::CoreSensors core;
  core.timestamp_ms = static_cast<std::uint16_t>(20 * i);
  core.left_encoder = static_cast<std::uint16_t>(40 * i);
  core.right_encoder = static_cast<std::uint16_t>(41 * i);
  core.battery_dv = 160;
  feedback.core = core;
  feedback.dock_infrared = kobuki::DockInfrared{};
  feedback.inertia = kobuki::Inertia{};
  feedback.cliff_adc = kobuki::CliffAdc{1800, 1800, 1800};
  feedback.current = kobuki::MotorCurrent{};
  kobuki::RawGyro gyro;
  gyro.count = 2;
  feedback.gyro = gyro;
  feedback.input = kobuki::GeneralInput{};
  return kobuki::encode_feedback(feedback);
}

}  // namespace

Feeder::Feeder() : master_(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK)) {
  if (master_ < 0 || ::grantpt(master_) != 0 || ::unlockpt(master_) != 0) {
    throw EnvironmentError("no pseudo-terminal");
  }
  termios raw{};
  ::tcgetattr(master_, &raw);
  ::cfmakeraw(&raw);
  ::tcsetattr(master_, TCSANOW, &raw);
  path_ = ::ptsname(master_);
  thread_ = std::thread([this] { run(); });
}

Feeder::~Feeder() {
  over_ = true;
  thread_.join();
  ::close(master_);
}

void Feeder::run() {
  auto next = std::chrono::steady_clock::now();
  for (int i = 0; !over_; ++i) {
    next += std::chrono::milliseconds(20);
    std::this_thread::sleep_until(next);
    char commands[512];
    while (::read(master_, commands, sizeof commands) > 0) continue;
    send(frame_number(i).bytes());
  }
}

void Feeder::send(ByteView frame) {
  constexpr std::size_t portion = 11;  // bytes of a millisecond at 115200 baud
  for (std::size_t at = 0; at < frame.size; at += portion) {
    const std::size_t count = std::min(portion, frame.size - at);
    if (at > 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    sent_ns_ = now_ns();
    if (::write(master_, frame.data + at, count) < 0) return;  // nobody reads
  }
}

}  // namespace tocsin::bench
