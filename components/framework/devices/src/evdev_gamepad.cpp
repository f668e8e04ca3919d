// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <libevdev/libevdev.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <vector>

#include "evdev_gamepad.hpp"

namespace tocsin {
namespace {

namespace fs = std::filesystem;

struct Closer {
  void operator()(libevdev* device) const {
    const int descriptor = libevdev_get_fd(device);
    libevdev_free(device);
    ::close(descriptor);
  }
};
using Evdev = std::unique_ptr<libevdev, Closer>;

class EvdevGamepad final : public GamepadDevice {
 public:
  explicit EvdevGamepad(Evdev device) : device_(std::move(device)) {}
  [[nodiscard]] std::optional<int> descriptor() const override {
    return libevdev_get_fd(device_.get());
  }
  [[nodiscard]] std::string name() const override { return libevdev_get_name(device_.get()); }

  [[nodiscard]] PadAxes axes() const override {
    PadAxes axes;
    for (unsigned code = 0; code < ABS_CNT; ++code) {
      const input_absinfo* info = libevdev_get_abs_info(device_.get(), code);
      if (info != nullptr) axes[static_cast<std::uint16_t>(code)] = {info->minimum, info->maximum};
    }
    return axes;
  }

  [[nodiscard]] Read read(PadEvent& event) override {
    input_event raw{};
    const unsigned mode = resyncing_ ? LIBEVDEV_READ_FLAG_SYNC : LIBEVDEV_READ_FLAG_NORMAL;
    const int result = libevdev_next_event(device_.get(), mode, &raw);
    if (result == -EAGAIN) return resyncing_ ? end_resync(event) : Read::nothing;
    if (result < 0) return Read::lost;
    resyncing_ = result == LIBEVDEV_READ_STATUS_SYNC;
    event = {raw.type, raw.code, raw.value};
    return Read::event;
  }

 private:
  /// All differences after lost events have been told; the next read is a common one.
  [[nodiscard]] Read end_resync(PadEvent& event) {
    resyncing_ = false;
    return read(event);
  }

  Evdev device_;
  bool resyncing_ = false;
};

Evdev open_device(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return nullptr;
  libevdev* device = nullptr;
  if (libevdev_new_from_fd(descriptor, &device) == 0) return Evdev(device);
  ::close(descriptor);
  return nullptr;
}

bool has(const Evdev& device, unsigned type, unsigned code) {
  return libevdev_has_event_code(device.get(), type, code) == 1;
}

/// A stick, and buttons of a gamepad or joystick; a mouse, tablet or motion sensor has not both.
bool is_gamepad(const Evdev& device) {
  return has(device, EV_ABS, ABS_X) && has(device, EV_ABS, ABS_Y) &&
         (has(device, EV_KEY, BTN_GAMEPAD) || has(device, EV_KEY, BTN_JOYSTICK));
}

std::vector<std::string> event_devices() {
  std::vector<std::string> paths;
  std::error_code absent;
  for (const auto& entry : fs::directory_iterator("/dev/input", absent)) {
    if (entry.path().filename().string().rfind("event", 0) == 0) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace

std::unique_ptr<GamepadDevice> open_evdev_gamepad(const std::string& path) {
  const auto paths = path.empty() ? event_devices() : std::vector<std::string>{path};
  for (const std::string& candidate : paths) {
    Evdev device = open_device(candidate);
    if (device && is_gamepad(device)) return std::make_unique<EvdevGamepad>(std::move(device));
  }
  return nullptr;
}

}  // namespace tocsin
