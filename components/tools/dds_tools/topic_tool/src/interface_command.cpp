// SPDX-License-Identifier: Apache-2.0
// tocsin interface list | show | proto | package | packages, as `ros2 interface` has them; export.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>
#include <string>

#include "command_line/command.hpp"
#include "commands.hpp"
#include "foundation/error.hpp"
#include "idl_support/type_definition.hpp"
#include "interface_package.hpp"
#include "interface_text.hpp"
#include "message_yaml.hpp"
#include "runtime/middleware/idl_libraries.hpp"
#include "topic_session.hpp"

namespace tocsin::topic_tool {
namespace {

struct InterfaceOptions {
  std::string name;
  std::string folder = ".";
  bool no_quotes = false;
  InterfaceListOptions list;
};

Interfaces installed() {
  load_idl_libraries();
  return interfaces_in(known_definitions());
}

[[noreturn]] void refuse(const char* what, const std::string& name) {
  throw ConfigError(std::string(what) + " '" + name +
                    "' is not known here: no installed package has its IDL; see tocsin interface "
                    "list");
}

int list(const InterfaceOptions& options) {
  std::fputs(interface_list_text(installed(), options.list).c_str(), stdout);
  return 0;
}

int show(const InterfaceOptions& options) {
  load_idl_libraries();
  const auto text = show_text(options.name);
  if (!text) refuse("the interface", options.name);
  std::fputs(text->c_str(), stdout);
  return 0;
}

/// A message with all defaults, to copy and fill.
int proto(const InterfaceOptions& options) {
  const TypeInfo& type = known_type(first_part(options.name));
  const std::string text = to_yaml(type, type.create().get(), {});
  std::printf(options.no_quotes ? "%s\n" : "\"%s\"\n", text.c_str());
  return 0;
}

int package(const InterfaceOptions& options) {
  const std::string text = package_text(installed(), options.name);
  if (text.empty()) refuse("the package", options.name);
  std::fputs(text.c_str(), stdout);
  return 0;
}

int packages(const InterfaceOptions&) {
  std::fputs(packages_text(installed()).c_str(), stdout);
  return 0;
}

/// For who builds nodes of ROS 2 that use our types.
int export_as_package(const InterfaceOptions& options) {
  load_idl_libraries();
  export_package(options.name, options.folder);
  return 0;
}

void declare(Verbs& verbs, InterfaceOptions& options) {
  const auto verb = [&](const char* name, const char* text, int (*body)(const InterfaceOptions&)) {
    return verbs.add(name, text, [&options, body] { return body(options); });
  };
  CLI::App* const all = verb("list", "interfaces of all installed packages", list);
  all->add_flag("-m,--only-msgs", options.list.messages, "only messages");
  all->add_flag("-s,--only-srvs", options.list.services, "only services");
  all->add_flag("-a,--only-actions", options.list.actions, "only actions");
  const char* const of = "nav_msgs/msg/Odometry, std_srvs/srv/Trigger, ...";
  verb("show", "the fields of an interface, with those in them", show)
      ->add_option("type", options.name, of)
      ->required();
  CLI::App* const example = verb("proto", "a message with all defaults, as YAML", proto);
  example->add_option("type", options.name, of)->required();
  example->add_flag("--no-quotes", options.no_quotes, "without quotes around it");
  verb("package", "interfaces of a package", package)
      ->add_option("package_name", options.name, "std_msgs")
      ->required();
  verb("packages", "packages that have interfaces", packages);
  CLI::App* const exported =
      verb("export", "a package of interfaces as sources that ROS 2 builds", export_as_package);
  exported->add_option("package_name", options.name, "tocsin_msgs")->required();
  exported->add_option("folder", options.folder, "in which its folder is made")
      ->capture_default_str();
}

}  // namespace

int run_interface(int argc, char** argv) {
  return run_verbs<InterfaceOptions>(argc, argv, "tocsin interface",
                                     "Interfaces that are installed: messages, services, actions.",
                                     declare);
}

}  // namespace tocsin::topic_tool
