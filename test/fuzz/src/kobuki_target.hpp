// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

/// Feeds arbitrary bytes to everything that reads the serial line: reassembler (cut by the first
/// byte), feedback and command decoders, odometry, battery, events. Aborts when an invariant
/// breaks.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
