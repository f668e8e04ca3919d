// SPDX-License-Identifier: Apache-2.0
#include "decision/cusum.hpp"

#include <sstream>

#include "foundation/error.hpp"
#include "foundation/numbers.hpp"

namespace tocsin::decision {
namespace {

void check(const Normal& good, const Normal& bad, double clip) {
  std::ostringstream text;
  if (!(good.sd > 0 && good.sd < infinity) || !(bad.sd > 0 && bad.sd < infinity)) {
    text << "model: standard deviations " << good.sd << " and " << bad.sd << " must be above 0";
  } else if (!(good.mean > bad.mean)) {
    text << "model: mean of the good law " << good.mean << " must be above that of the bad law, "
         << bad.mean;
  } else if (!(clip >= 0)) {
    text << "model: clip " << clip << " must be 0 (none) or positive";
  }
  if (!text.str().empty()) throw ConfigError(text.str());
}

}  // namespace

NormalLlr::NormalLlr(Normal good, Normal bad, double clip)
    : good_(good),
      bad_(bad),
      offset_(std::log(good.sd / bad.sd)),
      clip_(clip > 0 ? clip : infinity) {
  check(good, bad, clip);
  const double v0 = good.sd * good.sd;
  const double v1 = bad.sd * bad.sd;
  const double vertex = (good.mean * v1 - bad.mean * v0) / (v1 - v0);
  if (v1 == v0 || vertex <= 0 || vertex >= 100) return;
  if (v1 < v0) low_ = vertex;
  if (v1 > v0) high_ = vertex;
}

}  // namespace tocsin::decision
