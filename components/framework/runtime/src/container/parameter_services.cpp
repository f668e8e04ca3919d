// SPDX-License-Identifier: Apache-2.0
#include "container/parameter_services.hpp"

namespace tocsin {
namespace {

constexpr int depth = 1000;  // as ROS 2's parameter services

rcl_interfaces::msg::SetParametersResult result_of(const Outcome& outcome) {
  rcl_interfaces::msg::SetParametersResult result;
  result.successful(outcome.done);
  if (!outcome.done) result.reason(outcome.text);
  return result;
}

/// A name that no parameter has: not set.
RosValue value_of(const std::vector<ParameterFacts>& facts, const std::string& name) {
  const ParameterFacts* const found = find_parameter(facts, name);
  return found != nullptr ? ros_value(found->value) : RosValue();
}

rcl_interfaces::msg::ParameterDescriptor description_of(const std::vector<ParameterFacts>& facts,
                                                        const std::string& name) {
  if (const ParameterFacts* const found = find_parameter(facts, name)) return describe(*found);
  rcl_interfaces::msg::ParameterDescriptor unknown;
  unknown.name(name);
  return unknown;
}

/// Replies to every request of a port with what `make` makes of it.
template <class Port, class Make>
void reply_all(Port& port, const Make& make) {
  while (const auto call = port.take()) {
    typename Port::Response response;
    make(*call->request, response);
    port.reply(call->id, std::move(response));
  }
}

}  // namespace

ParameterServices::ParameterServices(Component& owner, const std::string& node)
    : describe_(owner, parameter_service::DescribeParameters::name, node, depth),
      get_(owner, parameter_service::GetParameters::name, node, depth),
      types_(owner, parameter_service::GetParameterTypes::name, node, depth),
      list_(owner, parameter_service::ListParameters::name, node, depth),
      set_(owner, parameter_service::SetParameters::name, node, depth),
      set_atomically_(owner, parameter_service::SetParametersAtomically::name, node, depth) {}

void ParameterServices::answer_readers(const ParameterSource& source) {
  reply_all(describe_, [&](const auto& request, auto& response) {
    const auto facts = source.facts();
    for (const std::string& name : request.names()) {
      response.descriptors().push_back(description_of(facts, name));
    }
  });
  reply_all(get_, [&](const auto& request, auto& response) {
    const auto facts = source.facts();
    for (const std::string& name : request.names()) {
      response.values().push_back(value_of(facts, name));
    }
  });
  reply_all(types_, [&](const auto& request, auto& response) {
    const auto facts = source.facts();
    for (const std::string& name : request.names()) {
      response.types().push_back(value_of(facts, name).type());
    }
  });
  reply_all(list_, [&](const auto& request, auto& response) {
    response.result(list_parameters(source.facts(), request));
  });
}

void ParameterServices::answer(const ParameterSource& source) {
  reply_all(set_, [&](const auto& request, auto& response) {
    for (const auto& one : request.parameters()) {
      response.results().push_back(result_of(source.set({one})));
    }
  });
  reply_all(set_atomically_, [&](const auto& request, auto& response) {
    response.result(result_of(source.set(request.parameters())));
  });
  answer_readers(source);
}

}  // namespace tocsin
