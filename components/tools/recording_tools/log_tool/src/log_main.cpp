// SPDX-License-Identifier: Apache-2.0
// tocsin log list | fetch: what vehicles have logged, over the link.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <ctime>
#include <random>

#include "command_line/command.hpp"
#include "command_line/said_time.hpp"
#include "command_line/stop_signal.hpp"
#include "fetching.hpp"
#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/printable.hpp"
#include "foundation/ros_names.hpp"
#include "known_logs.hpp"
#include "runtime/middleware/host_bus.hpp"
#include "runtime/middleware/idl_libraries.hpp"

namespace tocsin::log_tool {
namespace {

struct Options {
  HostChoice host;
  double spin_s = 5;
  std::string topic;
  SaidRange range;
  std::string output;
};

Time steady_now() { return std::chrono::steady_clock::now(); }

/// What routers tell of their logs, once one has said something of `topic`, of any when it is
/// empty.
KnownLogs heard_logs(StateListener& states, const std::string& topic, Duration patience) {
  KnownLogs logs;
  const Time end = steady_now() + patience;
  const auto is_known = [&] { return topic.empty() ? logs.any() : logs.has(topic); };
  while (!is_known() && steady_now() < end && !is_stopped()) {
    sleep_until_stopped(steady_now() + std::chrono::milliseconds(50));
    for (const auto& [state, at] : states.take()) logs.on_state(state, at);
  }
  return logs;
}

void declare(CLI::App& app, Options& options) {
  app.require_subcommand(1);
  CLI::App* const list = app.add_subcommand("list", "what is logged, and how far back");
  CLI::App* const fetch = app.add_subcommand(
      "fetch",
      "brings what has not crossed yet over the link, into a bag; goes on where it was "
      "when it is run again");
  for (CLI::App* const sub : {list, fetch}) {
    options.host.declare(*sub);
    sub->add_option("--spin-time", options.spin_s, "[s] waited for word of a log at most [5]")
        ->check(CLI::Range(0.1, 600.0));
  }
  fetch->add_option("--topic", options.topic, "with or without the slash")->required();
  fetch
      ->add_option("--from", options.range.from,
                   "[s] since 1970, or 0 and below: so long before now, by the log's clock")
      ->required();
  fetch->add_option("--to", options.range.to, "[s] the same [0]");
  fetch->add_option("-o,--output", options.output, "new folder of the bag [fetched_<time>]");
}

/// The graph of the host, and what its routers tell there.
struct Routers {
  std::unique_ptr<HostGraph> graph;
  std::unique_ptr<StateListener> states;
};

Routers open(const Options& options) {
  const BusOptions bus = host_bus_options(options.host, "tocsin_log");
  Routers routers{make_host_graph(bus), nullptr};
  catch_stop_signals();
  routers.states = std::make_unique<StateListener>(*routers.graph, bus.ros_namespace);
  return routers;
}

int list(const Options& options) {
  const Routers routers = open(options);
  const KnownLogs logs = heard_logs(*routers.states, "", seconds(options.spin_s));
  if (!logs.any()) throw EnvironmentError(logs.why_none());
  std::printf("%s", logs.table(steady_now()).c_str());
  return 0;
}

std::uint64_t fresh_id() {
  std::random_device random;
  return (std::uint64_t{random()} << 32U | random()) | 1U;
}

/// `fetched_20261122T123000`, in local time.
std::string timestamped_folder() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  std::array<char, 64> text{};
  (void)std::strftime(text.data(), text.size(), "fetched_%Y%m%dT%H%M%S", &local);
  return text.data();
}

/// Throws EnvironmentError for a topic that no router logs.
KnownLogs logs_with(StateListener& states, const std::string& topic, double patience_s) {
  KnownLogs logs = heard_logs(states, topic, seconds(patience_s));
  if (logs.has(topic) || is_stopped()) return logs;
  throw EnvironmentError(
      "--topic: " + printable(topic) + " is in no log that is heard of" +
      (logs.any() ? "; these are: " + joined(logs.topics()) : ": " + logs.why_none()));
}

int tell(const Fetching& fetching, bool is_done, const std::string& output) {
  const Fetch& fetch = fetching.fetch();
  std::printf("Fetched %llu messages into %s\n",
              static_cast<unsigned long long>(fetching.written()), printable(output).c_str());
  if (is_done && fetch.found() == 0) {
    std::printf("Nothing in that time is logged that has not crossed before\n");
  }
  if (fetch.gone() > 0) {
    std::printf("%llu more had gone from the log, or are damaged\n",
                static_cast<unsigned long long>(fetch.gone()));
  }
  if (!is_done) std::printf("Stopped; run again it brings the rest\n");
  if (fetching.lost() > 0) {
    std::fprintf(stderr, "the disk is full: %llu messages are lost\n",
                 static_cast<unsigned long long>(fetching.lost()));
  }
  return is_done && fetching.lost() == 0 ? 0 : 1;
}

int fetch(const Options& options) {
  (void)time_of("--from", options.range.from, 0);
  (void)time_of("--to", options.range.to, 0);
  const std::string topic = absolute(options.topic).substr(1);
  const std::string output = options.output.empty() ? timestamped_folder() : options.output;
  load_idl_libraries();
  const Routers routers = open(options);
  const KnownLogs logs = logs_with(*routers.states, topic, options.spin_s);
  if (is_stopped()) return 1;
  const std::int64_t clock_ns = logs.clock_ns(topic, steady_now()).value();
  auto request = request_for(topic, options.range, clock_ns);
  request.id(fresh_id());
  Fetching fetching(*routers.graph, *routers.states, request, output);
  return tell(fetching, fetching.run(), output);
}

}  // namespace
}  // namespace tocsin::log_tool

int main(int argc, char** argv) {
  tocsin::log_tool::Options options;
  CLI::App app("What vehicles have logged: what there is, and fetching it over the link.");
  app.name("tocsin log");
  tocsin::log_tool::declare(app, options);
  return tocsin::run_command(app, argc, argv, [&] {
    return app.got_subcommand("list") ? tocsin::log_tool::list(options)
                                      : tocsin::log_tool::fetch(options);
  });
}
