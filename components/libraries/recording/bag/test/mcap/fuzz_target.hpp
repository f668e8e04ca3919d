// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

/// Reads a file of any bytes by its index and in the order of the file, and mends it: what the
/// mended file holds must be what it says. Aborts when an invariant breaks.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
