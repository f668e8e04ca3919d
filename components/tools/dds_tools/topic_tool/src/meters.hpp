// SPDX-License-Identifier: Apache-2.0
// What `ros2 topic hz`, `bw` and `delay` compute, over the newest samples of a window.
#pragma once

#include <cstddef>
#include <deque>
#include <string>

#include "foundation/time.hpp"

namespace tocsin::topic_tool {

/// Least, most, mean and standard deviation (of the population) of the newest values.
class Window {
 public:
  explicit Window(std::size_t size) : size_(size) {}
  void add(double value);
  [[nodiscard]] std::size_t count() const { return values_.size(); }
  [[nodiscard]] double least() const;
  [[nodiscard]] double most() const;
  [[nodiscard]] double mean() const;
  [[nodiscard]] double deviation() const;

 private:
  std::size_t size_;
  std::deque<double> values_;
};

/// Rate of arrival.
class RateMeter {
 public:
  explicit RateMeter(std::size_t window) : intervals_(window) {}
  void add(Time received);
  /// Empty before the second sample.
  [[nodiscard]] std::string text() const;

 private:
  Window intervals_;
  Time last_{};
};

/// Bytes a second, from the oldest sample of the window until now.
class BandwidthMeter {
 public:
  explicit BandwidthMeter(std::size_t window) : window_(window) {}
  void add(std::size_t bytes, Time received);
  /// Empty before the first sample.
  [[nodiscard]] std::string text(Time now) const;

 private:
  struct One {
    std::size_t bytes;
    Time received;
  };
  std::size_t window_;
  std::deque<One> samples_;
};

/// Time from a stamp to the arrival, by the clocks of both.
class DelayMeter {
 public:
  explicit DelayMeter(std::size_t window) : delays_(window) {}
  void add(double delay_s) { delays_.add(delay_s); }
  /// Empty before the first sample.
  [[nodiscard]] std::string text() const;

 private:
  Window delays_;
};

}  // namespace tocsin::topic_tool
