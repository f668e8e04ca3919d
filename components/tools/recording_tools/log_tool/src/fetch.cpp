// SPDX-License-Identifier: Apache-2.0
#include "fetch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace tocsin::log_tool {
namespace {

constexpr Duration ask_period = std::chrono::seconds(1);
constexpr Duration silence = std::chrono::seconds(5);

}  // namespace

bool Fetch::has_to_ask(Time now) {
  if (asked_ != Time{} && now - asked_ < ask_period) return false;
  if (asked_ == Time{}) heard_ = now;
  asked_ = now;
  return true;
}

void Fetch::on_state(const State& state, Time now) {
  for (const Progress& one : state.fetches()) {
    if (one.id() != request_.id()) continue;
    progress_[state.role()] = one;
    heard_ = now;
  }
}

bool Fetch::is_done() const {
  return !progress_.empty() && std::all_of(progress_.begin(), progress_.end(), [](const auto& one) {
    return one.second.state() == "done";
  });
}

std::uint64_t Fetch::sum(std::uint64_t (Progress::*count)() const) const {
  std::uint64_t all = 0;
  for (const auto& entry : progress_) all += (entry.second.*count)();
  return all;
}

std::uint64_t Fetch::found() const { return sum(&Progress::found); }
std::uint64_t Fetch::delivered() const { return sum(&Progress::delivered); }
std::uint64_t Fetch::gone() const { return sum(&Progress::gone); }

std::string Fetch::news(Time now) {
  std::string text;
  if (now - heard_ > silence) {
    text = fmt::format("no word of the log for {} s",
                       std::chrono::duration_cast<std::chrono::seconds>(now - heard_).count());
  } else if (!progress_.empty()) {
    text = fmt::format("{} of {} samples have crossed", delivered(), found());
  }
  if (text == std::exchange(told_, text)) return "";
  return text;
}

}  // namespace tocsin::log_tool
