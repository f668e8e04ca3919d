// SPDX-License-Identifier: Apache-2.0
#include "meters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tocsin::topic_tool {
namespace {

/// As `ros2 topic bw`: thousands, two decimals.
std::string bytes_text(double bytes) {
  if (bytes < 1000) return fmt::format("{:.0f} B", bytes);
  return bytes < 1e6 ? fmt::format("{:.2f} KB", bytes / 1e3)
                     : fmt::format("{:.2f} MB", bytes / 1e6);
}

}  // namespace

void Window::add(double value) {
  values_.push_back(value);
  if (values_.size() > size_) values_.pop_front();
}

double Window::least() const { return *std::min_element(values_.begin(), values_.end()); }
double Window::most() const { return *std::max_element(values_.begin(), values_.end()); }

double Window::mean() const {
  return std::accumulate(values_.begin(), values_.end(), 0.0) / static_cast<double>(count());
}

double Window::deviation() const {
  const double middle = mean();
  const double squares = std::accumulate(
      values_.begin(), values_.end(), 0.0,
      [&](double sum, double value) { return sum + (value - middle) * (value - middle); });
  return std::sqrt(squares / static_cast<double>(count()));
}

void RateMeter::add(Time received) {
  if (last_ != Time{}) intervals_.add(to_seconds(received - last_));
  last_ = received;
}

std::string RateMeter::text() const {
  if (intervals_.count() == 0) return "";
  return fmt::format(
      "average rate: {:.3f}\n\tmin: {:.3f}s max: {:.3f}s std dev: {:.5f}s window: {}\n",
      1 / intervals_.mean(), intervals_.least(), intervals_.most(), intervals_.deviation(),
      intervals_.count() + 1);
}

void BandwidthMeter::add(std::size_t bytes, Time received) {
  samples_.push_back({bytes, received});
  if (samples_.size() > window_) samples_.pop_front();
}

std::string BandwidthMeter::text(Time now) const {
  const double span_s = samples_.empty() ? 0 : to_seconds(now - samples_.front().received);
  if (span_s <= 0) return "";
  Window sizes(samples_.size());
  for (const One& one : samples_) sizes.add(static_cast<double>(one.bytes));
  const double all = sizes.mean() * static_cast<double>(sizes.count());
  return fmt::format("{}/s from {} messages\n\tMessage size mean: {} min: {} max: {}\n",
                     bytes_text(all / span_s), sizes.count(), bytes_text(sizes.mean()),
                     bytes_text(sizes.least()), bytes_text(sizes.most()));
}

std::string DelayMeter::text() const {
  if (delays_.count() == 0) return "";
  return fmt::format(
      "average delay: {:.3f}\n\tmin: {:.3f}s max: {:.3f}s std dev: {:.5f}s window: {}\n",
      delays_.mean(), delays_.least(), delays_.most(), delays_.deviation(), delays_.count());
}

}  // namespace tocsin::topic_tool
