// SPDX-License-Identifier: Apache-2.0
// tocsin run COMPONENT: one component in its own process, without a bringup file.
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "command_line/command.hpp"
#include "command_line/host_option.hpp"
#include "command_line/launch_user.hpp"
#include "command_line/programs.hpp"
#include "container/run_container.hpp"
#include "container/settings.hpp"
#include "foundation/privileges.hpp"
#include "runtime/middleware/host_bus.hpp"

namespace tocsin {
namespace {

struct Options {
  std::string component;
  std::string name;
  std::optional<Role> role = Role::uxv;
  std::string ros_namespace;
  std::string run_dir = ".";
  std::string qos;
  std::string traffic;
  std::string user;
  std::optional<int> domain;
  std::vector<std::string> set;
};

void declare(CLI::App& app, Options& options) {
  add_name_option(app, "COMPONENT", options.component, "see tocsin component types")->required();
  add_name_option(app, "--name", options.name, "of the instance [COMPONENT]");
  app.add_option("--set", options.set, "parameter: key=value")->expected(1)->take_all();
  add_role_option(app, options.role, "side of the link that it is on [uxv]");
  app.add_option("--domain", options.domain, "DDS domain of the host [$ROS_DOMAIN_ID, 0]")
      ->check(CLI::Range(0, 231));
  add_name_option(app, "--namespace", options.ros_namespace, "ROS namespace of the topics");
  app.add_option("--run-dir", options.run_dir, "folder for the component's files [.]")
      ->check(CLI::ExistingDirectory);
  app.add_option("--user", options.user, "whom root becomes [who called sudo, tocsin]");
  app.add_option("--qos", options.qos, "QoS profiles [the installed ones]");
  app.add_option("--traffic", options.traffic, "traffic classes [the installed ones]");
}

deployment::Deployment deployment_of(const Options& options) {
  const std::string share = share_folder(own_program()).string();
  deployment::Deployment deployment;
  deployment.file = "--set";
  deployment.run_dir = std::filesystem::absolute(options.run_dir).string();
  deployment.share = share;
  deployment.qos = options.qos.empty() ? share + "/config/qos.yaml" : options.qos;
  deployment.traffic = options.traffic.empty() ? share + "/config/traffic.yaml" : options.traffic;
  deployment.ros_namespace = options.ros_namespace;
  deployment::Host host;
  host.role = options.role.value();
  host.name = to_string(host.role);
  host.local_domain = options.domain ? *options.domain : default_domain();
  deployment.hosts.push_back(std::move(host));
  return deployment;
}

deployment::Container container_of(const Options& options, YamlSources& sources) {
  deployment::ComponentInstance instance;
  instance.component = options.component;
  instance.name = options.name.empty() ? options.component : options.name;
  const std::string text = settings_text(options.set);
  instance.parameters = std::make_shared<const YAML::Node>(
      text.empty() ? YAML::Node(YAML::NodeType::Map) : sources.parse(text, "--set"));
  deployment::Container container;
  container.name = instance.name;
  container.components.push_back(std::move(instance));
  return container;
}

/// Before anything of the component is loaded, as `tocsin launch` does.
void become_ordinary(const Options& options, const deployment::Deployment& deployment) {
  const UserChoice choice = choose_user(options.user, "",
                                        {{own_program(), R_OK | X_OK},
                                         {deployment.qos, R_OK},
                                         {deployment.traffic, R_OK},
                                         {deployment.run_dir, R_OK | W_OK | X_OK}});
  if (choice.account) become_user(*choice.account, {});
  if (!choice.warning.empty()) std::fprintf(stderr, "tocsin run: %s\n", choice.warning.c_str());
}

int run(int argc, char** argv) {
  CLI::App app("Run one component in a process of its own", "tocsin run");
  Options options;
  declare(app, options);
  return run_command(app, argc, argv, [&] {
    auto deployment = deployment_of(options);
    become_ordinary(options, deployment);
    const auto container = container_of(options, deployment.sources);
    return run_container(deployment, deployment.hosts.front(), container);
  });
}

}  // namespace
}  // namespace tocsin

int main(int argc, char** argv) { return tocsin::run(argc, argv); }
