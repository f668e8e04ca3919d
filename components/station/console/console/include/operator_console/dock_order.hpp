// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "foundation/time.hpp"
#include "operator_console/order_result.hpp"

namespace tocsin {

/// Starts docking and follows it to its end, or cancels it. Pure; `now` must not decrease.
class DockOrder {
 public:
  enum class Wish { start, cancel, status };
  struct Status {
    std::uint32_t run = 0;
    std::string state;
    std::string result;
    double elapsed_s = 0;
  };

  /// Nothing heard until `wait` is over is a failure; so is as long a silence later.
  DockOrder(Wish wish, Time now, Duration wait) : wish_(wish), wait_(wait), deadline_(now + wait) {}
  /// A line to show, when there is news.
  [[nodiscard]] std::optional<std::string> on_status(const Status& status, Time now);
  /// The command to send, now and again; null when there is none (any more).
  [[nodiscard]] const char* command() const;
  [[nodiscard]] std::optional<OrderResult> result(Time now) const;

 private:
  [[nodiscard]] bool running() const;
  Wish wish_;
  Duration wait_;
  Time deadline_;
  std::optional<Status> status_;
  std::uint32_t first_run_ = 0;
  bool started_ = false;  ///< the run that was asked for has begun
};

}  // namespace tocsin
