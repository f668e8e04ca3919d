// SPDX-License-Identifier: Apache-2.0
// tocsin top: live view of the diagnostics of a host.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "command_line/command.hpp"
#include "command_line/stop_signal.hpp"
#include "deployment/running_host.hpp"
#include "foundation/error.hpp"
#include "health_table.hpp"
#include "link_table.hpp"
#include "runtime/middleware/host_bus.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::top {
namespace {

/// What is shown at an instant.
struct Health {
  Time now;
  std::vector<Row> rows;
  std::vector<Gone> gone;
  std::map<std::string, LinkTable> links;  ///< by vehicle; of a host with one link by ""
};

/// Gives each sample of a topic to `take`, on the bus's threads.
template <class Topic>
class Listener : private Receiver {
 public:
  using Message = typename Topic::Message;
  using Take = std::function<void(const Message&, const Sample&)>;
  /// `vehicle`: of several that the station serves; empty: the topics of this host.
  Listener(Bus& bus, const std::string& vehicle, Take take)
      : take_(std::move(take)),
        name_(vehicle.empty() ? Topic::info.name : "/" + vehicle + "/" + Topic::info.name),
        subscription_(bus.subscribe({named(Topic::info), &type_info<Message>()}, *this)) {}

 private:
  [[nodiscard]] TopicInfo named(TopicInfo info) const {
    info.name = name_.c_str();
    return info;
  }
  void receive(const Sample& sample) override {
    take_(*std::static_pointer_cast<const Message>(sample.message), sample);
  }
  const Take take_;
  const std::string name_;
  std::unique_ptr<Subscription> subscription_;
};

/// Keeps the tables up to date from the bus's threads.
class Tables {
 public:
  /// `vehicles`: see Listener.
  Tables(Bus& bus, const std::vector<std::string>& vehicles) {
    for (const std::string& vehicle : vehicles) {
      health_.emplace_back(bus, vehicle, [this](const auto& message, const Sample& sample) {
        const std::lock_guard<std::mutex> lock(mutex_);
        table_.add(message, sample.source, sample.received);
      });
      link_states_.emplace_back(bus, vehicle,
                                [this, vehicle](const auto& message, const Sample& sample) {
                                  const std::lock_guard<std::mutex> lock(mutex_);
                                  links_[vehicle].add(message, sample.received);
                                });
    }
  }
  Health health(Time now) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return {now, table_.rows(now), table_.gone(now), links_};
  }

 private:
  std::mutex mutex_;
  HealthTable table_;
  std::map<std::string, LinkTable> links_;
  std::deque<Listener<topic::Diagnostics>> health_;
  std::deque<Listener<topic::LinkState>> link_states_;
};

/// The vehicles that the chosen host serves by name; one empty name where there is one link.
std::vector<std::string> vehicles_of(const HostChoice& choice) {
  const auto host = chosen_host(choice);
  if (!host || !choice.ros_namespace.empty()) return {""};
  const auto& all = host->deployment.vehicles;
  const bool is_station = std::find(all.begin(), all.end(), host->host) == all.end();
  return all.empty() || !is_station ? std::vector<std::string>{""} : all;
}

struct Options {
  HostChoice host;
  bool once = false;
  bool json = false;
  double period_s = 1;
};

/// Of what is written to a file or a pipe.
constexpr std::size_t file_width = 200;

void append(const std::vector<terminal::Line>& more, std::vector<terminal::Line>& lines) {
  lines.insert(lines.end(), more.begin(), more.end());
}

/// The ways over the link, the health of everything, and what each class has carried; of several
/// vehicles each link by itself, and then the health.
std::vector<terminal::Line> lines_of(const Health& health, std::size_t width) {
  std::vector<terminal::Line> lines;
  std::vector<terminal::Line> classes;
  for (const auto& [vehicle, link] : health.links) {
    if (!vehicle.empty()) lines.push_back({terminal::Span{vehicle}});
    append(link.lines(health.now), lines);
    append(link.classes(health.now, width), vehicle.empty() ? classes : lines);
  }
  append(page(health.rows, health.gone, width), lines);
  append(classes, lines);
  return lines;
}

void print_all(const Health& health) {
  const bool terminal = ::isatty(STDOUT_FILENO) == 1;
  const std::size_t width = terminal ? terminal::size_of(STDOUT_FILENO).columns : file_width;
  for (const terminal::Line& line : lines_of(health, width)) {
    std::printf("%s\n", terminal::to_text(line, width, terminal).c_str());
  }
}

/// A whole page of the terminal, whose size may have changed.
void draw(const Health& health) {
  const terminal::Size size = terminal::size_of(STDOUT_FILENO);
  auto lines = lines_of(health, size.columns);
  lines = terminal::shortened(std::move(lines), size.rows, "lines");
  std::printf("%s", terminal::frame(lines, size).c_str());
}

void show(const Options& options, const Health& health) {
  if (options.json) {
    std::printf("%s", to_json(health.rows).c_str());
  } else if (options.once || ::isatty(STDOUT_FILENO) != 1) {
    print_all(health);
  } else {
    draw(health);
  }
  std::fflush(stdout);
}

int run(const Options& options) {
  const auto vehicles = vehicles_of(options.host);  // before it enters the host's network
  const auto bus = open_host_bus(options.host, "tocsin_top");
  Tables tables(*bus, vehicles);
  if (options.once) {
    std::this_thread::sleep_for(seconds(2.5));  // every container reports once a second
    const Health health = tables.health(bus->now());
    if (health.rows.empty()) throw EnvironmentError("nothing reports its health on this host");
    show(options, health);
    return 0;
  }
  catch_stop_signals();
  while (!is_stopped()) {
    std::this_thread::sleep_for(seconds(options.period_s));
    show(options, tables.health(bus->now()));
  }
  if (!options.json) std::printf("\n");  // the prompt comes below the page
  return 0;
}

int declare_and_run(int argc, char** argv) {
  CLI::App app("Live view of the health of a host's components", "tocsin top");
  Options options;
  options.host.declare(app);
  app.add_flag("--once", options.once, "print once, after 2.5 s, and end");
  app.add_flag("--json", options.json, "one line of JSON each time");
  app.add_option("--period", options.period_s, "[s] between pictures [1]")
      ->check(CLI::Range(0.1, 60.0));
  return run_command(app, argc, argv, [&] { return run(options); });
}

}  // namespace
}  // namespace tocsin::top

int main(int argc, char** argv) { return tocsin::top::declare_and_run(argc, argv); }
