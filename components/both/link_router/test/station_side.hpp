// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "link_router/stop_speaker.hpp"

namespace tocsin::router {

/// A station whose packets are numbered; keys come from a counter.
class StationSide {
 public:
  explicit StationSide(std::uint64_t router, std::string identity = "")
      : router_(router), identity_(std::move(identity)) {}
  void host(bool stands, Time now) { speaker.on_host(stands, now); }
  ReceivedStop said(Time now) {
    StopValue value;
    value.role = Role::gcs;
    value.host = "gcs" + std::to_string(router_);
    value.number = ++number;
    speaker.fill(value, now);
    if (value.stands) value.by = {"station"};
    return {value, router_, identity_, now};
  }
  StopSpeaker speaker{[this] {
    StopToken key{};
    key[0] = static_cast<std::uint8_t>(router_);
    key[1] = ++keys_;
    return key;
  }};
  std::uint64_t number = 0;

 private:
  std::uint64_t router_;
  std::string identity_;
  std::uint8_t keys_ = 0;
};

}  // namespace tocsin::router
