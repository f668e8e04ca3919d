// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <map>

#include "build_graph.hpp"
#include "command_line/bringup_options.hpp"
#include "command_line/command.hpp"
#include "dot.hpp"
#include "examine.hpp"
#include "examine_domains.hpp"
#include "examine_programs.hpp"
#include "examine_routers.hpp"
#include "examine_security.hpp"
#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "idl_support/topic_registry.hpp"
#include "runtime/middleware/component_library.hpp"
#include "runtime/middleware/idl_libraries.hpp"

namespace tocsin::check {
namespace {

struct Options {
  BringupOptions bringup;
  std::string svg;
  bool all = false;
  bool quiet = false;
  bool strict = false;
};

void declare(CLI::App& app, Options& options) {
  options.bringup.declare(app);
  app.add_option("--svg", options.svg, "draw components and topics to this file (needs graphviz)");
  app.add_flag("--all", options.all,
               "show notes, and draw recorders, views and unread topics, too");
  app.add_flag("--quiet", options.quiet, "print errors only");
  app.add_flag("--strict", options.strict, "warnings count as errors")->excludes("--quiet");
}

bool has_containers(const deployment::Deployment& deployment) {
  return std::any_of(deployment.hosts.begin(), deployment.hosts.end(),
                     [](const deployment::Host& host) { return !host.containers.empty(); });
}

/// Whether a host names a peer that is another file's.
bool has_far_end(const std::vector<deployment::Host>& hosts) {
  const auto is_here = [&](const std::string& peer) {
    return std::any_of(hosts.begin(), hosts.end(),
                       [&](const deployment::Host& host) { return host.address == peer; });
  };
  return std::any_of(hosts.begin(), hosts.end(), [&](const deployment::Host& host) {
    return !std::all_of(host.peers.begin(), host.peers.end(), is_here);
  });
}

std::vector<std::string> names_of_topics() {
  load_idl_libraries();
  std::vector<std::string> names;
  for (const KnownTopic& one : known_topics()) names.emplace_back(one.info.name);
  return names;
}

/// Needs only what the files say, so that a wrong component does not hide it.
void examine_files(const deployment::Deployment& deployment, BuiltGraph& built) {
  if (!has_containers(deployment)) return;  // then there is no QoS
  try {
    const QosProfiles qos(deployment.qos);
    std::map<Role, TrafficRules> traffic;
    const VehicleChain chain =
        drives_a_vehicle(deployment) ? VehicleChain::ours : VehicleChain::foreign;
    for (const deployment::Host& host : deployment.hosts) {
      traffic.emplace(host.role, TrafficRules(deployment.traffic, host.role, chain));
    }
    const bool whole = built.findings.empty();
    const Rules rules{qos, traffic, names_of_topics(),
                      deployment.relay || has_far_end(deployment.hosts)};
    for (const Finding& finding : examine(built.graph, rules)) {
      // A component that could not be built leaves its readers and writers alone.
      if (whole || finding.severity == Severity::error) built.findings.push_back(finding);
    }
  } catch (const ConfigError& error) {
    built.findings.push_back({Severity::error, error.what()});
  }
}

/// Adds what is not there yet: what serves all vehicles is in the part of each.
void add_new(const BuiltGraph& part, BuiltGraph& all) {
  for (const Node& node : part.graph) {
    const auto is_it = [&](const Node& one) { return one.path() == node.path(); };
    if (std::none_of(all.graph.begin(), all.graph.end(), is_it)) all.graph.push_back(node);
  }
  for (const Finding& finding : part.findings) {
    const auto is_it = [&](const Finding& one) { return one.text == finding.text; };
    const auto& known = all.findings;
    if (std::none_of(known.begin(), known.end(), is_it)) all.findings.push_back(finding);
  }
}

/// What holds between a vehicle and its station, of several for each.
BuiltGraph examine_parts(const deployment::Deployment& deployment) {
  const auto parts = parts_of(deployment);
  std::vector<BuiltGraph> graphs;  // all, before names_of_topics() makes more topics known
  for (const deployment::Deployment& part : parts) {
    std::filesystem::create_directories(part.run_dir);
    graphs.push_back(build_graph(part));
  }
  BuiltGraph all;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    BuiltGraph& built = graphs[i];
    examine_files(parts[i], built);
    const auto routers = examine_routers(parts[i], built.graph);
    built.findings.insert(built.findings.end(), routers.begin(), routers.end());
    add_new(built, all);
  }
  return all;
}

std::size_t print(const std::vector<Finding>& findings, Severity severity, const char* word) {
  std::size_t count = 0;
  for (const Finding& finding : findings) {
    if (finding.severity != severity) continue;
    std::fprintf(stderr, "%s: %s\n", word, error_line(finding.text).c_str());
    ++count;
  }
  return count;
}

int check(Options& options) {
  options.bringup.locate();
  const TemporaryFolder folder;
  options.bringup.overrides.run_dir = folder.path();
  options.bringup.overrides.installed = installed_component_names();
  const auto deployment = load_deployment(options.bringup.file, options.bringup.overrides);
  BuiltGraph built = examine_parts(deployment);
  for (const auto& found :
       {examine_domains(deployment), examine_programs(deployment, program_folders()),
        examine_security(deployment, std::time(nullptr))}) {
    built.findings.insert(built.findings.end(), found.begin(), found.end());
  }
  const std::size_t errors = print(built.findings, Severity::error, "error");
  const std::size_t warnings =
      options.quiet ? 0 : print(built.findings, Severity::warning, "warning");
  if (options.all) (void)print(built.findings, Severity::note, "note");
  if (!options.svg.empty()) draw_svg(to_dot(built.graph, options.all), options.svg);
  if (!options.quiet) {
    std::printf("%s: %zu components; %zu errors, %zu warnings\n", options.bringup.file.c_str(),
                built.graph.size(), errors, warnings);
  }
  return errors > 0 || (options.strict && warnings > 0) ? 2 : 0;
}

}  // namespace
}  // namespace tocsin::check

int main(int argc, char** argv) {
  CLI::App app{"Check a bringup file without starting it, and draw it", "tocsin check"};
  tocsin::check::Options options;
  declare(app, options);
  return tocsin::run_command(app, argc, argv, [&] { return tocsin::check::check(options); });
}
