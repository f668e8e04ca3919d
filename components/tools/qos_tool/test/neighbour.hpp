// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <deque>
#include <fstream>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "foundation/error.hpp"
#include "ros_idl/std_msgs.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"
#include "runtime/middleware/qos_change.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::qos_tool {

/// A topic of the tests.
inline const Endpoint chatter{{"chatter", "chatter", Scope::host},
                              &type_info<std_msgs::msg::String>()};

/// A process on real DDS that writes or reads `chatter`, and obeys as a container does.
class Neighbour : private Receiver {
 public:
  struct Wish {
    bool writes = false;
    bool obeys = true;  ///< false: a program that is no container
  };
  Neighbour(int domain, const std::string& name, const std::string& qos, Wish wish)
      : name_(name), bus_(make_fast_dds_bus(options(domain, name, qos))) {
    if (wish.writes) {
      publication_ = bus_->advertise(chatter);
    } else {
      subscription_ = bus_->subscribe(chatter, nobody_);
    }
    if (!wish.obeys) return;
    commands_ = bus_->subscribe(
        {topic::ContainerCommand::info, &type_info<tocsin_msgs::msg::ContainerCommand>()}, *this);
    states_ = bus_->advertise(
        {topic::ContainerState::info, &type_info<tocsin_msgs::msg::ContainerState>()});
    thread_ = std::thread([this] { work(); });
  }
  ~Neighbour() override {
    ended_ = true;
    if (thread_.joinable()) thread_.join();
    commands_.reset();
  }
  Neighbour(const Neighbour&) = delete;
  Neighbour& operator=(const Neighbour&) = delete;

  /// What it was told, in order: `writers`, `readers`, `none`.
  [[nodiscard]] std::vector<std::string> told() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return told_;
  }
  [[nodiscard]] int matched() const {
    for (const EndpointHealth& one : bus_->health()) {
      if (one.topic == "chatter") return one.matched;
    }
    return 0;
  }

 private:
  using Command = tocsin_msgs::msg::ContainerCommand;
  struct Nobody : Receiver {
    void receive(const Sample&) override {}
  };

  static BusOptions options(int domain, const std::string& name, const std::string& qos) {
    BusOptions options;
    options.name = name;
    options.qos_file = ::testing::TempDir() + "neighbour_" + name + ".yaml";
    options.host_domain = domain;
    std::ofstream(options.qos_file)
        << "chatter: " << qos << "\nevent: {depth: 100}\nstate: {durability: transient_local}\n";
    return options;
  }
  void receive(const Sample& sample) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_.push_back(std::static_pointer_cast<const Command>(sample.message));
  }
  /// A listener must not change endpoints.
  void work() {
    while (!ended_) {
      std::shared_ptr<const Command> command;
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!waiting_.empty()) {
          command = waiting_.front();
          waiting_.pop_front();
        }
      }
      if (command && command->container() == name_) obey(*command);
      tell();
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
  void obey(const Command& command) {
    for (const auto& known : answers_) {
      if (known.id() == command.id()) return;
    }
    tocsin_msgs::msg::ContainerAnswer answer;
    answer.id(command.id());
    const std::string& ends = command.library();
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      told_.push_back(ends);
    }
    try {
      answer.text(std::to_string(bus_->change_qos(
          {command.name(), ends == "writers", ends == "readers", command.parameters()})));
      answer.done(true);
    } catch (const ConfigError& error) {
      answer.text(error.what());
    }
    answers_.push_back(answer);
  }
  void tell() {
    auto state = std::make_shared<tocsin_msgs::msg::ContainerState>();
    state->container(name_);
    state->answers() = answers_;
    (void)states_->write(state);
  }

  const std::string name_;
  std::unique_ptr<Bus> bus_;
  Nobody nobody_;
  std::unique_ptr<Publication> publication_;
  std::unique_ptr<Subscription> subscription_;
  std::mutex mutex_;
  std::deque<std::shared_ptr<const Command>> waiting_;
  std::vector<std::string> told_;
  std::vector<tocsin_msgs::msg::ContainerAnswer> answers_;
  std::atomic<bool> ended_{false};
  std::unique_ptr<Publication> states_;
  std::unique_ptr<Subscription> commands_;
  std::thread thread_;
};

}  // namespace tocsin::qos_tool
