// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <fstream>
#include <string>

#include "foundation/time.hpp"
#include "radio_channel/radio_channel.hpp"

namespace tocsin::link {

/// What the program itself counts, besides the link.
struct EmulatorCounters {
  std::uint64_t commands = 0;
  std::uint64_t bad_commands = 0;  ///< malformed datagrams, ignored
  std::uint64_t write_errors = 0;  ///< delivered packets that the kernel refused
  Duration late{0};                ///< the worst lateness of the program in the last second
};

/// One line of JSON, without the newline. `elapsed_s` counts from the start of the program; unknown
/// signals are null.
[[nodiscard]] std::string stats_line(double elapsed_s, const radio::LinkReport& report,
                                     const EmulatorCounters& counters);

/// The text of /proc/net/wireless of a host without wireless interfaces.
[[nodiscard]] std::string wireless_head();

/// The same for one interface, as the kernel prints it: noise is always -256,
/// and an unassociated interface shows zeros without dots.
[[nodiscard]] std::string wireless_text(const std::string& interface,
                                        const radio::LinkReport& report);

/// Appends lines to a file. Throws ConfigError when it cannot be opened.
class StatsFile {
 public:
  explicit StatsFile(const std::string& path);
  void append(const std::string& line);

 private:
  std::ofstream file_;
};

}  // namespace tocsin::link
