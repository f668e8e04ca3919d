// SPDX-License-Identifier: Apache-2.0
// tocsin service list | type | find | call, as `ros2 service` has them.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>
#include <string>

#include "command_line/command.hpp"
#include "commands.hpp"
#include "foundation/error.hpp"
#include "foundation/ros_names.hpp"
#include "message_yaml.hpp"
#include "running_names.hpp"
#include "runtime/middleware/service_caller.hpp"
#include "service_text.hpp"
#include "topic_session.hpp"

namespace tocsin::topic_tool {
namespace {

struct ServiceOptions : SessionOptions {
  double timeout_s = 5;
  std::string service;
  std::string type;
  std::string request;
  ServiceListOptions list;
};

int list(const ServiceOptions& options) {
  const TopicSession session(options);
  std::fputs(service_list_text(session.ends(), options.list).c_str(), stdout);
  return 0;
}

int type(const ServiceOptions& options) {
  const TopicSession session(options);
  const auto services = services_in(session.ends());
  const auto found = services.find(absolute(options.service));
  if (found == services.end()) {
    throw EnvironmentError("service " + absolute(options.service) + " is not there" +
                           suggested_names(keys_of(services), absolute(options.service)));
  }
  for (const std::string& one : found->second) std::printf("%s\n", one.c_str());
  return 0;
}

int find(const ServiceOptions& options) {
  const TopicSession session(options);
  for (const auto& [name, types] : services_in(session.ends())) {
    if (types.count(options.type) != 0) std::printf("%s\n", name.c_str());
  }
  return 0;
}

/// Throws EnvironmentError with the services that are like the one that nobody serves.
void require_server(ServiceCaller& caller, const TopicSession& session,
                    const ServiceOptions& options) {
  try {
    caller.require(seconds(options.timeout_s));
  } catch (const EnvironmentError& error) {
    const auto services = keys_of(services_in(session.ends()));
    throw EnvironmentError(error.what() + suggested_names(services, absolute(options.service)));
  }
}

int call(const ServiceOptions& options) {
  const TypeInfo& request = known_type(wire_type(options.type + "_Request"));
  const TypeInfo& response = known_type(wire_type(options.type + "_Response"));
  const std::shared_ptr<const void> message = from_yaml(request, options.request);
  const TopicSession session(options);
  ServiceCaller caller(session.graph(), {absolute(options.service), &request, &response});
  if (!caller.wait_for_server(seconds(0.5))) {
    std::printf("waiting for service to become available...\n");
    std::fflush(stdout);
  }
  std::printf("requester: making request: %s\n\n", python_text(request, message.get()).c_str());
  std::fflush(stdout);
  require_server(caller, session, options);
  const auto answer = caller.call(message, seconds(options.timeout_s));
  std::printf("response:\n%s\n\n", python_text(response, answer.get()).c_str());
  return 0;
}

void declare(Verbs& verbs, ServiceOptions& options) {
  CLI::App* const all =
      add_verb(verbs, options, "list", "services that somebody serves or calls", list);
  all->add_flag("-t,--show-types", options.list.types, "with their types");
  all->add_flag("-c,--count-services", options.list.count, "how many there are");
  all->add_flag("--include-hidden-services", options.list.hidden, "those that begin with _, too");
  const char* const of = "its name, with or without the slash";
  add_verb(verbs, options, "type", "the type of a service", type)
      ->add_option("service", options.service, of)
      ->required();
  add_verb(verbs, options, "find", "services of a type", find)
      ->add_option("type", options.type, "std_srvs/srv/Trigger")
      ->required();
  CLI::App* const asked =
      add_verb(verbs, options, "call", "calls a service and waits for the answer", call);
  asked->add_option("service", options.service, of)->required();
  asked->add_option("type", options.type, "std_srvs/srv/SetBool")->required();
  asked->add_option("request", options.request, "in YAML: '{data: true}' [all defaults]");
  declare_timeout(*asked, options.timeout_s);
}

}  // namespace

int run_service(int argc, char** argv) {
  return run_verbs<ServiceOptions>(
      argc, argv, "tocsin service",
      "Services of a running host, ours and those of other ROS 2 programs there.", declare);
}

}  // namespace tocsin::topic_tool
