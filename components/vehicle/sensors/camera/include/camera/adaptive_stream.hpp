// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>

#include "foundation/time.hpp"

namespace tocsin::camera {

/// Which pictures are sent, and how small, so that a stream keeps to its budget: a tenth of the
/// saving (as powers) is made by the rate, the rest by the size, since a picture more helps a
/// driver more than a sharper one. Pure; `now` never decreases.
class AdaptiveStream {
 public:
  /// `scale` [0, 1] of the bytes that the stream would like to send; `hold`: older ones still wait.
  void set_budget(double scale, bool hold, Time now);
  /// For a picture that is due: the share [0.1, 1] of its size that may be sent; nothing: skip it.
  /// A budget that was not renewed for 2 s is over, then all may be sent.
  [[nodiscard]] std::optional<double> next(Time now);

 private:
  double scale_ = 1;
  bool hold_ = false;
  Time renewed_ = Time::min();
  double due_ = 0;  ///< pictures
};

/// Which JPEG quality makes a picture so small: by the sizes of one picture at several qualities.
class QualityLaw {
 public:
  /// `quality` [1, 100], as in encode_jpeg.
  void add(int quality, std::size_t bytes) { bytes_[quality] = static_cast<double>(bytes); }
  [[nodiscard]] bool empty() const { return bytes_.empty(); }
  /// The highest known quality whose size is at most `share` of the best one's, linear in between;
  /// the lowest one when none is.
  [[nodiscard]] int quality_for(double share) const;

 private:
  std::map<int, double> bytes_;
};

}  // namespace tocsin::camera
