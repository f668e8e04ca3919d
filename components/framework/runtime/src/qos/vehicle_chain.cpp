// SPDX-License-Identifier: Apache-2.0
#include "qos/vehicle_chain.hpp"

#include <algorithm>
#include <string_view>

namespace tocsin {
namespace {

bool begins_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

}  // namespace

bool is_of_chain(const std::string& topic) {
  if (ends_with(topic, "/backfilled")) return false;
  return begins_with(topic, "cmd_vel/") || begins_with(topic, "commands/") ||
         std::find(chain_topics.begin(), chain_topics.end(), topic) != chain_topics.end();
}

}  // namespace tocsin
