// SPDX-License-Identifier: Apache-2.0
// tocsin param list | get | set | describe | dump | load, as `ros2 param` has them.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "command_line/command.hpp"
#include "commands.hpp"
#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/ros_names.hpp"
#include "param_text.hpp"
#include "running_names.hpp"
#include "runtime/middleware/ros_services.hpp"
#include "topic_session.hpp"

namespace tocsin::topic_tool {
namespace {

struct ParamOptions : SessionOptions {
  double timeout_s = 5;
  std::string node;
  std::string parameter;
  std::vector<std::string> parameters;
  std::string value;
  std::string file;
  bool hide_type = false;
};

/// The parameters of one node, asked for by its services.
class NodeParameters {
 public:
  NodeParameters(const ParamOptions& options, const TopicSession& session, const std::string& node)
      : graph_(session.graph()), node_(absolute(node)), patience_(seconds(options.timeout_s)) {}

  [[nodiscard]] std::vector<std::string> names() const {
    auto names = ask<parameter_service::ListParameters>({})->result().names();
    std::sort(names.begin(), names.end());
    return names;
  }
  [[nodiscard]] std::vector<RosValue> values(const std::vector<std::string>& names) const {
    parameter_service::GetParameters::Request request;
    request.names(names);
    const auto response = ask<parameter_service::GetParameters>(request);
    if (response->values().size() != names.size()) {
      throw EnvironmentError(node_ + ": did not answer for each parameter");
    }
    return response->values();
  }
  [[nodiscard]] std::vector<rcl_interfaces::msg::ParameterDescriptor> descriptions(
      const std::vector<std::string>& names) const {
    parameter_service::DescribeParameters::Request request;
    request.names(names);
    return ask<parameter_service::DescribeParameters>(request)->descriptors();
  }
  [[nodiscard]] rcl_interfaces::msg::SetParametersResult set(const NamedValue& value) const {
    parameter_service::SetParameters::Request request;
    rcl_interfaces::msg::Parameter parameter;
    parameter.name(value.first);
    parameter.value(value.second);
    request.parameters({parameter});
    const auto response = ask<parameter_service::SetParameters>(request);
    if (response->results().empty()) throw EnvironmentError(node_ + ": did not say what it did");
    return response->results().front();
  }
  [[nodiscard]] const std::string& node() const { return node_; }

 private:
  template <class Service>
  [[nodiscard]] std::shared_ptr<const typename Service::Response> ask(
      typename Service::Request request) const {
    return call_node<Service>(graph_, node_, std::move(request), patience_);
  }
  HostGraph& graph_;
  const std::string node_;
  const Duration patience_;
};

void print_names(const std::vector<std::string>& names) {
  for (const std::string& name : names) std::printf("  %s\n", printable(name).c_str());
}

/// Every node, when none is named; one that has no parameters, as those of other programs, is left
/// out.
int list_parameters(const ParamOptions& options) {
  const TopicSession session(options);
  if (!options.node.empty()) {
    print_names(NodeParameters(options, session, options.node).names());
    return 0;
  }
  (void)session.ends();
  ParamOptions brief = options;
  brief.timeout_s = std::min(options.timeout_s, options.spin_s);
  for (const GraphNode& node : session.graph().nodes()) {
    if (node.name.empty() || node.name[0] == '_') continue;
    try {
      const auto names = NodeParameters(brief, session, node.path()).names();
      std::printf("%s:\n", printable(node.path()).c_str());
      print_names(names);
    } catch (const EnvironmentError&) {
      continue;
    }
  }
  return 0;
}

int get(const ParamOptions& options) {
  const TopicSession session(options);
  const auto value =
      NodeParameters(options, session, options.node).values({options.parameter}).front();
  const std::string text = options.hide_type ? value_text(value) : typed_value_text(value);
  std::printf("%s\n", text.c_str());
  return value.type() == rcl_interfaces::msg::ParameterType_Constants::PARAMETER_NOT_SET ? 1 : 0;
}

int set(const ParamOptions& options) {
  const RosValue value = value_in(options.value);
  const TopicSession session(options);
  const auto result =
      NodeParameters(options, session, options.node).set({options.parameter, value});
  const std::string reason = result.reason().empty() ? "" : ": " + printable(result.reason());
  if (!result.successful()) throw EnvironmentError("Setting parameter failed" + reason);
  std::printf("Set parameter successful%s\n", reason.c_str());
  return 0;
}

int describe(const ParamOptions& options) {
  const TopicSession session(options);
  const auto all = NodeParameters(options, session, options.node).descriptions(options.parameters);
  for (const auto& one : all) std::printf("%s", description_text(one).c_str());
  return 0;
}

int dump(const ParamOptions& options) {
  const TopicSession session(options);
  const NodeParameters parameters(options, session, options.node);
  const auto names = parameters.names();
  const auto values = parameters.values(names);
  std::vector<NamedValue> named;
  for (std::size_t i = 0; i < names.size(); ++i) named.emplace_back(names[i], values[i]);
  std::fputs(dump_text(parameters.node(), named).c_str(), stdout);
  return 0;
}

int load(const ParamOptions& options) {
  const auto values = values_in_file(options.file, absolute(options.node));
  const TopicSession session(options);
  const NodeParameters parameters(options, session, options.node);
  bool all = true;
  for (const NamedValue& one : values) {
    const auto result = parameters.set(one);
    all = all && result.successful();
    std::printf("Set parameter %s %s%s%s\n", printable(one.first).c_str(),
                result.successful() ? "successful" : "failed", result.reason().empty() ? "" : ": ",
                printable(result.reason()).c_str());
  }
  return all ? 0 : 1;
}

CLI::App* verb(Verbs& verbs, ParamOptions& options, const char* name, const char* text,
               int (*body)(const ParamOptions&)) {
  CLI::App* const sub = add_verb(verbs, options, name, text, body);
  declare_timeout(*sub, options.timeout_s);
  sub->add_option("node", options.node, "its name, with its namespace")
      ->required(body != list_parameters);
  return sub;
}

void declare(Verbs& verbs, ParamOptions& options) {
  (void)verb(verbs, options, "list", "parameters of a node, or of all", list_parameters);
  const char* const which = "name of a parameter";
  CLI::App* const read = verb(verbs, options, "get", "the value of a parameter", get);
  read->add_option("parameter", options.parameter, which)->required();
  read->add_flag("--hide-type", options.hide_type, "the value alone");
  CLI::App* const written = verb(verbs, options, "set", "sets a live parameter", set);
  written->add_option("parameter", options.parameter, which)->required();
  written->add_option("value", options.value, "in YAML: 0.3, true, [a, b]")->required();
  verb(verbs, options, "describe", "type, meaning and range of parameters", describe)
      ->add_option("parameters", options.parameters, "their names")
      ->required();
  (void)verb(verbs, options, "dump", "all parameters of a node as YAML", dump);
  verb(verbs, options, "load", "sets what a file as of dump says", load)
      ->add_option("file", options.file, "YAML")
      ->required();
}

}  // namespace

int run_param(int argc, char** argv) {
  return run_verbs<ParamOptions>(
      argc, argv, "tocsin param",
      "Parameters of running nodes, ours and those of other ROS 2 programs on the host.", declare);
}

}  // namespace tocsin::topic_tool
