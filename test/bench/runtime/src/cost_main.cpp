// SPDX-License-Identifier: Apache-2.0
// What the gate costs an active writer, how late a deadline wakes a component, what a start takes.
// usage: runtime_cost [--quick] [gate|deadline|restart|start]
#include <time.h>

#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <thread>

#include "bench_bus.hpp"
#include "runner/runner.hpp"
#include "runtime/middleware/gated_writer.hpp"
#include "start_cost.hpp"

namespace tocsin::bench {
namespace {

/// A writer that does nothing, so that only the gate is measured.
class NullWriter : public LinkWriter {
 public:
  std::size_t send(const void* message) override { return message != nullptr ? 1 : 0; }
  void silence() override {}
};

template <class Call>
double ns_per_call(int calls, Call call) {
  const std::int64_t start = now_ns();
  for (int i = 0; i < calls; ++i) call();
  return static_cast<double>(now_ns() - start) / calls;
}

void print_gate(int rounds) {
  constexpr int calls = 200000;
  const auto message = std::static_pointer_cast<const void>(blob(1024));
  NullWriter plain;
  LinkWriter* volatile ungated = &plain;  // keeps the call virtual, as in the gate
  GatedWriter gated("ping", {TrafficClass::low, WhilePoor::drop}, std::make_unique<NullWriter>(),
                    {});
  Series with;
  Series without;
  for (int i = 0; i < rounds; ++i) {
    without.add(static_cast<std::int64_t>(
        1000 * ns_per_call(calls, [&] { (void)ungated->send(message.get()); })));
    with.add(
        static_cast<std::int64_t>(1000 * ns_per_call(calls, [&] { (void)gated.write(message); })));
  }
  std::printf("gate, active writer [ns]: %.1f with, %.1f without: %.1f for the gate\n",
              with.percentile(0.5) / 1000, without.percentile(0.5) / 1000,
              (with.percentile(0.5) - without.percentile(0.5)) / 1000);
}

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
  const auto bus = make_bench_bus("sleepy", 85, false);
  Context context{*bus, "sleepy", "uxv", ""};
  Sleepy sleepy(context);
  TickAccount account;
  Series raw;
  {
    Runner runner("sleepy", *bus);
    runner.add(sleepy, account);
    runner.start();
    raw = clock_nanosleep_lateness(count);
  }
  std::printf(
      "a deadline wakes late by [us], median / p99: %s; clock_nanosleep at the same time: %s\n",
      sleepy.late.text().c_str(), raw.text().c_str());
}

int measure(bool quick, const std::string& part) {
  const auto wanted = [&part](const char* name) { return part.empty() || part == name; };
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  if (wanted("gate")) print_gate(quick ? 5 : 25);
  if (wanted("deadline")) print_deadline(quick ? 500 : 4000);
  if (wanted("restart")) print_restarts(quick ? 20 : 100);
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
