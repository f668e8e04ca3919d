// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "radio_channel/channel_params.hpp"

namespace tocsin::radio {

/// Reads a channel file: a YAML map of ChannelParams under the key `radio_channel`. It may
/// `extends` another one, relative to it. Throws ConfigError with file, key and range.
[[nodiscard]] ChannelParams load_channel(const std::string& path);

/// The file and those that it extends. Throws ConfigError.
[[nodiscard]] std::vector<std::string> channel_sources(const std::string& path);

/// Reads a measured link: CSV whose first row names at least the columns `time_s`, `rssi_dbm` and
/// `ping_delay_ms` (empty: no answer). Throws ConfigError with file and line.
[[nodiscard]] Trace load_trace(const std::string& path);

}  // namespace tocsin::radio
