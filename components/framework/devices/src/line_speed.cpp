// SPDX-License-Identifier: Apache-2.0
// Apart from serial_port.cpp: the kernel's termios2 and the C library's termios exclude each other.
#include "line_speed.hpp"

#include <asm/termbits.h>
#include <sys/ioctl.h>

namespace tocsin {

bool set_line_speed(int descriptor, unsigned baud) {
  termios2 settings{};
  if (::ioctl(descriptor, TCGETS2, &settings) != 0) return false;
  settings.c_cflag &= ~static_cast<tcflag_t>(CBAUD);
  settings.c_cflag |= BOTHER;
  settings.c_ispeed = baud;
  settings.c_ospeed = baud;
  return ::ioctl(descriptor, TCSETS2, &settings) == 0;
}

}  // namespace tocsin
