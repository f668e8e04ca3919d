// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "foundation/time.hpp"

namespace tocsin {

/// Account of one writer or reader of this process towards other processes, since start.
struct EndpointHealth {
  std::string topic;
  bool writer = false;         ///< else a reader
  std::uint64_t samples = 0;   ///< written, or received
  std::uint64_t lost = 0;      ///< refused by the middleware, or known to be missed by the reader
  std::uint64_t rejected = 0;  ///< received, but not of the topic's type
  int matched = 0;             ///< other ends now
  std::uint64_t incompatible_qos = 0;  ///< times that an end was found whose QoS does not fit
  std::string incompatible_policy;     ///< DDS name of the policy that did not fit last
  std::string misfit;      ///< policies by which an end that is there now does not fit, and whose
  std::string other_type;  ///< of an end that has another type or layout now, and its participant
  std::uint64_t deadlines_missed = 0;
  std::uint64_t liveliness_lost = 0;  ///< times that a writer stopped to be alive
  std::uint64_t thinned = 0;          ///< dropped by max_rate_hz or minimum_separation_s
  Time last{};                        ///< of the last sample; zero: none yet
};

}  // namespace tocsin
