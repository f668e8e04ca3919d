// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "operator_server/server_message.hpp"

namespace tocsin::foxglove {

/// What may wait for one client.
struct OutboxLimits {
  std::size_t backlog = 2;  ///< >= 1, messages of a subscription
  /// [byte] of data; beyond it only the newest message of each subscription waits.
  std::size_t data_bytes = std::size_t{4} << 20U;
  std::size_t control_bytes = std::size_t{8} << 20U;  ///< [byte] of all else
};

/// What waits to be sent to one client. Data makes room: of each subscription the newest messages
/// are kept, what was dropped is counted. All else is kept, until the client has to go. Of the
/// subscriptions each sends in turn, so that a big one does not starve the small ones. Pure.
class Outbox {
 public:
  explicit Outbox(const OutboxLimits& limits) : limits_(limits) {}

  void add_control(Frame frame);
  void add_data(std::uint32_t subscription, Frame frame);
  /// In place of an earlier one that still waits.
  void set_time(Frame frame) { time_ = std::move(frame); }
  /// Forgets what waits of a subscription.
  void forget(std::uint32_t subscription);

  /// What goes next: control, time, then data in turn; frames of about `bytes` together, at least
  /// one when anything waits.
  [[nodiscard]] std::vector<Frame> take(std::size_t bytes);
  [[nodiscard]] bool empty() const;
  /// More control waits than may: this client does not read.
  [[nodiscard]] bool overflown() const { return control_bytes_ > limits_.control_bytes; }
  [[nodiscard]] std::size_t bytes() const { return data_bytes_ + control_bytes_; }

  /// By subscription, messages that were dropped since the last call.
  [[nodiscard]] std::map<std::uint32_t, std::uint64_t> take_drops();

 private:
  void drop_oldest(std::uint32_t subscription);
  [[nodiscard]] std::optional<Frame> next();

  const OutboxLimits limits_;
  std::deque<Frame> control_;
  std::size_t control_bytes_ = 0;
  std::optional<Frame> time_;
  std::map<std::uint32_t, std::deque<Frame>> data_;  ///< none is empty
  std::deque<std::uint32_t> turns_;                  ///< the subscriptions of data_
  std::size_t data_bytes_ = 0;
  std::map<std::uint32_t, std::uint64_t> drops_;
};

}  // namespace tocsin::foxglove
