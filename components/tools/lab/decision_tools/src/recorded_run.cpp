// SPDX-License-Identifier: Apache-2.0
#include "recorded_run.hpp"

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <set>
#include <vector>

#include "decision/policy_params.hpp"
#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/parameters.hpp"
#include "foundation/printable.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin::tools {
namespace {

namespace fs = std::filesystem;

struct Controller {
  Role role;
  std::shared_ptr<const YAML::Node> values;
};

Role role_in(const std::string& file, const YAML::Node& host) {
  const auto word = host["role"].as<std::string>();
  if (const auto role = role_of(word)) return *role;
  throw ConfigError(file + ": role '" + printable(word) + "' is not uxv or gcs");
}

/// Read without deployment::load_resolved, which needs the files that the run was started with: a
/// recording may have come from another computer.
std::vector<Controller> controllers_in(const std::string& file) {
  std::vector<Controller> found;
  try {
    const YAML::Node deployment = read_yaml_file(file);
    for (const auto& host : deployment["hosts"]) {
      for (const auto& container : host.second["containers"]) {
        for (const auto& one : container["components"]) {
          if (one["component"].as<std::string>() != "transmission_controller") continue;
          found.push_back(
              {role_in(file, host.second), std::make_shared<const YAML::Node>(one["parameters"])});
        }
      }
    }
  } catch (const YAML::Exception& error) {
    throw ConfigError(file + ":" + std::to_string(error.mark.line + 1) +
                      ": is not a deployment as tocsin launch writes it: " + error.msg);
  }
  return found;
}

/// What a parameter struct says in the end, as text that can be compared.
template <class Params>
std::string resolved(const Controller& controller, const std::string& file) {
  Params params;
  ParameterLoader loader(*controller.values, "transmission_controller", file);
  params.visit(loader);
  ParameterPrinter printer;
  params.visit(printer);
  return printer.text();
}

bool decide_alike(const std::vector<Controller>& all, const std::string& file) {
  std::set<std::string> texts;
  for (const Controller& one : all) {
    texts.insert(resolved<decision::PolicyParams>(one, file) +
                 resolved<decision::QniParams>(one, file));
  }
  return texts.size() == 1;
}

std::optional<fs::path> deployment_beside(const fs::path& recording) {
  const fs::path folder = fs::absolute(recording).parent_path();
  if (fs::is_regular_file(folder / "deployment.yaml")) return folder / "deployment.yaml";
  // The recorder writes into a folder of its role; any other folder may lie beside a foreign file.
  const fs::path above = folder.parent_path() / "deployment.yaml";
  const bool is_of_role = role_of(folder.filename().string()).has_value();
  return is_of_role && fs::is_regular_file(above) ? std::optional(above) : std::nullopt;
}

std::vector<Role> roles_of(const std::vector<Controller>& all) {
  std::vector<Role> roles;
  for (const Controller& one : all) roles.push_back(one.role);
  return roles;
}

}  // namespace

std::string joined_roles(const std::vector<Role>& roles) {
  return joined_of(
      roles, [](Role role) { return std::string(to_string(role)); }, " and ");
}

decision::QniParams ControllerParameters::quality() const {
  decision::QniParams params;
  ParameterLoader loader(*values, "transmission_controller", file);
  params.visit(loader);
  return params;
}

std::optional<ControllerParameters> controller_of_run(const std::string& recording,
                                                      std::optional<Role> role) {
  const auto path = deployment_beside(recording);
  if (!path) return std::nullopt;
  const std::string file = path->string();
  std::vector<Controller> found;
  for (Controller& one : controllers_in(file)) {
    if (!role || one.role == role) found.push_back(std::move(one));
  }
  if (found.empty()) {
    throw ConfigError(file + ": has no transmission_controller" +
                      (role ? std::string(" of role ") + to_string(*role) : "") + ", which " +
                      recording + " needs");
  }
  if (!decide_alike(found, file)) {
    throw ConfigError(recording + ": the transmission_controllers of " +
                      joined_roles(roles_of(found)) + " in " + file +
                      " decide differently; choose one by --host");
  }
  return ControllerParameters{file, roles_of(found), found.front().values};
}

}  // namespace tocsin::tools
