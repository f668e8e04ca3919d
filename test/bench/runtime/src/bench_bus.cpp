// SPDX-License-Identifier: Apache-2.0
#include "bench_bus.hpp"

#include <unistd.h>

#include <chrono>
#include <fstream>

#include "runtime/middleware/fast_dds_bus.hpp"

namespace tocsin::bench {
namespace {

const char* const raw_timing =
    ", heartbeat_period_s: 3, nack_response_delay_s: 0.005, heartbeat_response_delay_s: 0.005";

std::string file(const std::string& name, const std::string& text) {
  std::string path = "/tmp/runtime_bench_" + std::to_string(getpid()) + name;
  std::ofstream(path) << text;
  return path;
}

}  // namespace

std::unique_ptr<Bus> make_bench_bus(const std::string& name, int domain, Timing timing) {
  BusOptions options;
  options.name = name;
  options.role = Role::uxv;
  options.qos_file =
      file("qos.yaml", "bench: {reliability: reliable, depth: 4" +
                           std::string(timing == Timing::raw ? raw_timing : "") + "}\n");
  options.traffic_file = file("traffic.yaml", "uxv: {}\n");
  options.host_domain = domain;
  auto bus = make_fast_dds_bus(options);
  unlink(options.qos_file.c_str());
  unlink(options.traffic_file.c_str());
  return bus;
}

std::shared_ptr<const Blob> blob(std::size_t bytes) {
  auto message = std::make_shared<Blob>();
  message->data().resize(bytes);
  return message;
}

void Ping::send() {
  sent_ns_ = now_ns();
  (void)ping_.write(message_);
}

void Ping::tick(Time) {
  if (start_.exchange(false)) send();
  while (pong_.take()) {
    const int left = wanted_.load(std::memory_order_relaxed);
    if (left == 0) continue;  // an answer to an earlier try
    series_->add(now_ns() - sent_ns_);
    if (left == 1) return finish();
    wanted_.store(left - 1, std::memory_order_relaxed);
    send();
  }
}

void Ping::finish() {
  const std::lock_guard<std::mutex> lock(mutex_);
  wanted_ = 0;
  finished_.notify_all();
}

bool Ping::run(int count, Series& series) {
  std::unique_lock<std::mutex> lock(mutex_);
  series_ = &series;
  wanted_ = count;
  start_ = true;
  schedule().input_arrived();
  const auto none_left = [this] { return wanted_ == 0; };
  for (int before = count; !finished_.wait_for(lock, std::chrono::seconds(2), none_left);) {
    if (wanted_ == before) {
      wanted_ = 0;
      return false;
    }
    before = wanted_;
  }
  return true;
}

void Pong::tick(Time) {
  while (const auto message = ping_.take()) {
    if (!silent_) (void)pong_.write(message);
  }
}

}  // namespace tocsin::bench
