// SPDX-License-Identifier: Apache-2.0
#include "topic_options.hpp"

#include "commands.hpp"
#include "topic_verbs.hpp"

#include <CLI/CLI.hpp>
#include <initializer_list>
#include <limits>
#include <vector>

#include "command_line/option_checks.hpp"
#include "foundation/enum_words.hpp"

namespace tocsin::topic_tool {
namespace {

void need_topic(CLI::App& sub, Options& options) {
  sub.add_option("topic", options.topic, "its name, with or without the slash")->required();
}

/// An option that is one of `allowed`, in the words of a QoS file.
template <class Policy>
void add_qos_option(CLI::App& app, const char* name, Policy& policy,
                    std::initializer_list<Policy> allowed) {
  std::vector<std::string> words;
  for (const Policy one : allowed) words.emplace_back(word_of(one));
  const auto take = [&policy](const std::string& word) {
    policy = value_of<Policy>(word).value_or(policy);
  };
  app.add_option_function<std::string>(name, take, std::string("[") + word_of(policy) + "]")
      ->check(CLI::IsMember(words));
}

void declare_log(CLI::App& echo, LogWish& log) {
  auto* const group = echo.add_option_group(
      "From the log", "first what this host's log has, then what comes to it; see link_router");
  auto* const last = group->add_option("--last", log.last, "the last N messages")
                         ->check(CLI::Range(0, 1'000'000'000));
  auto* const since = group->add_option("--since", log.since_s, "[s] those of so long before now")
                          ->check(CLI::Range(0.0, 1e9));
  auto* const start = group->add_flag("--from-start", log.from_start, "all that there are");
  last->excludes(since)->excludes(start);
  since->excludes(start);
  group->add_option("--consumer", log.consumer,
                    "goes on where the last one of this name was; a new one begins with the above, "
                    "or now");
  group->add_option("--log", log.folder, "the router's store_directory [of the running host]");
}

void declare_echo(Verbs& verbs, Options& options) {
  CLI::App* const sub = add_verb(verbs, options, "echo", "prints each message", topic_verb::echo);
  need_topic(*sub, options);
  sub->add_option("--field", options.echo.field, "only this field: pose.pose.position");
  sub->add_option("-l,--truncate-length", options.echo.longest, "of texts and lists [128]");
  sub->add_flag("-f,--full-length", options.full_length, "cuts nothing");
  sub->add_flag("--no-arr", options.echo.no_lists, "leaves lists out");
  sub->add_flag("--no-str", options.echo.no_texts, "leaves texts out");
  sub->add_flag("--once", options.once, "ends after the first message");
  declare_log(*sub, options.log);
}

void declare_pub(Verbs& verbs, Options& options) {
  CLI::App* const sub =
      add_verb(verbs, options, "pub", "writes a message again and again", topic_verb::pub);
  need_topic(*sub, options);
  sub->add_option("type", options.type, "geometry_msgs/msg/Twist")->required();
  sub->add_option("message", options.message, "in YAML: '{linear: {x: 0.1}}' [all defaults]");
  sub->add_option("-r,--rate", options.rate_hz, "[1/s] [1]")->check(CLI::Range(0.001, 10'000.0));
  auto* const once = sub->add_flag("-1,--once", options.once, "one message, then ends");
  sub->add_option("-t,--times", options.times, "so many messages, then ends")
      ->check(above_zero())
      ->excludes(once);
  sub->add_option("-w,--wait-matching-subscriptions", options.wait_readers,
                  "readers that are waited for [1 with --once and --times, else 0]")
      ->check(CLI::Range(0, 1000));
  add_qos_option(*sub, "--qos-reliability", options.reliability,
                 {Reliability::reliable, Reliability::best_effort});
  add_qos_option(*sub, "--qos-durability", options.durability,
                 {Durability::volatile_kind, Durability::transient_local});
}

void declare_list(Verbs& verbs, Options& options) {
  CLI::App* const sub =
      add_verb(verbs, options, "list", "topics that somebody writes or reads", topic_verb::list);
  sub->add_flag("-t,--show-types", options.list.types, "with their types");
  sub->add_flag("-c,--count-topics", options.list.count, "how many there are");
  sub->add_flag("-v,--verbose", options.list.verbose, "with the number of ends");
  sub->add_flag("--include-hidden-topics", options.list.hidden, "those that begin with _, too");
}

}  // namespace

void declare(Verbs& verbs, Options& options) {
  declare_list(verbs, options);
  CLI::App* const about =
      add_verb(verbs, options, "info", "type and number of ends of a topic", topic_verb::info);
  need_topic(*about, options);
  about->add_flag("-v,--verbose", options.verbose, "each end with its QoS");
  need_topic(*add_verb(verbs, options, "type", "the type of a topic", topic_verb::type), options);
  add_verb(verbs, options, "find", "topics of a type", topic_verb::find)
      ->add_option("type", options.type, "nav_msgs/msg/Odometry")
      ->required();
  declare_echo(verbs, options);
  for (CLI::App* const sub :
       {add_verb(verbs, options, "hz", "rate of a topic, once a second", topic_verb::hz),
        add_verb(verbs, options, "bw", "its bytes a second", topic_verb::bw),
        add_verb(verbs, options, "delay", "time from header.stamp to the arrival",
                 topic_verb::delay)}) {
    need_topic(*sub, options);
    sub->add_option("-w,--window", options.window, "[1] newest samples that count [10000]")
        ->check(CLI::Range(std::size_t{2}, std::numeric_limits<std::size_t>::max()));
  }
  declare_pub(verbs, options);
}

int run_topic(int argc, char** argv) {
  return run_verbs<Options>(
      argc, argv, "tocsin topic",
      "Topics of a running host, ours and those of other DDS and ROS 2 programs there.", declare);
}

}  // namespace tocsin::topic_tool
