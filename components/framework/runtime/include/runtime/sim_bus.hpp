// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/bus.hpp"
#include "runtime/component.hpp"
#include "runtime/host_control.hpp"
#include "runtime/middleware/qos_profile.hpp"

namespace tocsin {

class LocalServices;

/// A bus in memory with virtual time and one thread: what component tests run on. Late readers, and
/// readers of what has outlived its lifespan, get what the profile of the topic promises.
///
///     SimBus bus;
///     Context context{bus, "link_monitor", Role::uxv};
///     LinkMonitorComponent sut(context, {});
///     SimReader<topic::LinkState> states(bus);
///     bus.add(sut);
///     bus.publish<topic::LinkSample>(sample);
///     bus.run_for(seconds(1));
///     EXPECT_EQ(states.take().size(), 1U);
class SimBus : public Bus, private HostControl {
 public:
  /// Virtual time starts at one hour, wall time at 2026-01-01 00:00 UTC. Topics have the shipped
  /// profiles; one with a profile of another name has what DDS has by default.
  SimBus();
  /// The same with the profiles of a QoS file; a topic whose profile it has not is a ConfigError.
  explicit SimBus(const QosProfiles& profiles);
  ~SimBus() override;

  std::unique_ptr<Subscription> subscribe(const Endpoint& endpoint, Receiver& receiver) override;
  std::unique_ptr<Publication> advertise(const Endpoint& endpoint) override;
  std::unique_ptr<ServerEnd> serve(const ServiceEndpoint& endpoint,
                                   ServerReceiver& receiver) override;
  std::unique_ptr<ClientEnd> call(const ServiceEndpoint& endpoint,
                                  ClientReceiver& receiver) override;
  [[nodiscard]] HostControl& host_control() override { return *this; }
  [[nodiscard]] Time now() const override { return now_; }
  [[nodiscard]] std::int64_t wall_ns(Time t) const override;

  /// From now on `component` is ticked by run_until, first at once. It must outlive the runs, or
  /// be removed.
  void add(Component& component);
  /// Ticks it no more. Also from a tick, of another.
  void remove(const Component& component);
  /// Ticks every component in the order of inputs and deadlines, then sets the clock to `end`.
  void run_until(Time end);
  void run_for(Duration duration) { run_until(now_ + duration); }

  /// Delivers a message as if another component had written it, which is always there.
  template <class Topic>
  void publish(typename Topic::Message message) {
    deliver({Topic::info, &type_info<typename Topic::Message>()},
            std::make_shared<const typename Topic::Message>(std::move(message)));
  }

 private:
  [[nodiscard]] Callers callers() const override;
  class Topic;
  class Writer;
  static constexpr std::uint64_t anybody = 1;
  void deliver(const Endpoint& endpoint, const std::shared_ptr<const void>& message);
  void deliver(Topic& topic, const std::shared_ptr<const void>& message, std::uint64_t source);
  Topic& topic(const Endpoint& endpoint);
  [[nodiscard]] QosProfile profile_of(const TopicInfo& topic) const;
  void tick_all_due();
  [[nodiscard]] Time next_deadline() const;

  const std::optional<QosProfiles> profiles_;
  Time now_;
  std::unique_ptr<LocalServices> services_;
  std::uint64_t last_source_ = anybody;
  std::map<std::string, std::unique_ptr<Topic>> topics_;
  std::vector<Component*> components_;
};

/// A writer of its own, as of another process; gone when this is destroyed. `data`: its user data.
template <class Topic>
class SimWriter {
 public:
  explicit SimWriter(SimBus& bus, const char* data = "")
      : end_{Topic::info, &type_info<typename Topic::Message>(), Writers::needed, data},
        publication_(bus.advertise(end_)) {}
  Status write(typename Topic::Message message) {
    return publication_->write(std::make_shared<const typename Topic::Message>(std::move(message)));
  }

 private:
  const Endpoint end_;
  const std::unique_ptr<Publication> publication_;
};

/// Collects what is written to a topic.
template <class Topic>
class SimReader : private Receiver {
 public:
  using Message = typename Topic::Message;
  explicit SimReader(SimBus& bus)
      : subscription_(bus.subscribe({Topic::info, &type_info<Message>()}, *this)) {}

  /// What came since the last call.
  std::vector<Message> take() { return std::exchange(messages_, {}); }

 private:
  void receive(const Sample& sample) override {
    messages_.push_back(*std::static_pointer_cast<const Message>(sample.message));
  }
  std::vector<Message> messages_;
  std::unique_ptr<Subscription> subscription_;
};

}  // namespace tocsin
