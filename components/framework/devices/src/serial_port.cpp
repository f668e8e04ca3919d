// SPDX-License-Identifier: Apache-2.0
#include "serial_port.hpp"

#include <fcntl.h>
#include <linux/serial.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "foundation/file_descriptor.hpp"
#include "line_speed.hpp"
#include "port_holder.hpp"

namespace tocsin {
namespace {

class SerialPort final : public SerialDevice {
 public:
  explicit SerialPort(FileDescriptor port) : port_(std::move(port)) {}
  ~SerialPort() override { ::ioctl(port_.get(), TIOCNXCL); }
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;

  std::optional<int> descriptor() const override { return port_.get(); }
  std::optional<std::size_t> read(std::uint8_t* to, std::size_t size) override {
    const auto count = ::read(port_.get(), to, size);
    if (count > 0) return static_cast<std::size_t>(count);
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) return 0;
    return std::nullopt;  // 0 is a hang-up: VMIN is 1
  }
  bool set_speed(unsigned baud) override { return set_line_speed(port_.get(), baud); }
  bool set_dtr(bool on) override {
    const int line = TIOCM_DTR;
    return ::ioctl(port_.get(), on ? TIOCMBIS : TIOCMBIC, &line) == 0;
  }
  bool write(const std::uint8_t* bytes, std::size_t size) override {
    const auto count = ::write(port_.get(), bytes, size);
    return count >= 0 || errno == EAGAIN || errno == EINTR;
  }

 private:
  FileDescriptor port_;
};

bool lock(int fd) {
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  return ::flock(fd, LOCK_EX | LOCK_NB) == 0 && ::fcntl(fd, F_SETLK, &whole) == 0 &&
         ::ioctl(fd, TIOCEXCL) == 0;
}

/// False when the device is no terminal.
bool configure(int fd) {
  termios settings{};
  if (::tcgetattr(fd, &settings) != 0) return false;
  ::cfmakeraw(&settings);
  ::cfsetspeed(&settings, B115200);
  settings.c_cflag |= CLOCAL | CREAD;
  settings.c_cflag &= ~static_cast<tcflag_t>(CRTSCTS | CSTOPB);
  settings.c_cc[VMIN] = 1;
  settings.c_cc[VTIME] = 0;
  return ::tcsetattr(fd, TCSANOW, &settings) == 0 && ::tcflush(fd, TCIOFLUSH) == 0;
}

/// An FT232R's latency timer to 1 ms instead of 16; other devices refuse, which does no harm.
void ask_for_low_latency(int fd) {
  serial_struct settings{};
  if (::ioctl(fd, TIOCGSERIAL, &settings) != 0) return;
  settings.flags |= ASYNC_LOW_LATENCY;
  ::ioctl(fd, TIOCSSERIAL, &settings);
}

OpenedSerial busy(const std::string& path) {
  const auto holder = holder_of(path);
  return {OpenedSerial::Result::busy, path + " is in use by " + holder.value_or("another process"),
          holder.has_value()};
}

OpenedSerial absent(const std::string& path, const std::string& why) {
  return {OpenedSerial::Result::absent, path + ": " + why};
}

}  // namespace

OpenedSerial open_serial_port(const std::string& path) {
  FileDescriptor file(::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!file && errno == EBUSY) return busy(path);
  if (!file) return absent(path, std::strerror(errno));
  if (::isatty(file.get()) == 0) return absent(path, "is not a serial port");
  if (!lock(file.get())) return busy(path);
  const int descriptor = file.get();
  auto port = std::make_unique<SerialPort>(std::move(file));  // its end gives up what is locked
  if (!configure(descriptor)) return absent(path, "cannot be set to 115200 baud");
  ask_for_low_latency(descriptor);
  return port;
}

}  // namespace tocsin
