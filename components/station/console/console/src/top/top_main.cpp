// SPDX-License-Identifier: Apache-2.0
// tocsin top: live view of the diagnostics of a host.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>
#include <mutex>
#include <thread>

#include "command_line/command.hpp"
#include "command_line/stop_signal.hpp"
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
  LinkTable link;
};

/// Gives each sample of a topic to `take`, on the bus's threads.
template <class Topic>
class Listener : private Receiver {
 public:
  using Message = typename Topic::Message;
  using Take = std::function<void(const Message&, const Sample&)>;
  Listener(Bus& bus, Take take)
      : take_(std::move(take)),
        subscription_(bus.subscribe({Topic::info, &type_info<Message>()}, *this)) {}

 private:
  void receive(const Sample& sample) override {
    take_(*std::static_pointer_cast<const Message>(sample.message), sample);
  }
  const Take take_;
  std::unique_ptr<Subscription> subscription_;
};

/// Keeps the tables up to date from the bus's threads.
class Tables {
 public:
  explicit Tables(Bus& bus)
      : health_(bus,
                [this](const auto& message, const Sample& sample) {
                  const std::lock_guard<std::mutex> lock(mutex_);
                  table_.add(message, sample.source, sample.received);
                }),
        link_state_(bus, [this](const auto& message, const Sample& sample) {
          const std::lock_guard<std::mutex> lock(mutex_);
          link_.add(message, sample.received);
        }) {}
  Health health(Time now) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return {now, table_.rows(now), table_.gone(now), link_};
  }

 private:
  std::mutex mutex_;
  HealthTable table_;
  LinkTable link_;
  Listener<topic::Diagnostics> health_;
  Listener<topic::LinkState> link_state_;
};

struct Options {
  HostChoice host;
  bool once = false;
  bool json = false;
  double period_s = 1;
};

/// Of what is written to a file or a pipe.
constexpr std::size_t file_width = 200;

/// The ways over the link, the health of everything, and what each class has carried.
std::vector<terminal::Line> lines_of(const Health& health, std::size_t width) {
  std::vector<terminal::Line> lines = health.link.lines(health.now);
  for (const auto& part :
       {page(health.rows, health.gone, width), health.link.classes(health.now, width)}) {
    lines.insert(lines.end(), part.begin(), part.end());
  }
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
  const auto bus = open_host_bus(options.host, "tocsin_top");
  Tables tables(*bus);
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
