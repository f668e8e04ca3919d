// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

/// Feeds arbitrary bytes to what reads an RPLIDAR, cut by the first byte, and to what the simulated
/// one reads. Aborts when an invariant breaks.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
