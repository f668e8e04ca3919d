// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <list>
#include <memory>
#include <string>
#include <vector>

#include "container/lifecycle.hpp"
#include "runtime/component_entry.hpp"
#include "runtime/middleware/ros_parameters.hpp"
#include "runtime/middleware/tick_account.hpp"

namespace tocsin {

/// Ticks components: threads in a container, the clock of a simulation in a test.
class Ticker {
 public:
  virtual ~Ticker() = default;
  virtual void add(Component& component, TickAccount& account) = 0;
  /// False when its tick does not end; it is still ticked then.
  [[nodiscard]] virtual bool remove(Component& component) = 0;
};

/// One component of a container.
struct Instance {
  std::uint32_t id = 0;
  std::string library;
  std::string name;
  std::shared_ptr<const YAML::Node> parameters;
  YamlSources sources;  ///< of the parameters
  LifecycleState state = LifecycleState::unconfigured;
  std::string error;
  std::unique_ptr<Context> context;
  std::unique_ptr<TickAccount> account;
  std::unique_ptr<Component> component;  ///< null unless inactive, active or in error
};

/// What became of a request, in one line for the user.
struct Outcome {
  bool done;
  std::string text;
};

/// The instances of one container and their lifecycle. One thread.
class Instances {
 public:
  using Find = std::function<const ComponentEntry&(const std::string& library)>;
  /// `home` is copied for each instance, with its name. `find` throws ConfigError.
  Instances(Context home, Ticker& ticker, Find find);
  /// Takes them from the ticker, then destroys them in reverse order.
  ~Instances();
  Instances(const Instances&) = delete;
  Instances& operator=(const Instances&) = delete;

  /// At start-up: constructs an inactive instance. Throws what its constructor throws.
  void add(const std::string& library, const std::string& name,
           std::shared_ptr<const YAML::Node> parameters, const YamlSources& sources);
  void activate_all();

  /// At run time: nothing throws. `parameters` is a YAML map, or empty.
  Outcome load(const std::string& library, const std::string& name, const std::string& parameters);
  /// `name` may also be the id.
  Outcome unload(const std::string& name);
  Outcome change(const std::string& name, Transition transition);
  /// Its parameters as they are; none when its library does not tell.
  [[nodiscard]] std::vector<ParameterFacts> parameters(const Instance& instance) const;
  /// Those of `given` that are live: what set_parameters changes.
  [[nodiscard]] std::vector<rcl_interfaces::msg::Parameter> live_of(
      const Instance& instance, const std::vector<rcl_interfaces::msg::Parameter>& given) const;
  /// All of them or none; one that is not live is refused, unless it has the value already.
  Outcome set_parameters(std::uint32_t id,
                         const std::vector<rcl_interfaces::msg::Parameter>& given);
  /// Puts those whose tick threw into the state error. True when there were some.
  bool settle_failures();

  [[nodiscard]] const std::list<Instance>& all() const { return all_; }
  [[nodiscard]] bool has(std::uint32_t id) const {
    return std::any_of(all_.begin(), all_.end(), [=](const auto& one) { return one.id == id; });
  }

 private:
  Instance& append(const std::string& library, const std::string& name);
  Instance* find(const std::string& name);
  void construct(Instance& instance);
  Outcome apply(Instance& instance, Transition transition);
  Outcome configure(Instance& instance);
  [[nodiscard]] std::string refusal(const Instance& instance,
                                    const std::vector<rcl_interfaces::msg::Parameter>& given) const;
  bool quieten(Instance& instance);

  const Context home_;
  Ticker& ticker_;
  const Find find_;
  std::uint32_t last_id_ = 0;
  std::list<Instance> all_;
};

}  // namespace tocsin
