// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "runtime/bus.hpp"

namespace tocsin {

/// The newest samples in order of arrival; the oldest makes room when it is full.
///
/// Memory grows by doubling up to the capacity and is then reused: no allocation per sample, and
/// little for a port on which nothing ever waits.
class SampleQueue {
 public:
  /// `capacity` is a power of two.
  explicit SampleQueue(std::size_t capacity) : capacity_(capacity) {}

  /// False when the oldest sample was dropped for it.
  bool push(Sample&& sample) {
    const bool full = size_ == capacity_;
    if (full) {
      drop_oldest();
    } else if (size_ == ring_.size()) {
      grow();
    }
    ring_[(first_ + size_) & (ring_.size() - 1)] = std::move(sample);
    ++size_;
    return !full;
  }
  /// The oldest sample; only when it is not empty.
  [[nodiscard]] Sample pop() {
    Sample sample = std::move(ring_[first_]);
    drop_oldest();
    return sample;
  }
  void clear() {
    while (size_ > 0) drop_oldest();
  }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  void drop_oldest() {
    ring_[first_].message.reset();
    first_ = (first_ + 1) & (ring_.size() - 1);
    --size_;
  }
  void grow() {
    std::vector<Sample> larger(ring_.empty() ? 1 : 2 * ring_.size());
    for (std::size_t i = 0; i < size_; ++i) {
      larger[i] = std::move(ring_[(first_ + i) & (ring_.size() - 1)]);
    }
    ring_ = std::move(larger);
    first_ = 0;
  }

  const std::size_t capacity_;
  std::vector<Sample> ring_;
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

}  // namespace tocsin
