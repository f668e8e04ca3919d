// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "report/recording.hpp"

namespace tocsin::report {

/// The link emulator's account of a run, one JSON object per line; empty when there is none.
/// Lines that are damaged or cut off are left out. The lines tell the time since the emulator's
/// start only; the file was changed last when its last line was written.
[[nodiscard]] std::vector<LinkState> read_link_log(const std::string& path);

}  // namespace tocsin::report
