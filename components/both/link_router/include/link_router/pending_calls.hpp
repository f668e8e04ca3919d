// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "foundation/time.hpp"

namespace tocsin::router {

/// Calls that wait for something until their deadline: for a reply, or for a server. The thousand
/// newest are kept; an older one is over as if its deadline had come. Pure.
template <class Key, class What>
class PendingCalls {
 public:
  static constexpr std::size_t most = 1000;
  struct Call {
    std::string service;
    What what;
    Time deadline;
  };

  /// In the place of one of this key, if there is one.
  void add(const Key& key, Call call) {
    take(key);
    order_.push_back(key);
    calls_.emplace(key, std::move(call));
  }
  /// It is over. Nothing when it was before.
  std::optional<Call> take(const Key& key) {
    const auto found = calls_.find(key);
    if (found == calls_.end()) return std::nullopt;
    Call call = std::move(found->second);
    calls_.erase(found);
    order_.erase(std::find(order_.begin(), order_.end(), key));
    return call;
  }
  /// Those that are over without having been taken.
  [[nodiscard]] std::vector<Call> take_expired(Time now) {
    std::vector<Key> over;
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const bool makes_room = i + most < order_.size();
      if (makes_room || calls_.at(order_[i]).deadline <= now) over.push_back(order_[i]);
    }
    std::vector<Call> expired;
    for (const Key& key : over) expired.push_back(*take(key));
    return expired;
  }
  /// When the next one is over; `never` without any.
  [[nodiscard]] Time deadline() const {
    Time next = never;
    for (const auto& entry : calls_) next = std::min(next, entry.second.deadline);
    return next;
  }
  /// In the order of `add`.
  [[nodiscard]] const std::vector<Key>& keys() const { return order_; }
  [[nodiscard]] const Call& of(const Key& key) const { return calls_.at(key); }

 private:
  std::vector<Key> order_;
  std::map<Key, Call> calls_;
};

}  // namespace tocsin::router
