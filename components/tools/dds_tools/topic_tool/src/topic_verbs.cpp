// SPDX-License-Identifier: Apache-2.0
#include "topic_verbs.hpp"

#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "command_line/stop_signal.hpp"
#include "deployment/running_host.hpp"
#include "foundation/error.hpp"
#include "foundation/ros_names.hpp"
#include "header_stamp.hpp"
#include "idl_support/decode.hpp"
#include "idl_support/encode.hpp"
#include "log_echo.hpp"
#include "meters.hpp"
#include "topic_session.hpp"

namespace tocsin::topic_tool::topic_verb {
namespace {

constexpr Duration for_ever = std::chrono::hours(24 * 365);
constexpr Duration second = std::chrono::seconds(1);

}  // namespace

int list(const Options& options) {
  const TopicSession session(options);
  std::printf("%s", list_text(session.ends(), options.list).c_str());
  return 0;
}

int info(const Options& options) {
  const TopicSession session(options);
  (void)session.find(absolute(options.topic));
  const auto ends = session.ends();
  const auto nodes = session.graph().nodes();
  std::printf("%s", info_text(ends, nodes, absolute(options.topic), options.verbose).c_str());
  return 0;
}

int type(const Options& options) {
  const TopicSession session(options);
  (void)session.find(absolute(options.topic));
  for (const std::string& one : types_of(session.ends(), absolute(options.topic))) {
    std::printf("%s\n", one.c_str());
  }
  return 0;
}

int find(const Options& options) {
  const std::string wanted = ros_type(wire_type(options.type));
  const TopicSession session(options);
  for (const std::string& one : topics_of_type(session.ends(), wanted)) {
    std::printf("%s\n", one.c_str());
  }
  return 0;
}

namespace {

/// The folders of the log of the host that the options name.
std::vector<std::string> log_folders(const Options& options) {
  if (!options.log.folder.empty()) return folders_in(options.log.folder);
  const auto host = chosen_host(options.host);
  if (host != nullptr) return folders_in(store_folder(*host, options.host.ros_namespace));
  throw EnvironmentError("nothing runs here whose log could be read: name it with --log");
}

int echo_log(const Options& options, const EchoOptions& shown) {
  const auto folders = log_folders(options);
  catch_stop_signals();
  const std::string topic = absolute(options.topic);
  const std::string folder = folder_with(folders, topic, seconds(options.spin_s));
  LogEcho log(folder, topic, options.log);
  log.run(shown, options.once);
  return 0;
}

}  // namespace

int echo(const Options& options) {
  EchoOptions shown = options.echo;
  if (options.full_length) shown.longest = 0;
  if (options.log.is_wanted()) return echo_log(options, shown);
  TopicSession session(options);
  const RawTopic topic = session.find(absolute(options.topic));
  const TypeInfo& known = known_type(topic.type);
  (void)to_yaml(known, known.create().get(), shown);  // refuses a field that it has not
  SampleQueue samples(session.graph(), topic);
  while (const auto sample = samples.take(for_ever)) {
    if (print(known, *sample->bytes, shown) && options.once) break;
  }
  return 0;
}

namespace {

/// Calls `add` with each sample and prints what `text` says, once a second.
int measure(const Options& options, const std::function<void(const RawTopic&)>& begin,
            const std::function<void(const RawSample&)>& add,
            const std::function<std::string(Time)>& text) {
  TopicSession session(options);
  const RawTopic topic = session.find(absolute(options.topic));
  begin(topic);
  SampleQueue samples(session.graph(), topic);
  Time next = std::chrono::steady_clock::now() + second;
  while (!is_stopped()) {
    const Time now = std::chrono::steady_clock::now();
    if (now >= next) {
      std::printf("%s", text(now).c_str());
      std::fflush(stdout);
      next += second;
      continue;
    }
    if (const auto sample = samples.take(next - now)) add(*sample);
  }
  return 0;
}

}  // namespace

int hz(const Options& options) {
  RateMeter meter(options.window);
  return measure(
      options, [](const RawTopic&) {}, [&](const RawSample& one) { meter.add(one.received); },
      [&](Time) { return meter.text(); });
}

int bw(const Options& options) {
  BandwidthMeter meter(options.window);
  return measure(
      options,
      [&](const RawTopic&) {
        std::printf("Subscribed to [%s]\n", absolute(options.topic).c_str());
      },
      [&](const RawSample& one) { meter.add(one.bytes->size(), one.received); },
      [&](Time now) { return meter.text(now); });
}

int delay(const Options& options) {
  DelayMeter meter(options.window);
  const TypeInfo* known = nullptr;
  return measure(
      options,
      [&](const RawTopic& topic) {
        known = &known_type(topic.type);
        if (header_stamp_ns(*known, known->create().get())) return;
        throw ConfigError(ros_type(topic.type) + " has no header with a stamp");
      },
      [&](const RawSample& one) {
        const auto message = decode(*known, *one.bytes);
        const auto stamp = message ? header_stamp_ns(*known, message.get()) : std::nullopt;
        if (stamp) meter.add(static_cast<double>(one.received_wall_ns - *stamp) * 1e-9);
      },
      [&](Time) { return meter.text(); });
}

namespace {

/// With --once and --times a reader is waited for, as the sample is lost without one.
void wait_for_readers(const RawWriting& writing, int wanted) {
  if (writing.readers() >= wanted) return;
  std::printf("Waiting for at least %d matching subscription(s)...\n", wanted);
  std::fflush(stdout);
  while (writing.readers() < wanted && !is_stopped()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

}  // namespace

int pub(const Options& options) {
  const TypeInfo& known = known_type(wire_type(options.type));
  const auto message = from_yaml(known, options.message);
  const auto bytes = encode(known, message.get());
  TopicSession session(options);
  const RawTopic topic{wire_topic(options.topic), known.name,
                       options.reliability == Reliability::reliable,
                       options.durability == Durability::transient_local};
  const auto writing = session.graph().write(topic);
  const int times = options.once ? 1 : options.times;
  wait_for_readers(*writing, options.wait_readers.value_or(times > 0 ? 1 : 0));
  const std::string text = to_yaml(known, message.get(), {});
  std::printf("publisher: beginning loop\n");
  for (int count = 1; !is_stopped(); ++count) {
    std::printf("publishing #%d:\n%s\n", count, text.c_str());
    std::fflush(stdout);  // before anybody can have heard it
    if (!writing->write(bytes)) throw EnvironmentError("the middleware refused the message");
    if (count == times) break;
    sleep_until_stopped(std::chrono::steady_clock::now() + seconds(1 / options.rate_hz));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(100));  // the last one has to leave
  return 0;
}

}  // namespace tocsin::topic_tool::topic_verb
