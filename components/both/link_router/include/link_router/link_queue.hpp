// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <list>
#include <optional>
#include <vector>

#include "link_router/transmission.hpp"

namespace tocsin::router {

/// A sample that waits in the router.
struct Waiting {
  StreamId stream = 0;
  Sample sample;
  WireCost cost;  ///< of the sample
  Time offered{};
  Time expires = never;  ///< not sent after it
};

/// A sample that was not sent.
struct Dropped {
  Waiting waiting;
  DropReason reason;
};

/// The samples that wait, by class: within a class in the order of their turns.
///
/// A source has at most `depth` samples of a stream waiting; a newer one takes the turn of the one
/// it replaces. A class holds at most so many bytes: then its oldest go, other classes are not
/// touched; a single sample that is longer is kept. Pure; `now` never decreases.
class LinkQueue {
 public:
  explicit LinkQueue(std::size_t class_bytes) : class_bytes_(class_bytes) {}

  /// What it puts in the place of others is in the result.
  [[nodiscard]] std::vector<Dropped> add(TrafficClass traffic_class, std::size_t depth,
                                         const Waiting& waiting);
  /// Takes out what is older than its lifespan.
  [[nodiscard]] std::vector<Dropped> take_expired(Time now);
  /// Takes out the first of the class that makes less than `packets` packets.
  [[nodiscard]] std::optional<Waiting> take_first(TrafficClass traffic_class, std::size_t packets);
  /// Takes out all of a stream.
  [[nodiscard]] std::vector<Waiting> take_stream(StreamId stream);
  [[nodiscard]] bool has(StreamId stream) const;

  /// When take_expired() has something; `never` when nothing that waits expires.
  [[nodiscard]] Time next_expiry() const;
  [[nodiscard]] std::size_t bytes(TrafficClass traffic_class) const {
    return classes_[index_of(traffic_class)].bytes;
  }
  [[nodiscard]] std::size_t samples(TrafficClass traffic_class) const {
    return classes_[index_of(traffic_class)].waiting.size();
  }

 private:
  struct Class {
    std::list<Waiting> waiting;
    std::size_t bytes = 0;
  };
  using Place = std::list<Waiting>::const_iterator;
  [[nodiscard]] static std::optional<Dropped> replace(Class& in, std::size_t depth,
                                                      const Waiting& waiting);
  [[nodiscard]] static Place find_first(const Class& in, std::size_t packets);
  [[nodiscard]] static Waiting take(Class& from, Place place);
  std::size_t class_bytes_;
  std::array<Class, traffic_classes.size()> classes_;
};

}  // namespace tocsin::router
