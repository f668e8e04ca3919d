// SPDX-License-Identifier: Apache-2.0
#include "decision/research/mean_cusum.hpp"

#include <sstream>

#include "foundation/error.hpp"

namespace tocsin::decision {

MeanCusum::MeanCusum(double mean, double drift, double threshold)
    : mean_(mean), drift_(drift), threshold_(threshold) {
  if (drift >= 0 && threshold > 0) return;
  std::ostringstream text;
  text << "mean CUSUM: drift " << drift << " must be at least 0 and threshold " << threshold
       << " above 0";
  throw ConfigError(text.str());
}

Shift MeanCusum::add(double x) {
  const double up = up_.add(x - mean_ - drift_);
  const double down = down_.add(mean_ - x - drift_);
  if (up <= threshold_ && down <= threshold_) return Shift::none;
  const Shift shift = up > threshold_ ? Shift::up : Shift::down;
  run_ = shift == Shift::up ? up_.run() : down_.run();
  up_.reset();
  down_.reset();
  return shift;
}

}  // namespace tocsin::decision
