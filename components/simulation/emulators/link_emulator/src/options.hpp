// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tocsin::link {

/// One end of the link: where its interface goes and what it is called there.
struct End {
  std::string name;     ///< gcs, or that of a vehicle or of a further site
  std::string netns;    ///< path of a network namespace, for example /run/netns/uxv
  std::string address;  ///< IPv4, dotted
  int prefix = 24;
};

/// The command line.
struct Options {
  std::string channel_file;
  std::string walls_file;  ///< empty: no walls
  std::uint64_t seed = 1;
  std::vector<End> vehicles;  ///< at least one
  std::vector<End> stations;  ///< behind the access point; at least one, the first is gcs
  std::string interface = "wlan0";
  // Of each vehicle; `{vehicle}` in them stands for its name.
  std::string control_path;   ///< empty: no control socket
  std::string stats_path;     ///< empty: none
  std::string wireless_path;  ///< empty: none
  bool check = false;         ///< only look at the arguments and the files
};

/// `path` with the name of a vehicle for each `{vehicle}`.
[[nodiscard]] std::string path_for(const std::string& path, const End& vehicle);

/// `NAME:NETNS:ADDRESS/PREFIX` with NAME gcs or a vehicle's; the netns may contain colons. Throws
/// ConfigError.
void parse_end(const std::string& text, Options& options);
/// The same of a station beside gcs, with any name. Throws ConfigError.
void parse_site(const std::string& text, Options& options);

/// Empty when only help was asked for, and printed. Throws ConfigError on bad usage.
[[nodiscard]] std::optional<Options> parse_options(int argc, const char* const* argv);

}  // namespace tocsin::link
