// SPDX-License-Identifier: Apache-2.0
#include "laser_terminal.hpp"

#include <array>
#include <utility>

namespace tocsin::kobuki {

LaserTerminal::LaserTerminal(const Params& params, std::shared_ptr<const laser::Scene> scene,
                             std::uint64_t seed, Time now)
    : terminal_(params.link),
      laser_(laser::find_laser_profile(params.profile), std::move(scene), params.mount, seed, now) {
}

Time LaserTerminal::next_event() const { return is_plugged_ ? laser_.next_event() : never; }

bool LaserTerminal::step(const BaseModel& base, Time now) {
  if (!is_plugged_) return false;
  std::array<std::uint8_t, 64> bytes{};
  while (const std::size_t count = terminal_.receive(bytes.data(), bytes.size())) {
    laser_.receive({bytes.data(), count}, now);
  }
  laser_.step({base.pose(), base.velocity()}, now, [this](ByteView sent) { terminal_.send(sent); });
  const bool is_in_use = terminal_.in_use();
  if (!std::exchange(was_in_use_, is_in_use) || is_in_use) return false;
  terminal_.renew();  // exclusive use by who has left would lock everybody out
  return true;
}

std::string LaserTerminal::obey(const std::string& verb, Time now) {
  if (verb == "unplug" && std::exchange(is_plugged_, false)) {
    terminal_.remove();
  } else if (verb == "plug" && !std::exchange(is_plugged_, true)) {
    was_in_use_ = true;  // a fresh terminal with the next step
  } else if (verb == "stall" || verb == "free") {
    laser_.device().stall(verb == "stall", now);
  } else if (verb == "cover" || verb == "uncover") {
    laser_.cover(verb == "cover");
  } else if (verb == "stick" || verb == "loosen") {
    laser_.stick(verb == "stick");
  } else if (verb != "plug" && verb != "unplug") {
    return "error: laser unplug|plug|stall|free|cover|uncover|stick|loosen";
  }
  return "ok";
}

}  // namespace tocsin::kobuki
