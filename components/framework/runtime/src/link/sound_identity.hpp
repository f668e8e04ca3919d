// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "keystore/enclave.hpp"
#include "rtps/this_host.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"

namespace tocsin {

/// The options, if their identity is one that peers accept: Fast DDS gives no reason when it
/// refuses one. Throws ConfigError with it.
[[nodiscard]] inline const BusOptions& with_sound_identity(const BusOptions& options) {
  if (options.enclave.empty()) return options;
  const auto problems = keystore::problems_of(options.enclave, wall_now_ns() / 1'000'000'000);
  if (!problems.empty()) throw ConfigError(joined(problems, "; "));
  return options;
}

}  // namespace tocsin
