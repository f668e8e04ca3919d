// SPDX-License-Identifier: Apache-2.0
#include "options.hpp"

#include <arpa/inet.h>
#include <net/if.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "command_line/option_checks.hpp"
#include "foundation/error.hpp"
#include "foundation/names.hpp"
#include "foundation/role.hpp"

namespace tocsin::link {
namespace {

[[noreturn]] void bad_end(const std::string& text, const std::string& reason) {
  throw ConfigError("--end " + text + ": " + reason +
                    "; wanted NAME:NETNS:ADDRESS/PREFIX, for example "
                    "uxv:/run/netns/uxv:10.77.0.1/24");
}

bool is_known(const std::string& name, const std::vector<End>& all) {
  return std::any_of(all.begin(), all.end(), [&](const End& one) { return one.name == name; });
}

int prefix_of(const std::string& text, const std::string& whole) {
  const bool digits = !text.empty() && text.size() <= 2 &&
                      text.find_first_not_of("0123456789") == std::string::npos;
  const int prefix = digits ? std::stoi(text) : 0;
  if (prefix < 1 || prefix > 30) bad_end(whole, "prefix '" + text + "' is outside [1, 30]");
  return prefix;
}

constexpr const char* placeholder = "{vehicle}";

/// Several vehicles cannot share one of these.
void check_path(const char* option, const std::string& path, const Options& options) {
  if (path.empty() || options.vehicles.size() < 2) return;
  if (path.find(placeholder) != std::string::npos) return;
  throw ConfigError(std::string(option) + " " + path + ": needs {vehicle} in it, for " +
                    std::to_string(options.vehicles.size()) + " vehicles");
}

void check(const Options& options) {
  if (options.vehicles.empty() || !is_known(to_string(Role::gcs), options.stations)) {
    throw ConfigError("--end: needs one for gcs and at least one for a vehicle");
  }
  if (options.interface.empty() || options.interface.size() >= IFNAMSIZ) {
    throw ConfigError("--interface: '" + options.interface + "' is not 1 to 15 characters");
  }
  check_path("--control", options.control_path, options);
  check_path("--stats", options.stats_path, options);
  check_path("--wireless", options.wireless_path, options);
}

End read_end(const std::string& text) {
  const auto first = text.find(':');
  const auto last = text.rfind(':');
  if (first == std::string::npos || first == last) bad_end(text, "has not three parts");
  End end;
  end.name = text.substr(0, first);
  if (!is_name(end.name)) bad_end(text, "'" + end.name + "' is not " + name_rule);
  const std::string network = text.substr(last + 1);
  const auto slash = network.find('/');
  if (slash == std::string::npos) bad_end(text, "has no prefix");
  end.netns = text.substr(first + 1, last - first - 1);
  if (end.netns.empty()) bad_end(text, "names no namespace");
  end.address = network.substr(0, slash);
  in_addr address{};
  if (inet_pton(AF_INET, end.address.c_str(), &address) != 1) {
    bad_end(text, "'" + end.address + "' is not an IPv4 address");
  }
  end.prefix = prefix_of(network.substr(slash + 1), text);
  return end;
}

/// At `place` of the ends of one side.
void add_end(const std::string& text, const End& end, std::vector<End>::iterator place,
             std::vector<End>& side) {
  if (is_known(end.name, side)) bad_end(text, end.name + " is given twice");
  side.insert(place, end);
}

}  // namespace

std::string path_for(const std::string& path, const End& vehicle) {
  std::string made = path;
  const std::string mark = placeholder;
  for (auto at = made.find(mark); at != std::string::npos; at = made.find(mark)) {
    made.replace(at, mark.size(), vehicle.name);
  }
  return made;
}

void parse_end(const std::string& text, Options& options) {
  const End end = read_end(text);
  if (end.name == to_string(Role::gcs)) {
    add_end(text, end, options.stations.begin(), options.stations);
  } else {
    add_end(text, end, options.vehicles.end(), options.vehicles);
  }
}

void parse_site(const std::string& text, Options& options) {
  add_end(text, read_end(text), options.stations.end(), options.stations);
}

std::optional<Options> parse_options(int argc, const char* const* argv) {
  Options options;
  std::vector<std::string> ends;
  std::vector<std::string> sites;
  CLI::App app(
      "Carries IP packets between network namespaces, of vehicles and of stations behind their "
      "access point, over the modelled radio.",
      "link_emulator");
  app.add_option("--channel", options.channel_file, "channel file (YAML)")->required();
  app.add_option("--walls", options.walls_file, "walls file (YAML)");
  app.add_option("--seed", options.seed, "seed of shadowing, fading and losses")->check(is_seed());
  app.add_option("--end", ends, "NAME:NETNS:ADDRESS/PREFIX, once for gcs and once for each vehicle")
      ->required();
  app.add_option("--site", sites, "NAME:NETNS:ADDRESS/PREFIX of each station beside gcs");
  app.add_option("--interface", options.interface, "name of the interface in all namespaces");
  app.add_option("--control", options.control_path,
                 "unix datagram socket to create; for several vehicles with {vehicle} in it");
  app.add_option("--stats", options.stats_path, "JSON lines, one per second, appended; the same");
  app.add_option("--wireless", options.wireless_path,
                 "file like /proc/net/wireless, replaced; the same");
  app.add_flag("--check", options.check, "only look at the arguments and the files that they name");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    std::cout << app.help();
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw ConfigError(usage_error(app, error));
  }
  for (const std::string& end : ends) parse_end(end, options);
  for (const std::string& site : sites) parse_site(site, options);
  check(options);
  return options;
}

}  // namespace tocsin::link
