// SPDX-License-Identifier: Apache-2.0
#include "velocity_mux/velocity_mux.hpp"

#include <algorithm>
#include <set>
#include <sstream>
#include <utility>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

void check(const std::vector<MuxInput>& inputs) {
  if (inputs.empty()) throw ConfigError("velocity_mux.inputs: must name at least one");
  std::set<std::string> names;
  std::set<int> priorities;
  for (const MuxInput& input : inputs) {
    const std::string place = "velocity_mux.inputs." + input.name;
    if (!names.insert(input.name).second) throw ConfigError(place + ": is there twice");
    if (!priorities.insert(input.priority).second) {
      throw ConfigError(place + ".priority: " + std::to_string(input.priority) +
                        " is taken by another input");
    }
    if (!(input.timeout_s > 0 && input.timeout_s <= 60)) {
      throw ConfigError(place + ".timeout_s: must be greater than 0, at most 60");
    }
  }
}

MuxInput parse_input(const std::string& text) {
  std::istringstream words(text);
  MuxInput input;
  std::string rest;
  if (words >> input.name >> input.priority >> input.timeout_s && !(words >> rest)) return input;
  throw ConfigError("velocity_mux.inputs: '" + text + "' is not: name priority timeout_s");
}

}  // namespace

std::vector<MuxInput> parse_inputs(const std::string& text) {
  std::vector<MuxInput> inputs;
  std::istringstream items(text);
  for (std::string item; std::getline(items, item, ',');) inputs.push_back(parse_input(item));
  check(inputs);
  return inputs;
}

std::string to_text(const std::vector<MuxInput>& inputs) {
  std::ostringstream text;
  for (const MuxInput& input : inputs) {
    if (text.tellp() > 0) text << ", ";
    text << input.name << ' ' << input.priority << ' ' << input.timeout_s;
  }
  return text.str();
}

void VelocityMux::on_emergency_stop(bool pressed) {
  stopped_ = pressed;
  if (stopped_ && active_) active_->timeout_s = 0;
}

void VelocityMux::set_inputs(std::vector<MuxInput> inputs) {
  check(inputs);
  inputs_ = std::move(inputs);
  if (!active_) return;
  const MuxInput* kept = find(active_->name);
  if (kept != nullptr) {
    active_ = *kept;
  } else {
    active_->timeout_s = 0;  // it was removed: its turn ends now, with a zero
  }
}

const MuxInput* VelocityMux::find(const std::string& name) const {
  const auto found = std::find_if(inputs_.begin(), inputs_.end(),
                                  [&](const MuxInput& input) { return input.name == name; });
  return found == inputs_.end() ? nullptr : &*found;
}

std::optional<geometry::Twist> VelocityMux::on_command(const std::string& name,
                                                       const geometry::Twist& velocity, Time now) {
  const MuxInput* input = find(name);
  if (input == nullptr || stopped_) return std::nullopt;
  const bool blocked = active_ && !expired(now) && active_->priority > input->priority;
  if (blocked) return std::nullopt;
  active_ = *input;
  last_ = now;
  return velocity;
}

std::optional<geometry::Twist> VelocityMux::on_time(Time now) {
  if (!expired(now)) return std::nullopt;
  active_.reset();
  return geometry::Twist{};
}

Time VelocityMux::next_deadline() const {
  return active_ ? last_ + seconds(active_->timeout_s) : never;
}

}  // namespace tocsin
