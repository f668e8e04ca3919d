// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mcap/reader.hpp"

namespace tocsin::mcap {

/// Reads the summary at the end of a file. False, and `summary` unspecified, when there is none
/// that can be trusted, or it does not tell where all messages are.
[[nodiscard]] bool read_summary(ByteSource& source, Summary& summary);

}  // namespace tocsin::mcap
