// SPDX-License-Identifier: Apache-2.0
#include "examine_programs.hpp"

#include <numeric>
#include <utility>

#include "command_line/launch_plan.hpp"
#include "command_line/run_to_end.hpp"
#include "foundation/error.hpp"

namespace tocsin::check {
namespace {

/// All that would be started, the radio too. Throws ConfigError.
std::vector<ProcessSpec> plan(const deployment::Deployment& deployment, const Folders& folders) {
  std::vector<ProcessSpec> specs = plan_processes(deployment, {}, folders);
  // There are no namespaces yet; the descriptors only have to be numbers.
  if (!deployment.radio) return specs;
  std::vector<int> descriptors(deployment.hosts.size());
  std::iota(descriptors.begin(), descriptors.end(), 0);
  for (ProcessSpec& one : plan_radios(deployment, descriptors, folders)) {
    specs.push_back(std::move(one));
  }
  return specs;
}

/// The program's own words in one line.
std::string first_line(const std::string& output) { return output.substr(0, output.find('\n')); }

void ask(const ProcessSpec& spec, std::vector<Finding>& findings) {
  std::vector<std::string> command = spec.command;
  command.emplace_back("--check");
  const Ended ended = run_to_end(command);
  if (ended.code == 0) return;
  const std::string reason =
      ended.output.empty() ? "ends with " + std::to_string(ended.code) : first_line(ended.output);
  findings.push_back({Severity::error, spec.name + ": " + reason});
}

}  // namespace

std::vector<Finding> examine_programs(const deployment::Deployment& deployment,
                                      const Folders& folders) {
  std::vector<Finding> findings;
  try {
    for (const ProcessSpec& spec : plan(deployment, folders)) {
      if (spec.checks_itself) ask(spec, findings);
    }
  } catch (const std::exception& error) {
    findings.push_back({Severity::error, error.what()});
  }
  return findings;
}

}  // namespace tocsin::check
