// SPDX-License-Identifier: Apache-2.0
#include "feeder.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

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
    const kobuki::Frame frame = frame_number(i);
    sent_ns_ = now_ns();
    if (::write(master_, frame.bytes().data, frame.bytes().size) < 0) continue;  // nobody reads
  }
}

}  // namespace tocsin::bench
