// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "link_router/link_router_params.hpp"
#include "link_router/linked_peers.hpp"
#include "link_router/transmission.hpp"

namespace tocsin::router {

/// What an adaptive stream's source may send.
struct StreamBudget {
  StreamId stream = 0;
  double bytes_per_s = 0;  ///< serialised
  double scale = 1;        ///< [0.25, 1] of what it would like to send
  bool hold = false;       ///< skip: what was sent before still waits
};

/// Bytes per second: mean with exponential weights, memory 2 s.
class RateMeter {
 public:
  void add(std::size_t bytes, Time now);
  [[nodiscard]] double bytes_per_s(Time now) const;

 private:
  static constexpr Duration memory = std::chrono::seconds(2);
  double sum_ = 0;
  Time at_{};
};

/// How much the adaptive streams may send: smooth, fast to fall, slow to rise, and reported in
/// steps, so that a source is not bothered by noise. Pure; `now` never decreases.
class AdaptiveScale {
 public:
  explicit AdaptiveScale(const LinkRouterParams& params) : params_(params) {}

  struct Input {
    double capacity_bytes_per_s = 0;
    double others_bytes_per_s = 0;  ///< what streams that do not adapt take
    /// What a share of the air carries of all that waits for the radio.
    double share_bytes_per_s = std::numeric_limits<double>::infinity();
    double nominal_bytes_per_s = 0;  ///< what adaptive streams would take at scale 1
    bool silent = false;             ///< no peer acknowledges anything
  };
  void update(const Input& input, Time now);
  /// The next update does not smooth a fall: another path, another capacity.
  void fall_at_once() { falls_at_once_ = true; }
  /// [scale_min, 1]
  [[nodiscard]] double scale() const { return reported_; }
  /// Whether it would be larger without the share of the air.
  [[nodiscard]] bool is_bound_by_share() const { return bound_by_share_; }

 private:
  [[nodiscard]] double target(const Input& input);
  LinkRouterParams params_;
  double smooth_ = 1;
  bool falls_at_once_ = false;
  double reported_ = 1;
  bool bound_by_share_ = false;
  std::optional<Time> updated_;
};

/// The budgets of adaptive streams: what they would take at scale 1, what the others take, and the
/// scale that follows. Pure; `now` never decreases.
class LinkAdaptation {
 public:
  explicit LinkAdaptation(const LinkRouterParams& params) : scale_(params) {}

  /// An adaptive stream. Of others nothing is measured but on_other().
  void add_stream(StreamId stream) { streams_[stream]; }
  void forget_stream(StreamId stream) { streams_.erase(stream); }
  /// A sample was offered. Of streams that were not added nothing is noted.
  void on_offered(StreamId stream, const WireCost& cost, Time now);
  /// A sample of a stream that does not adapt goes on the wire.
  void on_other(const WireCost& cost, Time now) { others_.add(cost.bytes, now); }
  /// Updates the scale, every 50 ms at most.
  void follow(const LinkedPeers& peers, Time now);

  /// Samples go by another path from now on.
  void on_other_path() { scale_.fall_at_once(); }

  [[nodiscard]] double scale() const { return scale_.scale(); }
  [[nodiscard]] bool is_bound_by_share() const { return scale_.is_bound_by_share(); }
  /// Of each adaptive stream. `holds`: whether its source shall skip.
  [[nodiscard]] std::vector<StreamBudget> budgets(const std::function<bool(StreamId)>& holds) const;

 private:
  struct Stream {
    RateMeter nominal;            ///< what it would take at scale 1
    double peak_bytes_per_s = 0;  ///< of nominal, forgotten slowly
    Time offered = Time::min();
  };
  std::map<StreamId, Stream> streams_;
  AdaptiveScale scale_;
  RateMeter others_;
  Time updated_ = Time::min();
};

}  // namespace tocsin::router
