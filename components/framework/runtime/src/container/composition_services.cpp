// SPDX-License-Identifier: Apache-2.0
#include "container/composition_services.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "runtime/host_control.hpp"
#include "runtime/middleware/qos_change.hpp"
#include "runtime/middleware/ros_parameters.hpp"

namespace tocsin {
namespace {

/// `navigator` of `tocsin::navigator`: components here have one word.
std::string plugin_library(const std::string& plugin) {
  const std::size_t at = plugin.rfind("::");
  return at == std::string::npos ? plugin : plugin.substr(at + 2);
}

}  // namespace

LoadReading read_load(const composition_service::LoadNode::Request& request,
                      const std::string& ros_namespace) {
  LoadOrder order;
  order.library = plugin_library(request.plugin_name());
  order.name = request.node_name().empty() ? order.library : request.node_name();
  const std::string& wanted = request.node_namespace();
  if (!wanted.empty() && wanted != "/" + ros_namespace) {
    return {std::nullopt, "node_namespace: " + printable(wanted) + ": nodes of this run are in /" +
                              printable(ros_namespace)};
  }
  if (!request.remap_rules().empty()) {
    return {std::nullopt, "remap_rules: topics are not renamed here"};
  }
  YAML::Node parameters(YAML::NodeType::Map);
  for (const auto& one : request.parameters()) {
    const auto value = yaml_of(one.value());
    if (!value) return {std::nullopt, printable(one.name()) + ": has no value, or one of bytes"};
    parameters[one.name()] = *value;
  }
  order.parameters = YAML::Dump(parameters);
  return {std::move(order), ""};
}

CompositionServices::CompositionServices(Component& owner, Instances& instances)
    : owner_(owner),
      instances_(instances),
      load_(owner, composition_service::LoadNode::name, owner.node()),
      unload_(owner, composition_service::UnloadNode::name, owner.node()),
      list_(owner, composition_service::ListNodes::name, owner.node()),
      set_qos_(owner, composition_service::SetQos::name, owner.node()),
      log_(owner.name(), owner.node()) {}

const Instance* CompositionServices::find(const std::string& name) const {
  const auto& all = instances_.all();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
  return found != all.end() ? &*found : nullptr;
}

std::string CompositionServices::path_of(const std::string& name) const {
  const std::string& home = owner_.bus().host_control().ros_namespace();
  return (home.empty() ? "/" : "/" + home + "/") + name;
}

composition_service::LoadNode::Response CompositionServices::loaded(
    const composition_service::LoadNode::Request& request, const Load& load) const {
  composition_service::LoadNode::Response response;
  const LoadReading reading = read_load(request, owner_.bus().host_control().ros_namespace());
  const Outcome outcome = reading.order ? load(*reading.order) : Outcome{false, reading.fault};
  const Instance* const made = outcome.done ? find(reading.order->name) : nullptr;
  response.success(made != nullptr);
  if (made == nullptr) {
    response.error_message(outcome.text);
    return response;
  }
  response.full_node_name(path_of(made->name));
  response.unique_id(made->id);
  return response;
}

bool CompositionServices::answer(const Load& load) {
  const bool loaded = answer_load(load);
  const bool unloaded = answer_unload();
  const bool set = answer_set_qos();
  answer_list();
  return loaded || unloaded || set;
}

bool CompositionServices::answer_load(const Load& load) {
  bool changed = false;
  while (const auto call = load_.take()) {
    auto response = loaded(*call->request, load);
    if (!response.success()) log_.warn("load: {}", response.error_message());
    load_.reply(call->id, std::move(response));
    changed = true;
  }
  return changed;
}

bool CompositionServices::answer_unload() {
  bool changed = false;
  while (const auto call = unload_.take()) {
    const std::string id = std::to_string(call->request->unique_id());
    const bool known = call->request->unique_id() <= UINT32_MAX &&
                       instances_.has(static_cast<std::uint32_t>(call->request->unique_id()));
    const Outcome outcome =
        known ? instances_.unload(id) : Outcome{false, "No node found with unique_id: " + id};
    if (!outcome.done) log_.warn("unload: {}", outcome.text);
    composition_service::UnloadNode::Response response;
    response.success(outcome.done);
    if (!outcome.done) response.error_message(outcome.text);
    unload_.reply(call->id, std::move(response));
    changed = true;
  }
  return changed;
}

void CompositionServices::answer_list() {
  while (const auto call = list_.take()) {
    composition_service::ListNodes::Response response;
    for (const Instance& one : instances_.all()) {
      response.full_node_names().push_back(path_of(one.name));
      response.unique_ids().push_back(one.id);
    }
    list_.reply(call->id, std::move(response));
  }
}

bool CompositionServices::answer_set_qos() {
  bool changed = false;
  while (const auto call = set_qos_.take()) {
    const auto& request = *call->request;
    composition_service::SetQos::Response response;
    try {
      response.ends(static_cast<std::uint32_t>(owner_.bus().host_control().change_qos(
          {request.topic(), request.writers(), request.readers(), request.settings()})));
      response.success(true);
    } catch (const ConfigError& error) {
      response.message(error.what());
      log_.warn("set_qos: {}", error.what());
    }
    set_qos_.reply(call->id, std::move(response));
    changed = true;
  }
  return changed;
}

}  // namespace tocsin
