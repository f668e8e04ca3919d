// SPDX-License-Identifier: Apache-2.0
#include "runtime/sim_bus.hpp"

#include <algorithm>
#include <utility>

#include "foundation/error.hpp"
#include "runtime/host_control.hpp"
#include "runtime/middleware/local_services.hpp"
#include "runtime/middleware/topic_exchange.hpp"

namespace tocsin {
namespace {

constexpr Time start = Time{std::chrono::hours(1)};
constexpr std::int64_t start_wall_ns = 1'767'225'600'000'000'000;  // 2026-01-01 00:00 UTC

}  // namespace

/// The readers of one topic, and what its profile keeps for those who come late.
class SimBus::Topic {
 public:
  Topic(const Endpoint& endpoint, const QosProfile& qos)
      : type_(endpoint.type), keeps_(qos.keeps_last()), exchange_(requested(endpoint.topic, qos)) {}

  [[nodiscard]] const TypeInfo* type() const { return type_; }
  [[nodiscard]] TopicExchange& exchange() { return exchange_; }
  /// As on the real bus: nobody knows who comes late.
  [[nodiscard]] bool has_receivers() const { return keeps_ || exchange_.has_receivers(); }

  void add_writer(std::uint64_t source, const char* user_data) {
    writers_[source] = {{"simulated", user_data}, 0};
  }
  void remove_writer(std::uint64_t source) {
    exchange_.forget(source);
    writers_.erase(source);
  }
  [[nodiscard]] std::optional<WriterInfo> writer(std::uint64_t source) const {
    const auto found = writers_.find(source);
    return found != writers_.end() ? std::optional(found->second.info) : std::nullopt;
  }
  void deliver(Sample&& sample) {
    std::uint64_t& sequence = writers_.at(sample.source).sequence;
    exchange_.deliver(std::move(sample), sequence);
  }

 private:
  struct KnownWriter {
    WriterInfo info;
    std::uint64_t sequence;  ///< of its last sample
  };
  const TypeInfo* type_;
  const bool keeps_;
  TopicExchange exchange_;
  std::map<std::uint64_t, KnownWriter> writers_{{anybody, {{"anybody", ""}, 0}}};
};

class SimBus::Writer : public Publication {
 public:
  Writer(SimBus& bus, Topic& topic, const char* user_data)
      : bus_(bus), topic_(topic), source_(++bus.last_source_) {
    topic_.add_writer(source_, user_data);
  }
  ~Writer() override { topic_.remove_writer(source_); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  Status write(const std::shared_ptr<const void>& message) override {
    bus_.deliver(topic_, message, source_);
    return Status::ok;
  }
  [[nodiscard]] bool has_readers() const override { return topic_.has_receivers(); }

 private:
  SimBus& bus_;
  Topic& topic_;
  const std::uint64_t source_;
};

SimBus::SimBus() : now_(start), services_(std::make_unique<LocalServices>()) {}
SimBus::SimBus(const QosProfiles& profiles)
    : profiles_(profiles), now_(start), services_(std::make_unique<LocalServices>()) {}
SimBus::~SimBus() = default;

QosProfile SimBus::profile_of(const TopicInfo& topic) const {
  if (profiles_) return profiles_->of(topic.qos, topic.name);
  static const QosProfiles shipped;
  const auto found = shipped.all().find(topic.qos);
  return found != shipped.all().end() ? found->second : QosProfile{};
}

SimBus::Topic& SimBus::topic(const Endpoint& endpoint) {
  auto& found = topics_[endpoint.topic.name];
  if (!found) found = std::make_unique<Topic>(endpoint, profile_of(endpoint.topic));
  if (found->type() != endpoint.type) {
    throw ConfigError(std::string("topic ") + endpoint.topic.name + ": type " +
                      endpoint.type->name + " clashes with " + found->type()->name);
  }
  return *found;
}

std::unique_ptr<Subscription> SimBus::subscribe(const Endpoint& endpoint, Receiver& receiver) {
  class Attached : public Subscription {
   public:
    Attached(Topic& topic, Receiver& receiver, Time now) : topic_(topic), receiver_(receiver) {
      topic_.exchange().attach(receiver_, now);
    }
    ~Attached() override { topic_.exchange().detach(receiver_); }
    [[nodiscard]] std::optional<WriterInfo> writer(std::uint64_t source) const override {
      return topic_.writer(source);
    }

   private:
    Topic& topic_;
    Receiver& receiver_;
  };
  return std::make_unique<Attached>(topic(endpoint), receiver, now_);
}

std::unique_ptr<Publication> SimBus::advertise(const Endpoint& endpoint) {
  return std::make_unique<Writer>(*this, topic(endpoint), endpoint.user_data);
}

std::unique_ptr<ServerEnd> SimBus::serve(const ServiceEndpoint& endpoint,
                                         ServerReceiver& receiver) {
  return services_->serve(endpoint, receiver);
}

std::unique_ptr<ClientEnd> SimBus::call(const ServiceEndpoint& endpoint, ClientReceiver& receiver) {
  return services_->call(endpoint, receiver);
}

Callers SimBus::callers() const { return {false, services_->called()}; }

std::int64_t SimBus::wall_ns(Time t) const { return start_wall_ns + (t - start).count(); }

void SimBus::deliver(const Endpoint& endpoint, const std::shared_ptr<const void>& message) {
  deliver(topic(endpoint), message, anybody);
}

void SimBus::deliver(Topic& topic, const std::shared_ptr<const void>& message,
                     std::uint64_t source) {
  Sample sample;
  sample.source = source;
  sample.message = message;
  sample.received = now_;
  sample.sent_wall_ns = sample.received_wall_ns = wall_ns(now_);
  topic.deliver(std::move(sample));
}

void SimBus::add(Component& component) {
  components_.push_back(&component);
  component.schedule().begin_tick(now_);
  component.take_changes();
  component.tick(now_);
}

void SimBus::remove(const Component& component) {
  components_.erase(std::remove(components_.begin(), components_.end(), &component),
                    components_.end());
}

Time SimBus::next_deadline() const {
  Time next = never;
  for (Component* component : components_) next = std::min(next, component->schedule().due());
  return next;
}

void SimBus::tick_all_due() {
  bool ticked = true;
  while (ticked) {
    ticked = false;
    // By number: a tick may take components out and put others in.
    for (std::size_t i = 0; i < components_.size(); ++i) {
      Component* const component = components_[i];
      Schedule& schedule = component->schedule();
      if (!schedule.input_pending && schedule.due() > now_) continue;
      schedule.begin_tick(now_);
      component->take_changes();
      component->tick(now_);
      ticked = true;
    }
  }
}

void SimBus::run_until(Time end) {
  tick_all_due();
  for (Time next = next_deadline(); next <= end; next = next_deadline()) {
    now_ = std::max(now_, next);
    tick_all_due();
  }
  now_ = std::max(now_, end);
}

}  // namespace tocsin
