// SPDX-License-Identifier: Apache-2.0
// How late a deadline wakes a component, what a start takes.
// usage: runtime_cost [--quick] [deadline|start]
#include <time.h>

#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <thread>

#include "bench_bus.hpp"
#include "runtime/middleware/runner.hpp"
#include "start_cost.hpp"

namespace tocsin::bench {
namespace {

/// Asks to be woken a millisecond later, and notes how late it was.
class Sleepy : public Component {
 public:
  using Component::Component;
  void tick(Time now) override {
    if (asked_ != Time{} && now >= asked_) late.add((now - asked_).count());
    asked_ = now + std::chrono::milliseconds(1);
    wake_at(asked_);
  }
  Series late;

 private:
  Time asked_{};
};

Series clock_nanosleep_lateness(int count) {
  Series late;
  for (int i = 0; i < count; ++i) {
    const std::int64_t due = now_ns() + 1'000'000;
    const timespec when{due / 1'000'000'000, due % 1'000'000'000};
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &when, nullptr);
    late.add(now_ns() - due);
  }
  return late;
}

void print_deadline(int count) {
  const auto bus = make_bench_bus("sleepy", 85);
  Context context{*bus, "sleepy", Role::uxv};
  Sleepy sleepy(context);
  TickAccount account;
  Series raw;
  {
    const Runner runner("sleepy", *bus, sleepy, account);
    raw = clock_nanosleep_lateness(count);
  }
  std::printf(
      "a deadline wakes late by [us], median / p99: %s; clock_nanosleep at the same time: %s\n",
      sleepy.late.text().c_str(), raw.text().c_str());
}

int measure(bool quick, const std::string& part) {
  const auto wanted = [&part](const char* name) { return part.empty() || part == name; };
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  if (wanted("deadline")) print_deadline(quick ? 500 : 4000);
  if (wanted("start")) print_start_costs();
  return 0;
}

}  // namespace
}  // namespace tocsin::bench

int main(int argc, char** argv) {
  if (argc > 3 && std::strcmp(argv[1], "--child") == 0) {
    return tocsin::bench::run_child(argc - 2, argv + 2);
  }
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  const int part = quick ? 2 : 1;
  return tocsin::bench::measure(quick, argc > part ? argv[part] : "");
}
