// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <memory>

#include "link/flow_ends.hpp"
#include "runtime/middleware/link_bus.hpp"

namespace tocsin {

/// The readers of flows, one for all flows of a ReaderKey. A reader outlives its flows, since what
/// was restarted is heard at once by a reader that is there; of such idle readers the last few
/// stay. One thread.
class FlowReaders {
 public:
  using Make = std::function<std::unique_ptr<FlowReader>(const ReaderKey&)>;
  static constexpr std::size_t most_idle = 64;

  explicit FlowReaders(Make make) : make_(std::move(make)) {}
  /// May throw what `make` throws; then the flow has none. Again changes nothing.
  void add(FlowId flow, const ReaderKey& key);
  void remove(FlowId flow);
  /// The same, and its reader goes at once when it is no other flow's.
  void drop(FlowId flow);
  /// Makes its reader anew; throws what `make` throws, and then it has the one before.
  void renew(FlowId flow);
  [[nodiscard]] std::size_t size() const { return readers_.size(); }

 private:
  struct Entry {
    std::unique_ptr<FlowReader> reader;
    std::size_t flows = 0;
  };
  using Readers = std::map<ReaderKey, Entry>;

  const Make make_;
  Readers readers_;
  std::map<FlowId, ReaderKey> by_flow_;
  std::deque<ReaderKey> idle_;  ///< in the order in which they became so
};

}  // namespace tocsin
