// SPDX-License-Identifier: Apache-2.0
// Nanoseconds that a packet costs in the filter as the runtime calls it (clock and lock included),
// with 20 known participants and the limits of a link; and, for comparison, what it costs to send a
// packet of that size over loopback and receive it, without Fast DDS.
#include <arpa/inet.h>
#include <benchmark/benchmark.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <mutex>
#include <vector>

#include "message_builder.hpp"

namespace tocsin::rtps_filter {
namespace {

Limits link_limits() {
  Limits limits;
  limits.bytes = {1e15, 1e15};
  limits.announcements = {1e15, 1e15};
  limits.gap_rate = limits.kept_numbers = {1e15, 1e15};
  limits.participant_has_address = true;
  limits.source_has_port = false;
  limits.hears = [](std::uint32_t address) { return address >> 24U == 127; };
  limits.answers = limits.hears;
  return limits;
}

void inspect_again(benchmark::State& state, const Bytes& packet) {
  RtpsFilter filter(link_limits());
  std::mutex mutex;
  for (char name = 'a'; name < 'a' + 20; ++name) {
    (void)inspect(filter, announcement(name), alice, std::chrono::steady_clock::now());
  }
  std::int64_t passed = 0;
  for (auto _ : state) {
    const Time now = std::chrono::steady_clock::now();
    const std::lock_guard<std::mutex> lock(mutex);
    passed += filter.inspect(packet.data(), packet.size(), alice, now).drop ? 0 : 1;
  }
  if (passed != state.iterations()) state.SkipWithError("an ordinary packet was dropped");
}

/// A sample as Fast DDS sends it: INFO_DST, INFO_TS, DATA with inline QoS, HEARTBEAT.
Bytes sample(std::size_t bytes) {
  const Bytes qos = Wire().parameter(0x800f, Bytes(24, 1)).sentinel().bytes();
  const Wire head = data_head(user_writer, 7).raw(qos).raw({0, 1, 0, 0}).zeros(bytes);
  return Message('a')
      .add(0x0e, 0, prefix_of('b'))
      .add(0x09, 0, Bytes(8, 1))
      .add(0x15, with_qos | with_data, head.bytes())
      .add(0x07, 0, Wire().entity(0).entity(user_writer).number(7).number(7).u32(1).bytes())
      .bytes();
}

void filter_sample(benchmark::State& state) {
  inspect_again(state, sample(static_cast<std::size_t>(state.range(0))));
}

void filter_acknack(benchmark::State& state) {
  const Wire content = Wire().entity(0).entity(user_writer).number(7).u32(32).u32(0).u32(1);
  inspect_again(state, Message('a').add(0x06, 0, content.bytes()).bytes());
}

void filter_gap(benchmark::State& state) { inspect_again(state, gap('a', 7, 9, 32)); }

void filter_announcement(benchmark::State& state) {
  const Wire list = Wire()
                        .parameter(0x15, {2, 1, 0, 0})
                        .parameter(0x32, locator(ipv4(127, 0, 0, 1)))
                        .parameter(0x31, locator(ipv4(127, 0, 0, 1)))
                        .parameter(0x62, Wire().text("a participant's name").bytes())
                        .parameter(0x59, Wire().u32(1).text("name").text("value").bytes());
  inspect_again(state, announcement('a', list));
}

/// A socket that sends to itself.
void receive_from_loopback(benchmark::State& state) {
  const Bytes packet = sample(static_cast<std::size_t>(state.range(0)));
  const int udp = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in own{};
  own.sin_family = AF_INET;
  own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  auto* const address = reinterpret_cast<sockaddr*>(&own);
  socklen_t size = sizeof own;
  (void)::bind(udp, address, size);
  (void)::getsockname(udp, address, &size);
  Bytes buffer(65536);
  for (auto _ : state) {
    (void)::sendto(udp, packet.data(), packet.size(), 0, address, size);
    benchmark::DoNotOptimize(::recv(udp, buffer.data(), buffer.size(), 0));
  }
  ::close(udp);
}

BENCHMARK(filter_sample)->Arg(64)->Arg(1024)->Arg(60000);
BENCHMARK(filter_acknack);
BENCHMARK(filter_gap);
BENCHMARK(filter_announcement);
BENCHMARK(receive_from_loopback)->Arg(64)->Arg(1024)->Arg(60000);

}  // namespace
}  // namespace tocsin::rtps_filter

BENCHMARK_MAIN();
