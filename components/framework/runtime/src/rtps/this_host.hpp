// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace tocsin {

/// [ns] since the Unix epoch, by this host's clock.
[[nodiscard]] std::int64_t wall_now_ns();

/// A number for `Sample::source` that no other writer has, here or in another life of this process.
[[nodiscard]] std::uint64_t fresh_source();

}  // namespace tocsin
