// SPDX-License-Identifier: Apache-2.0
#include "reader.hpp"

#include <arpa/inet.h>

#include <algorithm>

#include "foundation/enum_words.hpp"
#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin::deployment {
namespace {

bool is_address(const std::string& text) {
  in_addr address{};
  return inet_pton(AF_INET, text.c_str(), &address) == 1;
}

bool is_ros_namespace(const std::string& text) {
  const auto allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '/'; };
  return text.empty() ||
         (std::isalpha(static_cast<unsigned char>(text[0])) != 0 && text.back() != '/' &&
          text.find("//") == std::string::npos && std::all_of(text.begin(), text.end(), allowed));
}

ComponentInstance read_instance(const YAML::Node& node, const std::string& owner,
                                const YamlSources& sources) {
  ComponentInstance instance;
  YAML::Node parameters(YAML::NodeType::Map);
  if (node.IsScalar()) {
    instance.component = instance.name = node.Scalar();
    check_name(instance.name, owner, node, sources);
  } else {
    const Section section(node, owner, sources, {"component", "name", "parameters"});
    instance.component = section.required_name("component");
    instance.name = section.text("name", instance.component);
    check_name(instance.name, owner + ".name", node, sources);
    const YAML::Node given = section.find("parameters");
    if (given.IsDefined() && !given.IsNull()) {
      const Section keys(given, instance.name, sources);
      parameters.reset(given);  // an assignment would copy the list of all nodes of the file
    }
  }
  instance.parameters = std::make_shared<const YAML::Node>(parameters);
  instance.place = sources.place(node);
  return instance;
}

Program read_program(const YAML::Node& node, const std::string& owner, const YamlSources& sources) {
  const Section section(node, owner, sources, {"name", "command"});
  Program program{section.required_name("name"), section.texts("command")};
  if (program.command.empty()) section.fail("command", "must be a list with at least a program");
  return program;
}

ParameterServices read_parameter_services(const Section& section) {
  const std::string word = section.text("parameter_services", "on_demand");
  const auto value = value_of<ParameterServices>(word);
  if (!value) {
    section.fail("parameter_services", "'" + word + "' is not one of: on_demand, always, never");
  }
  return *value;
}

Container read_container(const YAML::Node& node, const std::string& owner,
                         const YamlSources& sources) {
  const Section section(node, owner, sources,
                        {"name", "terminal", "health", "parameter_services", "each_vehicle",
                         "vehicle", "components"});
  Container container;
  container.name = section.required_name("name");
  container.terminal = section.flag("terminal", false);
  container.parameter_services = read_parameter_services(section);
  (void)section.flag("each_vehicle", false);  // of one vehicle the only one
  container.vehicle = section.text("vehicle", "");
  container.health =
      load_parameters<HealthLimits>(section.find("health"), owner + ".health", sources);
  for (const YAML::Node& item : section.items("components")) {
    container.components.push_back(read_instance(item, owner + ".components", sources));
  }
  if (container.components.empty()) section.fail("components", "must name at least one component");
  return container;
}

std::optional<SecondPath> read_second(const Section& of_host, const Host& host,
                                      const YamlSources& sources) {
  const YAML::Node node = of_host.find("second");
  if (!node.IsDefined() || node.IsNull()) return std::nullopt;
  const Section section(node, "hosts." + host.name + ".second", sources, {"address", "peers"});
  SecondPath second{section.required_text("address"), section.texts("peers")};
  check_address(second.address, "address", section);
  for (const std::string& peer : second.peers) check_address(peer, "peers", section);
  if (second.peers.size() != host.peers.size()) {
    section.fail("peers", std::to_string(second.peers.size()) +
                              " addresses must be as many as the host's peers, which are " +
                              std::to_string(host.peers.size()) + ", in the same order");
  }
  if (second.address == host.address) {
    section.fail("address", "'" + second.address + "' must not be the host's address, too");
  }
  return second;
}

std::vector<std::string> read_sites(const Section& section, const Host& host,
                                    const YamlSources& sources) {
  const std::vector<std::string> sites = section.texts("sites");
  const std::vector<YAML::Node> nodes = section.items("sites");
  for (std::size_t i = 0; i < sites.size(); ++i) {
    check_name(sites[i], "hosts." + host.name + ".sites", nodes[i], sources);
  }
  if (sites.empty() || sites.size() == host.peers.size()) return sites;
  section.fail("sites", std::to_string(sites.size()) +
                            " names must be as many as the host's peers, which are " +
                            std::to_string(host.peers.size()) + ", in the same order");
}

Host read_host(const std::string& name, const YAML::Node& node, const YamlSources& sources) {
  check_name(name, "hosts", node, sources);
  const std::string owner = "hosts." + name;
  const Section section(node, owner, sources,
                        {"role", "address", "peers", "sites", "second", "enclave", "domain",
                         "programs", "containers"});
  Host host;
  host.name = name;
  const std::string role = section.required_text("role");
  if (!role_of(role)) section.fail("role", "'" + role + "' is not one of: uxv, gcs");
  host.role = *role_of(role);
  host.address = section.required_text("address");
  check_address(host.address, "address", section);
  host.peers = section.texts("peers");
  for (const std::string& peer : host.peers) check_address(peer, "peers", section);
  host.sites = read_sites(section, host, sources);
  host.second = read_second(section, host, sources);
  host.enclave = section.text("enclave", name);
  const bool has_domain = section.find("domain").IsDefined();
  host.local_domain = has_domain ? section.whole("domain", 0, 0, 231) : no_domain;
  for (const YAML::Node& item : section.items("programs")) {
    host.programs.push_back(read_program(item, owner + ".programs", sources));
  }
  for (const YAML::Node& item : section.items("containers")) {
    host.containers.push_back(read_container(item, owner + ".containers", sources));
  }
  return host;
}

RestartPolicy read_restart(const YAML::Node& node, const YamlSources& sources) {
  const auto policy = load_parameters<RestartPolicy>(node, "restart", sources);
  if (policy.max_backoff_s < policy.backoff_s) {
    throw ConfigError("restart.max_backoff_s: must not be less than restart.backoff_s" +
                      yaml_place(sources, node));
  }
  return policy;
}

std::optional<Radio> read_radio(const YAML::Node& node, const YamlSources& sources, Named named) {
  if (!node.IsDefined() || node.IsNull()) return std::nullopt;
  const Section section(node, "radio", sources, {"channel", "walls", "second"});
  Radio radio{section.file("channel", named), section.file("walls", named),
              section.file("second", named)};
  if (radio.channel.empty()) section.fail("channel", "is missing");
  if (radio.walls.empty()) section.fail("walls", "is missing");
  return radio;
}

/// One name, or a list of names.
std::vector<std::string> read_names(const Section& section, const std::string& key) {
  const YAML::Node node = section.find(key);
  if (node.IsDefined() && node.IsSequence()) return section.texts(key);
  const std::string one = section.text(key, "");
  return one.empty() ? std::vector<std::string>{} : std::vector<std::string>{one};
}

}  // namespace

void check_address(const std::string& text, const std::string& key, const Section& section) {
  if (!is_address(text)) section.fail(key, "'" + text + "' is not an IPv4 address");
}

std::vector<Host> read_hosts(const YAML::Node& hosts, const YamlSources& sources) {
  const Section names(hosts, "hosts", sources);
  std::vector<Host> found;
  for (const auto& entry : hosts) {
    found.push_back(read_host(entry.first.Scalar(), entry.second, sources));
  }
  return found;
}

std::vector<std::string> body_keys(const std::vector<std::string>& more) {
  std::vector<std::string> keys{"qos",     "traffic", "namespace", "user",     "stop_when_exits",
                                "restart", "radio",   "security",  "vehicles", "relay",
                                "hosts"};
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

void read_body(const Section& section, const YamlSources& sources, Named named,
               Deployment& deployment) {
  deployment.qos = section.file("qos", named);
  deployment.traffic = section.file("traffic", named);
  deployment.ros_namespace = section.text("namespace", "");
  if (!is_ros_namespace(deployment.ros_namespace)) {
    section.fail("namespace", "'" + deployment.ros_namespace +
                                  "' is not words of letters, digits and '_' joined by '/'");
  }
  deployment.user = section.text("user", "");
  deployment.stop_when_exits = read_names(section, "stop_when_exits");
  deployment.restart = read_restart(section.find("restart"), sources);
  deployment.radio = read_radio(section.find("radio"), sources, named);
  deployment.security = section.folder("security", named);
  const YAML::Node hosts = section.find("hosts");
  if (!hosts.IsDefined()) section.fail("hosts", "is missing");
  deployment.hosts = read_hosts(hosts, sources);
}

}  // namespace tocsin::deployment
