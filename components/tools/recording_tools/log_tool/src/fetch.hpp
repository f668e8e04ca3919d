// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "foundation/time.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin::log_tool {

/// One request for a log, from the first asking to its end. Pure.
class Fetch {
 public:
  using State = tocsin_msgs::msg::LinkState;

  explicit Fetch(const tocsin_msgs::msg::LogRequest& request) : request_(request) {}

  [[nodiscard]] const tocsin_msgs::msg::LogRequest& request() const { return request_; }
  /// Whether it is to be said again.
  [[nodiscard]] bool has_to_ask(Time now);
  void on_state(const State& state, Time now);
  /// All routers that log the topic have said that nothing more comes.
  [[nodiscard]] bool is_done() const;
  /// Samples that were found and given so far.
  [[nodiscard]] std::uint64_t found() const;
  [[nodiscard]] std::uint64_t delivered() const;
  /// Those that the log had no more.
  [[nodiscard]] std::uint64_t gone() const;
  /// For people, when it has changed since the last call; else empty.
  [[nodiscard]] std::string news(Time now);

 private:
  using Progress = tocsin_msgs::msg::LogFetch;
  [[nodiscard]] std::uint64_t sum(std::uint64_t (Progress::*count)() const) const;

  const tocsin_msgs::msg::LogRequest request_;
  Time asked_{};
  Time heard_{};
  std::map<std::string, Progress> progress_;  ///< by role
  std::string told_;
};

}  // namespace tocsin::log_tool
