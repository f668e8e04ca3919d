// SPDX-License-Identifier: Apache-2.0
#include "noise.hpp"

#include <boost/random/normal_distribution.hpp>

namespace tocsin::kobuki {

// By the ziggurat method; that of the standard library needs a logarithm and a root for each pair.
double standard_normal(std::mt19937_64& random) {
  return boost::random::normal_distribution<double>{}(random);
}

}  // namespace tocsin::kobuki
