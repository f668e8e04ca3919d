// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "link_router/link_queue.hpp"
#include "link_router/transmission.hpp"

namespace tocsin::router {

/// While it is paused, streams that are not `send` are silent: the newest sample of each of their
/// sources waits here, or all are dropped. Pure.
class LinkGate {
 public:
  [[nodiscard]] bool is_paused() const { return paused_; }
  void set_paused(bool paused) { paused_ = paused; }
  [[nodiscard]] bool stops(WhilePaused rule) const { return paused_ && rule != WhilePaused::send; }

  /// A sample of a stream that it stops. Returns what is dropped for it, if anything.
  [[nodiscard]] std::optional<Waiting> hold(WhilePaused rule, const Waiting& waiting);
  /// Takes out what waits of a stream, by source.
  [[nodiscard]] std::vector<Waiting> take_stream(StreamId stream);

  struct Held {
    std::size_t samples = 0;
    std::size_t bytes = 0;  ///< serialised
  };
  [[nodiscard]] Held held(StreamId stream) const;

 private:
  bool paused_ = false;
  std::map<std::pair<StreamId, SourceId>, Waiting> held_;
};

}  // namespace tocsin::router
