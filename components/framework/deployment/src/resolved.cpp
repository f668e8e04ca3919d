// SPDX-License-Identifier: Apache-2.0
#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <set>

#include "deployment/deployment.hpp"
#include "foundation/enum_words.hpp"
#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "foundation/replace_file.hpp"
#include "foundation/yaml_file.hpp"
#include "reader.hpp"

namespace tocsin::deployment {
namespace {

using YAML::BeginMap;
using YAML::BeginSeq;
using YAML::EndMap;
using YAML::EndSeq;

template <class Value>
void pair(YAML::Emitter& out, const char* key, const Value& value) {
  out << YAML::Key << key << YAML::Value << value;
}

/// Texts are quoted, so that one like `true` or `12` stays a text.
void text(YAML::Emitter& out, const char* key, const std::string& value) {
  out << YAML::Key << key << YAML::Value << YAML::DoubleQuoted << value;
}

void texts(YAML::Emitter& out, const char* key, const std::vector<std::string>& values) {
  out << YAML::Key << key << YAML::Value << YAML::Flow << BeginSeq;
  for (const std::string& value : values) out << YAML::DoubleQuoted << value;
  out << EndSeq;
}

/// Writes each parameter of a struct with its value.
class PairWriter {
 public:
  explicit PairWriter(YAML::Emitter& out) : out_(out) {}
  template <class Value>
  void operator()(const char* name, const Value& value, Range, const char*) {
    pair(out_, name, value);
  }

 private:
  YAML::Emitter& out_;
};

template <class Params>
void write_all(YAML::Emitter& out, const char* key, Params params) {
  out << YAML::Key << key << YAML::Value << BeginMap;
  PairWriter writer(out);
  params.visit(writer);
  out << EndMap;
}

void write(YAML::Emitter& out, const ComponentInstance& instance, const YamlSources& sources) {
  out << BeginMap;
  pair(out, "component", instance.component);
  pair(out, "name", instance.name);
  out << YAML::Key << "parameters" << YAML::Value << BeginMap;
  for (const auto& entry : *instance.parameters) {
    YAML::Node value(entry.second);
    if (!value.IsScalar()) value.SetStyle(YAML::EmitterStyle::Flow);
    pair(out, entry.first.Scalar().c_str(), value);
    out << YAML::Comment(sources.place(entry.first));
  }
  out << EndMap << EndMap;
}

void write(YAML::Emitter& out, const Program& program) {
  out << BeginMap;
  pair(out, "name", program.name);
  texts(out, "command", program.command);
  out << EndMap;
}

void write(YAML::Emitter& out, const Container& container, const YamlSources& sources) {
  out << BeginMap;
  pair(out, "name", container.name);
  pair(out, "terminal", container.terminal);
  if (!container.vehicle.empty()) pair(out, "vehicle", container.vehicle);
  pair(out, "parameter_services", word_of(container.parameter_services));
  write_all(out, "health", container.health);
  out << YAML::Key << "components" << YAML::Value << BeginSeq;
  for (const ComponentInstance& instance : container.components) write(out, instance, sources);
  out << EndSeq << EndMap;
}

void write(YAML::Emitter& out, const Host& host, const YamlSources& sources) {
  out << YAML::Key << host.name << YAML::Value << BeginMap;
  pair(out, "role", to_string(host.role));
  text(out, "address", host.address);
  texts(out, "peers", host.peers);
  if (!host.sites.empty()) texts(out, "sites", host.sites);
  if (host.second) {
    out << YAML::Key << "second" << YAML::Value << BeginMap;
    text(out, "address", host.second->address);
    texts(out, "peers", host.second->peers);
    out << EndMap;
  }
  text(out, "enclave", host.enclave);
  out << YAML::Key << "programs" << YAML::Value << BeginSeq;
  for (const Program& program : host.programs) write(out, program);
  out << EndSeq << YAML::Key << "containers" << YAML::Value << BeginSeq;
  for (const Container& container : host.containers) write(out, container, sources);
  out << EndSeq << EndMap;
}

void write(YAML::Emitter& out, const Radio& radio) {
  out << YAML::Key << "radio" << YAML::Value << BeginMap;
  text(out, "channel", radio.channel);
  text(out, "walls", radio.walls);
  if (!radio.second.empty()) text(out, "second", radio.second);
  out << EndMap;
}

void write(YAML::Emitter& out, const Relay& relay) {
  out << YAML::Key << "relay" << YAML::Value << BeginMap;
  text(out, "site", relay.site);
  text(out, "station", relay.station);
  out << EndMap;
}

std::optional<Relay> read_relay(const YAML::Node& node, const YamlSources& sources) {
  if (!node.IsDefined()) return std::nullopt;
  const Section section(node, "relay", sources, {"site", "station"});
  return Relay{section.required_name("site"), section.required_name("station")};
}

/// Of the hosts, in their order, and of the link.
void write_domains(YAML::Emitter& out, const Deployment& deployment) {
  out << YAML::Key << "domains" << YAML::Value << YAML::Flow << BeginSeq;
  for (const Host& host : deployment.hosts) out << host.local_domain;
  out << deployment.link_domain << EndSeq;
}

/// What an older version wrote has `domain`, from which they count on.
void read_domains(const Section& section, Deployment& deployment) {
  if (!section.find("domains").IsDefined()) {
    return assign_domains(section.whole("domain", 0, 0, 229), deployment);
  }
  std::vector<int> domains;
  for (const std::string& text : section.texts("domains")) {
    const bool is_number = !text.empty() && text.size() <= 3 &&
                           text.find_first_not_of("0123456789") == std::string::npos;
    const int domain = is_number ? std::stoi(text) : -1;
    if (domain < 0 || domain > 231) section.fail("domains", "'" + text + "' is not in [0, 231]");
    domains.push_back(domain);
  }
  if (domains.size() != deployment.hosts.size() + 1) {
    section.fail("domains", "must be one of each host, and one of the link");
  }
  for (std::size_t i = 0; i < deployment.hosts.size(); ++i) {
    deployment.hosts[i].local_domain = domains[i];
  }
  deployment.link_domain = domains.back();
}

void write(YAML::Emitter& out, const Deployment& deployment) {
  out << BeginMap;
  text(out, "run_dir", deployment.run_dir);
  text(out, "share", deployment.share);
  pair(out, "seed", deployment.seed);
  text(out, "qos", deployment.qos);
  text(out, "traffic", deployment.traffic);
  write_domains(out, deployment);
  text(out, "namespace", deployment.ros_namespace);
  text(out, "security", deployment.security);
  text(out, "user", deployment.user);
  texts(out, "stop_when_exits", deployment.stop_when_exits);
  write_all(out, "restart", deployment.restart);
  if (deployment.radio) write(out, *deployment.radio);
  if (!deployment.vehicles.empty()) texts(out, "vehicles", deployment.vehicles);
  if (deployment.relay) write(out, *deployment.relay);
  out << YAML::Key << "hosts" << YAML::Value << BeginMap;
  for (const Host& host : deployment.hosts) write(out, host, deployment.sources);
  out << EndMap << EndMap;
}

void write_part(const Deployment& part) {
  std::error_code error;
  std::filesystem::create_directories(part.run_dir, error);
  if (error) throw EnvironmentError(part.run_dir + ": cannot be made: " + error.message());
  write_resolved(part, part.run_dir + "/deployment.yaml");
}

}  // namespace

std::string resolved_text(const Deployment& deployment) {
  YAML::Emitter out;
  out.SetDoublePrecision(10);
  write(out, deployment);
  std::string text = "# Written by tocsin launch from:\n";
  std::set<std::string> told;  // a file is read anew for each vehicle
  for (const std::string& source : deployment.sources.files()) {
    if (told.insert(source).second) text += "#   " + source + "\n";
  }
  return text + out.c_str() + "\n";
}

void write_resolved(const Deployment& deployment, const std::string& path) {
  if (const auto error = replace_file(path, resolved_text(deployment))) {
    throw EnvironmentError(path + ": cannot be written: " + error.message());
  }
}

void write_parts(const Deployment& deployment) {
  for (const Deployment& part : parts_of(deployment)) {
    if (part.run_dir != deployment.run_dir) write_part(part);
    for (const Host& host : part.hosts) {
      Deployment site = part;
      site.run_dir = folder_of(part, host);
      if (site.run_dir != part.run_dir) write_part(site);
    }
  }
}

Deployment load_resolved(const std::string& path, const std::string& copy) {
  Deployment deployment;
  deployment.file = path;
  const YAML::Node root = deployment.sources.read(path, copy);
  const Section section(root, "deployment", deployment.sources,
                        body_keys({"run_dir", "share", "seed", "domain", "domains"}));
  // The files that it names were there at the launch.
  read_body(section, deployment.sources, Named::may_be_gone, deployment);
  deployment.run_dir = section.text("run_dir", "");
  deployment.share = section.text("share", "");
  deployment.seed = section.whole("seed", 1, 0, 1'000'000'000);
  deployment.vehicles = section.texts("vehicles");
  deployment.relay = read_relay(section.find("relay"), deployment.sources);
  check_whole(deployment);
  read_domains(section, deployment);
  return deployment;
}

}  // namespace tocsin::deployment
