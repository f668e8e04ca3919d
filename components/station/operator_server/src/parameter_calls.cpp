// SPDX-License-Identifier: Apache-2.0
#include "operator_server/parameter_calls.hpp"

#include <algorithm>

#include "foundation/printable.hpp"
#include "operator_server/parameter_value.hpp"
#include "runtime/middleware/ros_services.hpp"

namespace tocsin::foxglove {
namespace {

namespace service = parameter_service;
constexpr Duration kept_for = std::chrono::seconds(30);

template <class Service>
ServiceEndpoint endpoint_of(const std::string& node, const std::string& owner) {
  const std::string name = Service::name;  // ~/...
  return {node + name.substr(1), &type_info<typename Service::Request>(),
          &type_info<typename Service::Response>(), owner};
}

template <class Service>
const typename Service::Response& as(const std::shared_ptr<const void>& response) {
  return *static_cast<const typename Service::Response*>(response.get());
}

}  // namespace

ParameterCalls::Caller& ParameterCalls::caller(const Where& where) {
  const auto found = callers_.find(where);
  if (found != callers_.end()) return found->second;
  const auto& [node, kind] = where;
  const std::string& owner = owner_.node();
  const ServiceEndpoint endpoint =
      kind == Kind::list  ? endpoint_of<service::ListParameters>(node, owner)
      : kind == Kind::get ? endpoint_of<service::GetParameters>(node, owner)
                          : endpoint_of<service::SetParameters>(node, owner);
  return callers_.emplace(where, Caller{std::make_unique<AnyClient>(owner_, endpoint)})
      .first->second;
}

void ParameterCalls::call(const Where& where, Message request, Pending pending, Time now) {
  Caller& to = caller(where);
  ++jobs_.at(pending.job).open;
  to.last_used = now;
  const CallNumber number = to.client->call_message(std::move(request), now + patience_);
  to.pending.emplace(number, std::move(pending));
}

void ParameterCalls::list(const std::string& node, JobNumber job, Time now) {
  call({node, Kind::list}, std::make_shared<service::ListParameters::Request>(), {job, {}}, now);
}

void ParameterCalls::get(const std::string& node, std::vector<std::string> names, JobNumber job,
                         Time now) {
  const auto request = std::make_shared<service::GetParameters::Request>();
  request->names(names);
  call({node, Kind::get}, request, {job, std::move(names)}, now);
}

void ParameterCalls::ask(const AskParameters& order, Hub& hub, Time now) {
  const JobNumber job = ++last_job_;
  jobs_[job] = {order.client, order.wish.id};
  std::map<std::string, std::vector<std::string>> wanted;
  for (const std::string& name : order.wish.names) {
    const auto split = split_parameter_name(name);
    if (split && nodes_.count(split->node) != 0) {
      wanted[split->node].push_back(split->parameter);
    } else {
      hub.tell(order.client, Level::error,
               "getParameters: there is no node with '" + printable(name) +
                   "'; a name is /node.parameter");
    }
  }
  for (auto& [node, names] : wanted) get(node, std::move(names), job, now);
  if (order.wish.names.empty()) {
    for (const std::string& node : nodes_) list(node, job, now);
  }
  finish(job, hub);
}

void ParameterCalls::change(const ChangeParameters& order, Hub& hub, Time now) {
  const JobNumber job = ++last_job_;
  jobs_[job] = {order.client, order.wish.id};
  std::map<std::string, service::SetParameters::Request> wanted;
  for (const Parameter& parameter : order.wish.parameters) {
    const auto split = split_parameter_name(parameter.name);
    const auto type = types_.find(parameter.name);
    const auto value = given_value(parameter, type == types_.end() ? 0 : type->second);
    if (!split || nodes_.count(split->node) == 0 || !value) {
      hub.tell(order.client, Level::error,
               "setParameters: '" + printable(parameter.name) + "' " +
                   (value ? "is of no node here; a name is /node.parameter"
                          : "has a value that no parameter can have"));
      continue;
    }
    rcl_interfaces::msg::Parameter one;
    one.name(split->parameter);
    one.value(*value);
    wanted[split->node].parameters().push_back(one);
  }
  for (auto& [node, request] : wanted) {
    std::vector<std::string> names;
    for (const auto& one : request.parameters()) names.push_back(one.name());
    call({node, Kind::set}, std::make_shared<service::SetParameters::Request>(std::move(request)),
         {job, std::move(names)}, now);
  }
  finish(job, hub);
}

void ParameterCalls::take(Hub& hub, Time now) {
  std::vector<std::pair<Where, std::pair<Pending, Message>>> came;
  for (auto one = callers_.begin(); one != callers_.end();) {
    Caller& from = one->second;
    while (const auto outcome = from.client->take_outcome(now)) {
      const auto pending = from.pending.find(outcome->call);
      if (pending == from.pending.end()) continue;
      came.push_back({one->first, {std::move(pending->second), outcome->message}});
      from.pending.erase(pending);
    }
    const bool stays = !from.pending.empty() || now - from.last_used < kept_for;
    one = stays ? std::next(one) : callers_.erase(one);
  }
  for (const auto& [where, answer] : came) on_answer(where, answer.first, answer.second, hub, now);
}

void ParameterCalls::on_answer(const Where& where, const Pending& pending, const Message& response,
                               Hub& hub, Time now) {
  const auto& [node, kind] = where;
  Job& job = jobs_.at(pending.job);
  --job.open;
  if (response == nullptr) {
    hub.tell(job.client, Level::warning, "/" + node + ": did not answer for its parameters");
  } else if (kind == Kind::list) {
    auto names = as<service::ListParameters>(response).result().names();
    if (!names.empty()) get(node, std::move(names), pending.job, now);
  } else if (kind == Kind::get) {
    on_values(node, pending, response);
  } else {
    on_set(node, pending, response, hub);
    get(node, pending.names, pending.job, now);  // what they are now
  }
  finish(pending.job, hub);
}

void ParameterCalls::on_values(const std::string& node, const Pending& pending,
                               const Message& response) {
  const auto& values = as<service::GetParameters>(response).values();
  const std::size_t count = std::min(values.size(), pending.names.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::string name = joined_parameter_name({node, pending.names[i]});
    types_[name] = values[i].type();
    jobs_.at(pending.job).values.push_back(shown_parameter(name, values[i]));
  }
}

void ParameterCalls::on_set(const std::string& node, const Pending& pending,
                            const Message& response, Hub& hub) {
  const auto& results = as<service::SetParameters>(response).results();
  const std::size_t count = std::min(results.size(), pending.names.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (results[i].successful()) continue;
    hub.tell(
        jobs_.at(pending.job).client, Level::error,
        joined_parameter_name({node, pending.names[i]}) + ": " + printable(results[i].reason()));
  }
}

void ParameterCalls::finish(JobNumber number, Hub& hub) {
  const auto found = jobs_.find(number);
  if (found->second.open > 0) return;
  hub.answer_parameters(found->second.client, found->second.values, found->second.id);
  jobs_.erase(found);
}

}  // namespace tocsin::foxglove
