// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <deque>
#include <fstream>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "foundation/error.hpp"
#include "ros_idl/std_msgs.hpp"
#include "runtime/host_control.hpp"
#include "runtime/middleware/container_states.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"
#include "runtime/middleware/qos_change.hpp"
#include "runtime/middleware/ros_services.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::qos_tool {

/// A topic of the tests.
inline const Endpoint chatter{{"chatter", "chatter", Scope::host},
                              &type_info<std_msgs::msg::String>()};

/// A process on real DDS that writes or reads `chatter`, and obeys as a container does.
class Neighbour : private ServerReceiver {
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
    server_ = bus_->serve({SetQos::name, &type_info<SetQos::Request>(),
                           &type_info<SetQos::Response>(), container_node(name)},
                          *this);
    states_ = bus_->advertise(
        {topic::ContainerState::info, &type_info<tocsin_msgs::msg::ContainerState>()});
    thread_ = std::thread([this] { work(); });
  }
  ~Neighbour() override {
    ended_ = true;
    if (thread_.joinable()) thread_.join();
    server_.reset();
  }
  Neighbour(const Neighbour&) = delete;
  Neighbour& operator=(const Neighbour&) = delete;

  /// What it was told, in order: `writers`, `readers`, `none`.
  [[nodiscard]] std::vector<std::string> told() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return told_;
  }
  [[nodiscard]] int matched() const {
    for (const EndpointHealth& one : bus_->host_control().health()) {
      if (one.topic == "chatter") return one.matched;
    }
    return 0;
  }

 private:
  using SetQos = composition_service::SetQos;
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
  void receive(ServiceRequest&& request) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_.push_back(std::move(request));
  }
  void wake() override {}
  /// A listener must not change endpoints.
  void work() {
    while (!ended_) {
      std::optional<ServiceRequest> request;
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!waiting_.empty()) {
          request = std::move(waiting_.front());
          waiting_.pop_front();
        }
      }
      if (request) obey(*request);
      server_->flush();
      tell();
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
  void obey(const ServiceRequest& asked) {
    const auto request = std::static_pointer_cast<const SetQos::Request>(asked.message);
    auto response = std::make_shared<SetQos::Response>();
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      told_.emplace_back(request->writers() ? "writers" : request->readers() ? "readers" : "none");
    }
    try {
      response->ends(static_cast<std::uint32_t>(bus_->host_control().change_qos(
          {request->topic(), request->writers(), request->readers(), request->settings()})));
      response->success(true);
    } catch (const ConfigError& error) {
      response->message(error.what());
    }
    server_->reply(asked.id, response);
  }
  void tell() {
    auto state = std::make_shared<tocsin_msgs::msg::ContainerState>();
    state->container(name_);
    (void)states_->write(state);
  }

  const std::string name_;
  std::unique_ptr<Bus> bus_;
  Nobody nobody_;
  std::unique_ptr<Publication> publication_;
  std::unique_ptr<Subscription> subscription_;
  std::mutex mutex_;
  std::deque<ServiceRequest> waiting_;
  std::vector<std::string> told_;
  std::atomic<bool> ended_{false};
  std::unique_ptr<Publication> states_;
  std::unique_ptr<ServerEnd> server_;
  std::thread thread_;
};

}  // namespace tocsin::qos_tool
