// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <fstream>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "runtime/host_control.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"

namespace tocsin {

constexpr auto patience = std::chrono::seconds(8);

/// Collects samples and waits for them.
class Samples : public Receiver {
 public:
  void receive(const Sample& sample) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    samples_.push_back(sample);
    changed_.notify_all();
  }
  [[nodiscard]] bool wait_for(std::size_t wanted) {
    std::unique_lock<std::mutex> lock(mutex_);
    return changed_.wait_for(lock, patience, [&] { return samples_.size() >= wanted; });
  }
  [[nodiscard]] std::vector<Sample> all() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return samples_;
  }
  void clear() {
    const std::lock_guard<std::mutex> lock(mutex_);
    samples_.clear();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Sample> samples_;
};

/// A bus on loopback with the QoS file `qos`.
inline std::unique_ptr<Bus> make_test_bus(int domain, const std::string& qos) {
  const std::string path = ::testing::TempDir() + "bus_test_" + std::to_string(getpid());
  std::ofstream(path + "_qos.yaml") << qos;
  std::ofstream(path + "_traffic.yaml") << "uxv: {}\n";
  BusOptions options;
  options.name = "test";
  options.role = Role::uxv;
  options.qos_file = path + "_qos.yaml";
  options.traffic_file = path + "_traffic.yaml";
  options.host_domain = domain;
  auto bus = make_fast_dds_bus(options);
  unlink(options.qos_file.c_str());
  unlink(options.traffic_file.c_str());
  return bus;
}

/// The health of the reader or the writer of `topic`; an empty one when there is none.
inline EndpointHealth health_of(Bus& bus, const std::string& topic, bool writer) {
  for (const EndpointHealth& one : bus.host_control().health()) {
    if (one.topic == topic && one.writer == writer) return one;
  }
  return {};
}

/// Waits on a condition of the world outside.
template <class Condition>
bool eventually(const Condition& condition) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

}  // namespace tocsin
