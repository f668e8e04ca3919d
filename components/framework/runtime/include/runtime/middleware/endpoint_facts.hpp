// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>

namespace tocsin {

/// Whether a reader is of use without a writer; for `tocsin check`, no bus looks at it.
enum class Writers { needed, optional };

/// A writer that a subscription hears now.
struct WriterInfo {
  std::string name;       ///< of its participant, as discovery tools show it; not unique
  std::string user_data;  ///< all that it announces
  double lifespan_s = std::numeric_limits<double>::infinity();  ///< of its samples
};

/// What a component expects to write to a topic.
struct ExpectedLoad {
  double rate_hz;
  double bytes;  ///< mean size of a sample
};

}  // namespace tocsin
