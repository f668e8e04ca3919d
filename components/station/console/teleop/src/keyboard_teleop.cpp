// SPDX-License-Identifier: Apache-2.0
#include "teleop_keyboard/keyboard_teleop.hpp"

#include <algorithm>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

/// What a letter does: drive (forward, left) or change the speeds (steps up or down).
struct Letter {
  char key;
  int first;
  int second;
};

constexpr Letter wasd_drive[] = {{'w', 1, 0}, {'s', -1, 0}, {'a', 0, 1},   {'d', 0, -1},
                                 {'q', 1, 1}, {'e', 1, -1}, {'z', -1, -1}, {'c', -1, 1}};
constexpr Letter wasd_speed[] = {{'+', 1, 1},  {'-', -1, -1}, {'r', 1, 0},
                                 {'f', -1, 0}, {'t', 0, 1},   {'g', 0, -1}};
// As in turtlebot_teleop and teleop_twist_keyboard.
constexpr Letter turtlebot_drive[] = {{'i', 1, 0}, {',', -1, 0}, {'j', 0, 1},   {'l', 0, -1},
                                      {'u', 1, 1}, {'o', 1, -1}, {'m', -1, -1}, {'.', -1, 1}};
constexpr Letter turtlebot_speed[] = {{'q', 1, 1},  {'z', -1, -1}, {'w', 1, 0},
                                      {'x', -1, 0}, {'e', 0, 1},   {'c', 0, -1}};

template <std::size_t size>
const Letter* find(const Letter (&letters)[size], char key) {
  const auto* found = std::find_if(std::begin(letters), std::end(letters),
                                   [&](const Letter& letter) { return letter.key == key; });
  return found == std::end(letters) ? nullptr : found;
}

char lower(char key) {
  return key >= 'A' && key <= 'Z' ? static_cast<char>(key + ('a' - 'A')) : key;
}

double stepped(double value, int steps, double factor, double greatest) {
  if (steps > 0) value *= factor;
  if (steps < 0) value /= factor;
  return std::min(value, greatest);
}

bool same(const Key& a, const Key& b) { return a.kind == b.kind && a.character == b.character; }

std::optional<KeyboardTeleop::ControlKey> control_of(const Key& key) {
  if (key.kind != Key::Kind::character) return std::nullopt;
  switch (key.character) {
    case 'h':
      return KeyboardTeleop::ControlKey::hand_over;
    case 'H':
      return KeyboardTeleop::ControlKey::take;
    case 'n':
      return KeyboardTeleop::ControlKey::keep;
    default:
      return std::nullopt;
  }
}

void require(const char* name, double value, double greatest) {
  if (value <= greatest) return;
  throw ConfigError("teleop_keyboard." + std::string(name) + ": " + std::to_string(value) +
                    " is above its maximum of " + std::to_string(greatest));
}

}  // namespace

KeyboardTeleop::KeyboardTeleop(const Params& params) : params_(params) {
  require("linear_mps", params.linear_mps, params.linear_max_mps);
  require("angular_rad_s", params.angular_rad_s, params.angular_max_rad_s);
}

void KeyboardTeleop::on_bytes(std::string_view bytes, Time now) {
  for (const char byte : bytes) {
    if (const auto key = reader_.on_byte(byte)) on_key(*key, now);
  }
}

void KeyboardTeleop::on_key(const Key& key, Time now) {
  if (const auto control = control_of(key)) {
    control_key_ = control;
    return;
  }
  if (const auto direction = direction_of(key)) {
    press(key, *direction, now);
  } else if (key.kind != Key::Kind::character || !change_speed(lower(key.character))) {
    held_.reset();
  }
}

void KeyboardTeleop::press(const Key& key, const Direction& direction, Time now) {
  const bool repeats = held_ && same(held_->key, key) && now < held_->until;
  const double wait_s = repeats ? params_.repeat_period_s : params_.repeat_delay_s;
  held_ = Held{key, direction, now, now + seconds(wait_s)};
}

std::optional<KeyboardTeleop::Direction> KeyboardTeleop::direction_of(const Key& key) const {
  switch (key.kind) {
    case Key::Kind::up:
      return Direction{1, 0};
    case Key::Kind::down:
      return Direction{-1, 0};
    case Key::Kind::left:
      return Direction{0, 1};
    case Key::Kind::right:
      return Direction{0, -1};
    case Key::Kind::other:
      return std::nullopt;
    case Key::Kind::character:
      break;
  }
  const char letter = lower(key.character);
  const Letter* found = is_turtlebot() ? find(turtlebot_drive, letter) : find(wasd_drive, letter);
  if (found == nullptr) return std::nullopt;
  return Direction{static_cast<double>(found->first), static_cast<double>(found->second)};
}

bool KeyboardTeleop::change_speed(char key) {
  const Letter* found = is_turtlebot() ? find(turtlebot_speed, key) : find(wasd_speed, key);
  if (found == nullptr) return false;
  params_.linear_mps =
      stepped(params_.linear_mps, found->first, params_.step, params_.linear_max_mps);
  params_.angular_rad_s =
      stepped(params_.angular_rad_s, found->second, params_.step, params_.angular_max_rad_s);
  return true;
}

geometry::Twist KeyboardTeleop::velocity(Time now) const {
  if (!held_ || now >= held_->until) return {};
  return {held_->direction.linear * params_.linear_mps,
          held_->direction.angular * params_.angular_rad_s};
}

Time KeyboardTeleop::next_deadline(Time now) const {
  return held_ && now < held_->until ? held_->until : never;
}

std::string KeyboardTeleop::help() const {
  if (is_turtlebot()) {
    return "  u i o    q z  both speeds up, down\n"
           "  j k l    w x  speed\n"
           "  m , .    e c  turn rate\n"
           "arrows too; k, space or any other key stops; h, H, n: control among several; Ctrl-C "
           "ends\n";
  }
  return "  q w e    + -  both speeds up, down\n"
         "  a s d    r f  speed\n"
         "  z   c    t g  turn rate\n"
         "arrows too; space or any other key stops; h, H, n: control among several; Ctrl-C ends\n";
}

}  // namespace tocsin
