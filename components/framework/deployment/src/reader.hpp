// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "deployment/deployment.hpp"
#include "section.hpp"

namespace tocsin::deployment {

/// The keys of `read_body` and `more`.
[[nodiscard]] std::vector<std::string> body_keys(const std::vector<std::string>& more);

/// Reads the parts that a bringup file and a resolved file share into `deployment`:
/// qos, traffic, namespace, user, stop_when_exits, restart, radio, security, hosts. `named`: the
/// files that it names.
void read_body(const Section& section, const YamlSources& sources, Named named,
               Deployment& deployment);

/// The hosts of a map of that name.
[[nodiscard]] std::vector<Host> read_hosts(const YAML::Node& hosts, const YamlSources& sources);

/// Throws ConfigError when it is no IPv4 address.
void check_address(const std::string& text, const std::string& key, const Section& section);

/// Of a host whose `domain` the file does not say.
inline constexpr int no_domain = -1;

/// Gives every host that has none its domain id: `domain`, `domain + 1`, by its place; the link has
/// the next one, but at least `domain + 2`, and the links of several vehicles those from there on.
void assign_domains(int domain, Deployment& deployment);

/// Throws ConfigError when parts contradict each other: duplicate names, two terminals,
/// a radio without one host of each role, stop_when_exits that names nothing, missing qos, a
/// container for a vehicle that there is not.
void check_whole(const Deployment& deployment);

}  // namespace tocsin::deployment
