// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

/// Shows a filter some packets, each after two bytes of its length, and asserts what must hold of
/// any answer. For libFuzzer (test/fuzz/campaign) and the slice among the unit tests.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
