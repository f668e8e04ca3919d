// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "foundation/time.hpp"
#include "runtime/bus.hpp"
#include "runtime/middleware/qos_policies.hpp"

namespace tocsin::shapes {

/// What a reader that is asked now and then has at hand: of each instance the newest samples, as
/// its history says, and none that has outlived its lifespan. Pure.
class ShapeCache {
 public:
  explicit ShapeCache(const QosProfile& qos) : qos_(qos) {}

  /// A sample, or the end of an instance. `lifespan`: of its writer.
  void add(const Sample& sample, Duration lifespan);
  /// All that is there at `now`, instance by instance, each from its oldest.
  [[nodiscard]] std::vector<Sample> take(Time now);
  /// The same, which stays.
  [[nodiscard]] std::vector<Sample> read(Time now) const;

 private:
  struct Entry {
    Sample sample;
    Time expires;
  };
  const QosProfile qos_;
  std::map<std::uint64_t, std::deque<Entry>> instances_;
};

}  // namespace tocsin::shapes
