// SPDX-License-Identifier: Apache-2.0
#include "runtime/sim_bus.hpp"

#include <algorithm>
#include <string_view>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

constexpr Time start = Time{std::chrono::hours(1)};
constexpr std::int64_t start_wall_ns = 1'767'225'600'000'000'000;  // 2026-01-01 00:00 UTC

}  // namespace

/// The readers of one topic, and its last sample for those who come late to a `state` topic.
class SimBus::Topic {
 public:
  explicit Topic(const Endpoint& endpoint) : endpoint_(endpoint) {}

  [[nodiscard]] const TypeInfo* type() const { return endpoint_.type; }

  void attach(Receiver& receiver) {
    receivers_.push_back(&receiver);
    if (keeps_last() && last_.message) receiver.receive(last_);
  }

  void detach(Receiver& receiver) {
    receivers_.erase(std::remove(receivers_.begin(), receivers_.end(), &receiver),
                     receivers_.end());
  }

  void add_writer(std::uint64_t source, const char* user_data) {
    writers_[source] = {"simulated", user_data};
  }

  void remove_writer(std::uint64_t source) { writers_.erase(source); }

  [[nodiscard]] std::optional<WriterInfo> writer(std::uint64_t source) const {
    const auto found = writers_.find(source);
    return found != writers_.end() ? std::optional(found->second) : std::nullopt;
  }

  [[nodiscard]] bool has_receivers() const { return !receivers_.empty() || keeps_last(); }

  void deliver(Sample sample) {
    sample.sequence = last_.sequence + 1;
    last_ = sample;
    for (Receiver* receiver : receivers_) receiver->receive(sample);
  }

 private:
  [[nodiscard]] bool keeps_last() const {
    return std::string_view(endpoint_.topic.qos) == "state" &&
           endpoint_.topic.requests == Requests::profile;
  }
  Endpoint endpoint_;
  std::vector<Receiver*> receivers_;
  std::map<std::uint64_t, WriterInfo> writers_{{anybody, {"anybody", ""}}};
  Sample last_;
};

class SimBus::Writer : public Publication {
 public:
  Writer(SimBus& bus, const Endpoint& endpoint)
      : bus_(bus), endpoint_(endpoint), source_(++bus.last_source_) {
    bus_.topic(endpoint_).add_writer(source_, endpoint.user_data);
  }
  ~Writer() override { bus_.topic(endpoint_).remove_writer(source_); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  Status write(const std::shared_ptr<const void>& message) override {
    bus_.deliver(endpoint_, message, source_);
    return Status::ok;
  }
  [[nodiscard]] bool has_readers() const override { return bus_.topic(endpoint_).has_receivers(); }

 private:
  SimBus& bus_;
  Endpoint endpoint_;
  const std::uint64_t source_;
};

SimBus::SimBus() : now_(start) {}
SimBus::~SimBus() = default;

SimBus::Topic& SimBus::topic(const Endpoint& endpoint) {
  auto& found = topics_[endpoint.topic.name];
  if (!found) found = std::make_unique<Topic>(endpoint);
  if (found->type() != endpoint.type) {
    throw ConfigError(std::string("topic ") + endpoint.topic.name + ": type " +
                      endpoint.type->name + " clashes with " + found->type()->name);
  }
  return *found;
}

std::unique_ptr<Subscription> SimBus::subscribe(const Endpoint& endpoint, Receiver& receiver) {
  class Attached : public Subscription {
   public:
    Attached(Topic& topic, Receiver& receiver) : topic_(topic), receiver_(receiver) {
      topic_.attach(receiver_);
    }
    ~Attached() override { topic_.detach(receiver_); }
    [[nodiscard]] std::optional<WriterInfo> writer(std::uint64_t source) const override {
      return topic_.writer(source);
    }

   private:
    Topic& topic_;
    Receiver& receiver_;
  };
  return std::make_unique<Attached>(topic(endpoint), receiver);
}

std::unique_ptr<Publication> SimBus::advertise(const Endpoint& endpoint) {
  return std::make_unique<Writer>(*this, endpoint);
}

std::int64_t SimBus::wall_ns(Time t) const { return start_wall_ns + (t - start).count(); }

void SimBus::deliver(const Endpoint& endpoint, const std::shared_ptr<const void>& message,
                     std::uint64_t source) {
  Sample sample;
  sample.source = source;
  sample.message = message;
  sample.received = now_;
  sample.sent_wall_ns = sample.received_wall_ns = wall_ns(now_);
  topic(endpoint).deliver(sample);
}

void SimBus::add(Component& component) {
  components_.push_back(&component);
  component.schedule().begin_tick(now_);
  component.tick(now_);
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
    for (Component* component : components_) {
      Schedule& schedule = component->schedule();
      if (!schedule.input_pending && schedule.due() > now_) continue;
      schedule.begin_tick(now_);
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
