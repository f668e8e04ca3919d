// SPDX-License-Identifier: Apache-2.0
#include "operator_server/operator_server_component.hpp"

#include <utility>

#include "foundation/enum_words.hpp"
#include "foundation/error.hpp"
#include "foundation/names.hpp"
#include "foundation/printable.hpp"
#include "listening_socket.hpp"
#include "operator_server/parameter_value.hpp"
#include "runtime/component_entry.hpp"
#include "runtime/host_control.hpp"
#include "runtime/middleware/idl_libraries.hpp"
#include "server_settings.hpp"
#include "web_server.hpp"

namespace tocsin {
namespace {

using foxglove::ClientId;
using foxglove::Level;

constexpr Duration try_again_period = std::chrono::seconds(5);
constexpr Duration look_period = std::chrono::milliseconds(500);
constexpr Duration report_period = std::chrono::seconds(1);
constexpr std::size_t bytes_at_once = std::size_t{64} << 10U;  ///< under way to a client
constexpr std::size_t longest_operator = 60;  ///< of a name, as the vehicle reports it

/// What `ros2 param` hears of changes, in no namespace.
constexpr TopicInfo parameter_events{"/parameter_events", "event", Scope::host};

/// Looks at the host's domain by a participant of its own, which is made at the first look.
foxglove::LookAtHost look_at(Bus& bus) {
  return [&host = bus.host_control(), graph = std::shared_ptr<HostGraph>()]() mutable {
    try {
      if (!graph) graph = host.open_graph();
    } catch (const EnvironmentError&) {
      return foxglove::HostPicture{};  // the next look tries again
    }
    if (!graph) return foxglove::stated_picture(host.ros_namespace());
    return foxglove::picture_of(graph->ends(), graph->nodes(), host.ros_namespace());
  };
}

}  // namespace

OperatorServerComponent::OperatorServerComponent(Context& context, const Params& params)
    : OperatorServerComponent(context, params, look_at(context.bus)) {}

OperatorServerComponent::OperatorServerComponent(Context& context, const Params& params,
                                                 foxglove::LookAtHost look)
    : Component(context),
      params_(params),
      look_(std::move(look)),
      hub_(foxglove::hub_settings(context, params)),
      services_(*this, seconds(params.service_timeout_s)),
      parameters_(*this, seconds(params.service_timeout_s)) {
  // Each event is dealt with on this component's thread, before its next tick.
  foxglove::WebEvents events;
  events.opened = [this](ClientId client, const foxglove::WebPeer& peer) {
    post([this, client, peer] { on_opened(client, peer); });
  };
  events.received = [this](ClientId client, foxglove::Frame::Kind kind, std::string&& bytes) {
    post([this, client, kind, bytes = std::move(bytes)] { on_received(client, kind, bytes); });
  };
  events.sent = [this](ClientId client) { post([this, client] { busy_.erase(client); }); };
  events.closed = [this](ClientId client, const std::string& why) {
    post([this, client, why] { on_closed(client, why); });
  };
  events.refused = [this](const std::string& what) {
    post([this, what] { log().warn("refused a connection: {}", what); });
  };
  web_ = std::make_unique<foxglove::WebServer>(foxglove::web_settings(context, params),
                                               std::move(events));
}

OperatorServerComponent::~OperatorServerComponent() = default;

/// Where nobody can look, as in simulated time, nothing is served. A port that is taken is tried
/// again: what else runs here does not depend on it.
void OperatorServerComponent::serve(Time now) {
  if (port_ != 0 || !context().computer.get().has_spectators) return;
  if (now < next_try_) return wake_at(next_try_);
  auto listening = foxglove::open_listening_socket(params_.address, params_.port);
  if (listening.socket) {
    load_idl_libraries();
    port_ = listening.port;
    web_->start(std::move(listening.socket));
    log().info("serves {}://{}:{}/", params_.certificate.empty() ? "http" : "https",
               params_.address, port_);
    return;
  }
  if (!std::exchange(said_fault_, true)) {
    log().warn("cannot listen at {}:{}: {}; tried again each 5 s, all else goes on",
               params_.address, params_.port, listening.fault);
  }
  next_try_ = now + try_again_period;
  wake_at(next_try_);
}

void OperatorServerComponent::on_opened(ClientId client, const foxglove::WebPeer& peer) {
  log().info("client {} from {}, {}", client, peer.address, word_of(peer.role));
  open_.insert(client);
  hub_.add_client(client, static_cast<std::uint64_t>(bus().wall_ns(bus().now())), peer.role);
}

void OperatorServerComponent::on_received(ClientId client, foxglove::Frame::Kind kind,
                                          const std::string& bytes) {
  const Time now = bus().now();
  obey(hub_.on_frame(client, kind, bytes), now);
  web_->read_on(client);
}

void OperatorServerComponent::on_closed(ClientId client, const std::string& why) {
  log().info("client {} has gone: {}", client, why);
  open_.erase(client);
  busy_.erase(client);
  hub_.remove_client(client);
  guard_.forget(client);
}

/// Does what clients want of the host.
struct OperatorServerComponent::Obey {
  OperatorServerComponent& self;
  Time now;
  void operator()(const foxglove::OpenTopic& order) const {
    const std::string fault = self.topics_.open(order.channel);
    if (!fault.empty()) self.hub_.refuse_topic(order.client, order.channel.id, fault);
  }
  void operator()(const foxglove::WriteMessage& order) const {
    const auto written = self.topics_.write(order);
    if (!written.fault.empty()) self.hub_.tell(order.client, Level::error, written.fault);
    if (!written.by_operator) return;
    self.guard_.on_operator(order.client, printable(*written.by_operator, longest_operator));
  }
  void operator()(const foxglove::AskParameters& order) const {
    self.parameters_.ask(order, self.hub_, now);
  }
  void operator()(const foxglove::ChangeParameters& order) const {
    self.parameters_.change(order, self.hub_, now);
  }
  void operator()(const foxglove::AskService& order) const {
    const std::string refusal = self.guard_.refusal(order.client, order.name, now);
    if (!refusal.empty()) return self.hub_.fail_service(order.client, order.call, refusal);
    self.services_.call(order, self.hub_, now);
  }
};

void OperatorServerComponent::obey(const std::vector<foxglove::Order>& orders, Time now) {
  for (const foxglove::Order& order : orders) std::visit(Obey{*this, now}, order);
}

void OperatorServerComponent::tick(Time now) {
  serve(now);
  take_states(now);
  take_parameter_events();
  services_.take(hub_, now);
  parameters_.take(hub_, now);
  if (hub_.clients() > 0) do_periodic(now);
  follow_clients();
  topics_.take(hub_);
  send_waiting();
}

void OperatorServerComponent::take_states(Time now) {
  while (const auto state = driver_ ? driver_->take() : nullptr) {
    guard_.on_driver(printable(state->driver(), longest_operator), now);
  }
  while (const auto state = containers_.take()) {
    std::set<std::string>& nodes = nodes_[state->host() + "/" + state->container()];
    nodes.clear();
    for (const auto& one : state->components()) nodes.insert(one.name());
    std::set<std::string> all;
    for (const auto& entry : nodes_) all.insert(entry.second.begin(), entry.second.end());
    parameters_.set_nodes(all);
  }
}

void OperatorServerComponent::take_parameter_events() {
  if (!parameter_events_) return;
  while (const auto sample = parameter_events_->take_sample()) {
    const auto event =
        std::static_pointer_cast<const rcl_interfaces::msg::ParameterEvent>(sample->message);
    std::vector<foxglove::Parameter> values;
    for (const auto& one : event->changed_parameters()) {
      values.push_back(foxglove::shown_parameter(
          foxglove::joined_parameter_name({without_slash(event->node()), one.name()}),
          one.value()));
    }
    hub_.on_parameters(values);
  }
}

void OperatorServerComponent::look(Time now) {
  next_look_ = now + look_period;
  const foxglove::HostPicture picture = look_();
  std::vector<foxglove::Channel> channels;
  for (const auto& topic : picture.topics) channels.push_back(foxglove::channel_of(topic));
  std::vector<foxglove::Service> services;
  for (const auto& service : picture.services) services.push_back(foxglove::service_of(service));
  topics_.set_topics(picture.topics);
  services_.set_services(picture.services);
  hub_.set_channels(channels);
  hub_.set_services(services);
  hub_.set_graph(picture.graph);
}

void OperatorServerComponent::do_periodic(Time now) {
  if (now >= next_look_) look(now);
  if (now >= next_time_) {
    next_time_ = next_instant(seconds(params_.time_s), now);
    hub_.tell_time(static_cast<std::uint64_t>(bus().wall_ns(now)));
  }
  if (now >= next_report_) {
    next_report_ = next_instant(report_period, now);
    hub_.tell_drops();
  }
  for (const Time next : {next_look_, next_time_, next_report_}) wake_at(next);
}

/// Reads and writes what clients want now, and nothing else.
void OperatorServerComponent::follow_clients() {
  std::vector<std::string> faults;
  topics_.read(hub_.heard(), faults);
  for (const std::string& fault : faults) log().warn("not read: {}", fault);
  topics_.keep(hub_.written());
  if (hub_.clients() == 0) driver_.reset();
  if (hub_.clients() > 0 && !driver_) driver_.emplace(*this);
  if (hub_.wants_parameters() == (parameter_events_ != nullptr)) return;
  parameter_events_ =
      hub_.wants_parameters()
          ? std::make_unique<InputPort>(
                *this, Endpoint{parameter_events, &type_info<rcl_interfaces::msg::ParameterEvent>(),
                                Writers::optional})
          : nullptr;
}

void OperatorServerComponent::send_waiting() {
  for (const ClientId client : hub_.overflown()) {
    web_->close(client, "it does not read what it is sent");
    on_closed(client, "it does not read what it is sent");
  }
  for (const ClientId client : open_) {
    if (busy_.count(client) != 0) continue;
    auto frames = hub_.take(client, bytes_at_once);
    if (frames.empty()) continue;
    busy_.insert(client);
    web_->send(client, std::move(frames));
  }
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::OperatorServerComponent)
