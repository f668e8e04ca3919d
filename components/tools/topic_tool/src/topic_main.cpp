// SPDX-License-Identifier: Apache-2.0
// tocsin topic list | info | echo | hz | bw | delay | pub | find | type, as `ros2 topic` has them.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <thread>

#include "command_line/command.hpp"
#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "graph_text.hpp"
#include "header_stamp.hpp"
#include "message_yaml.hpp"
#include "meters.hpp"
#include "ros_names.hpp"
#include "topic_session.hpp"

namespace tocsin::topic_tool {
namespace {

constexpr Duration for_ever = std::chrono::hours(24 * 365);
constexpr Duration second = std::chrono::seconds(1);

struct Options {
  HostChoice host;
  double spin_s = 2;
  std::string topic;
  std::string type;
  std::string message;
  ListOptions list;
  bool verbose = false;
  EchoOptions echo;
  bool full_length = false;
  bool once = false;
  std::size_t window = 10'000;
  double rate_hz = 1;
  int times = 0;
  int wait_readers = -1;
  std::string reliability = "reliable";
  std::string durability = "volatile";
};

/// Names may come with or without the slash in front.
std::string absolute(const std::string& topic) {
  return !topic.empty() && topic.front() == '/' ? topic : "/" + topic;
}

std::shared_ptr<void> decoded(const TypeInfo& type, const RawSample& sample) {
  auto message = type.create();
  return type.deserialize(sample.bytes->data(), sample.bytes->size(), message.get()) ? message
                                                                                     : nullptr;
}

int list(const Options& options) {
  const TopicSession session(options.host, options.spin_s);
  std::printf("%s", list_text(session.ends(), options.list).c_str());
  return 0;
}

int info(const Options& options) {
  const TopicSession session(options.host, options.spin_s);
  (void)session.find(absolute(options.topic));
  std::printf("%s", info_text(session.ends(), absolute(options.topic), options.verbose).c_str());
  return 0;
}

int type(const Options& options) {
  const TopicSession session(options.host, options.spin_s);
  (void)session.find(absolute(options.topic));
  for (const std::string& one : types_of(session.ends(), absolute(options.topic))) {
    std::printf("%s\n", one.c_str());
  }
  return 0;
}

int find(const Options& options) {
  const std::string wanted = ros_type(wire_type(options.type));
  const TopicSession session(options.host, options.spin_s);
  for (const std::string& one : topics_of_type(session.ends(), wanted)) {
    std::printf("%s\n", one.c_str());
  }
  return 0;
}

int echo(const Options& options) {
  TopicSession session(options.host, options.spin_s);
  const RawTopic topic = session.find(absolute(options.topic));
  const TypeInfo& known = known_type(topic.type);
  EchoOptions shown = options.echo;
  if (options.full_length) shown.longest = 0;
  (void)to_yaml(known, known.create().get(), shown);  // refuses a field that it has not
  SampleQueue samples(session.graph(), topic);
  while (const auto sample = samples.take(for_ever)) {
    const auto message = decoded(known, *sample);
    if (!message) {
      std::fprintf(stderr, "a sample of %zu bytes is no %s\n", sample->bytes->size(),
                   ros_type(topic.type).c_str());
      continue;
    }
    std::printf("%s---\n", to_yaml(known, message.get(), shown).c_str());
    std::fflush(stdout);
    if (options.once) break;
  }
  return 0;
}

/// Calls `add` with each sample and prints what `text` says, once a second.
int measure(const Options& options, const std::function<void(const RawTopic&)>& begin,
            const std::function<void(const RawSample&)>& add,
            const std::function<std::string(Time)>& text) {
  TopicSession session(options.host, options.spin_s);
  const RawTopic topic = session.find(absolute(options.topic));
  begin(topic);
  SampleQueue samples(session.graph(), topic);
  Time next = std::chrono::steady_clock::now() + second;
  while (!TopicSession::is_over()) {
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

std::int64_t wall_now_ns() {
  return std::chrono::duration_cast<Duration>(std::chrono::system_clock::now().time_since_epoch())
      .count();
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
        const auto message = decoded(*known, one);
        const auto stamp = message ? header_stamp_ns(*known, message.get()) : std::nullopt;
        if (stamp) meter.add(static_cast<double>(wall_now_ns() - *stamp) * 1e-9);
      },
      [&](Time) { return meter.text(); });
}

std::vector<std::uint8_t> encoded(const TypeInfo& type, const void* message) {
  std::vector<std::uint8_t> bytes(type.serialized_size(message));
  bytes.resize(type.serialize(message, bytes.data(), bytes.size()));
  return bytes;
}

/// With --once and --times a reader is waited for, as the sample is lost without one.
void wait_for_readers(const RawWriting& writing, int wanted) {
  if (writing.readers() >= wanted) return;
  std::printf("Waiting for at least %d matching subscription(s)...\n", wanted);
  std::fflush(stdout);
  while (writing.readers() < wanted && !TopicSession::is_over()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

int pub(const Options& options) {
  const TypeInfo& known = known_type(wire_type(options.type));
  const auto message = from_yaml(known, options.message);
  const auto bytes = encoded(known, message.get());
  TopicSession session(options.host, options.spin_s);
  const RawTopic topic{wire_topic(options.topic), known.name, options.reliability == "reliable",
                       options.durability == "transient_local"};
  const auto writing = session.graph().write(topic);
  const int times = options.once ? 1 : options.times;
  wait_for_readers(*writing,
                   options.wait_readers >= 0 ? options.wait_readers : (times > 0 ? 1 : 0));
  const std::string text = to_yaml(known, message.get(), {});
  std::printf("publisher: beginning loop\n");
  for (int count = 1; !TopicSession::is_over(); ++count) {
    if (!writing->write(bytes)) throw EnvironmentError("the middleware refused the message");
    std::printf("publishing #%d:\n%s\n", count, text.c_str());
    std::fflush(stdout);
    if (count == times) break;
    const Time due = std::chrono::steady_clock::now() + seconds(1 / options.rate_hz);
    while (std::chrono::steady_clock::now() < due && !TopicSession::is_over()) {
      std::this_thread::sleep_for(std::min<Duration>(std::chrono::milliseconds(50),
                                                     due - std::chrono::steady_clock::now()));
    }
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(100));  // the last one has to leave
  return 0;
}

/// One subcommand with what all of them have.
CLI::App* verb(CLI::App& app, const char* name, const char* text, Options& options) {
  CLI::App* const sub = app.add_subcommand(name, text);
  options.host.declare(*sub);
  sub->add_option("--spin-time", options.spin_s, "[s] waited for what does not appear [2]")
      ->check(CLI::Range(0.1, 600.0));
  return sub;
}

void need_topic(CLI::App& sub, Options& options) {
  sub.add_option("topic", options.topic, "its name, with or without the slash")->required();
}

void declare_echo(CLI::App& app, Options& options) {
  CLI::App* const sub = verb(app, "echo", "prints each message", options);
  need_topic(*sub, options);
  sub->add_option("--field", options.echo.field, "only this field: pose.pose.position");
  sub->add_option("-l,--truncate-length", options.echo.longest, "of texts and lists [128]");
  sub->add_flag("-f,--full-length", options.full_length, "cuts nothing");
  sub->add_flag("--no-arr", options.echo.no_lists, "leaves lists out");
  sub->add_flag("--no-str", options.echo.no_texts, "leaves texts out");
  sub->add_flag("--once", options.once, "ends after the first message");
}

void declare_pub(CLI::App& app, Options& options) {
  CLI::App* const sub = verb(app, "pub", "writes a message again and again", options);
  need_topic(*sub, options);
  sub->add_option("type", options.type, "geometry_msgs/msg/Twist")->required();
  sub->add_option("message", options.message, "in YAML: '{linear: {x: 0.1}}' [all defaults]");
  sub->add_option("-r,--rate", options.rate_hz, "[1/s] [1]")->check(CLI::Range(0.001, 10'000.0));
  auto* const once = sub->add_flag("-1,--once", options.once, "one message, then ends");
  sub->add_option("-t,--times", options.times, "so many messages, then ends")
      ->check(CLI::PositiveNumber)
      ->excludes(once);
  sub->add_option("-w,--wait-matching-subscriptions", options.wait_readers,
                  "readers that are waited for [1 with --once and --times, else 0]")
      ->check(CLI::Range(0, 1000));
  sub->add_option("--qos-reliability", options.reliability, "[reliable]")
      ->check(CLI::IsMember({"reliable", "best_effort"}));
  sub->add_option("--qos-durability", options.durability, "[volatile]")
      ->check(CLI::IsMember({"volatile", "transient_local"}));
}

void declare_list(CLI::App& app, Options& options) {
  CLI::App* const sub = verb(app, "list", "topics that somebody writes or reads", options);
  sub->add_flag("-t,--show-types", options.list.types, "with their types");
  sub->add_flag("-c,--count-topics", options.list.count, "how many there are");
  sub->add_flag("-v,--verbose", options.list.verbose, "with the number of ends");
  sub->add_flag("--include-hidden-topics", options.list.hidden, "those that begin with _, too");
}

using Verb = int (*)(const Options&);

int run(const CLI::App& app, const Options& options) {
  static const std::map<std::string, Verb> verbs{{"list", list}, {"info", info},   {"type", type},
                                                 {"find", find}, {"echo", echo},   {"hz", hz},
                                                 {"bw", bw},     {"delay", delay}, {"pub", pub}};
  return verbs.at(app.get_subcommands().front()->get_name())(options);
}

int declare_and_run(int argc, char** argv) {
  Options options;
  CLI::App app("Topics of a running host, ours and those of other DDS and ROS 2 programs there.");
  app.name("tocsin topic");
  app.require_subcommand(1);
  declare_list(app, options);
  CLI::App* const about = verb(app, "info", "type and number of ends of a topic", options);
  need_topic(*about, options);
  about->add_flag("-v,--verbose", options.verbose, "each end with its QoS");
  need_topic(*verb(app, "type", "the type of a topic", options), options);
  verb(app, "find", "topics of a type", options)
      ->add_option("type", options.type, "nav_msgs/msg/Odometry")
      ->required();
  declare_echo(app, options);
  for (const auto& [name, text] :
       {std::pair{"hz", "rate of a topic, once a second"}, std::pair{"bw", "its bytes a second"},
        std::pair{"delay", "time from header.stamp to the arrival"}}) {
    CLI::App* const sub = verb(app, name, text, options);
    need_topic(*sub, options);
    sub->add_option("-w,--window", options.window, "[1] newest samples that count [10000]")
        ->check(CLI::Range(std::size_t{2}, std::numeric_limits<std::size_t>::max()));
  }
  declare_pub(app, options);
  return run_command(app, argc, argv, [&] { return run(app, options); });
}

}  // namespace
}  // namespace tocsin::topic_tool

int main(int argc, char** argv) { return tocsin::topic_tool::declare_and_run(argc, argv); }
