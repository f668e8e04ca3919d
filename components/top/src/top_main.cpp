// SPDX-License-Identifier: Apache-2.0
// tocsin top: live view of the diagnostics of a host.
#include <sys/ioctl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <mutex>
#include <thread>

#include "command_line/command.hpp"
#include "foundation/error.hpp"
#include "health_table.hpp"
#include "runtime/middleware/host_bus.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::top {
namespace {

volatile std::sig_atomic_t ended = 0;

/// Keeps the table up to date from the bus's threads.
class Listener : private Receiver {
 public:
  explicit Listener(Bus& bus)
      : subscription_(bus.subscribe(
            {topic::Diagnostics::info, &type_info<topic::Diagnostics::Message>()}, *this)) {}
  std::vector<Row> rows(Time now) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return table_.rows(now);
  }

 private:
  void receive(const Sample& sample) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    table_.add(*std::static_pointer_cast<const topic::Diagnostics::Message>(sample.message),
               sample.received);
  }
  std::mutex mutex_;
  HealthTable table_;
  std::unique_ptr<Subscription> subscription_;
};

struct Options {
  HostChoice host;
  bool once = false;
  bool json = false;
  double period_s = 1;
};

std::size_t terminal_width() {
  winsize size{};
  const bool known = ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 200;
}

void show(const Options& options, const std::vector<Row>& rows) {
  const std::string text = options.json ? to_json(rows) : to_text(rows, terminal_width());
  const bool live = !options.once && !options.json;
  std::printf("%s%s", live ? "\033[H\033[2J" : "", text.c_str());
  std::fflush(stdout);
}

int run(const Options& options) {
  const auto bus = open_host_bus(options.host, "tocsin_top");
  Listener listener(*bus);
  if (options.once) {
    std::this_thread::sleep_for(seconds(2.5));  // every container reports once a second
    const auto rows = listener.rows(bus->now());
    if (rows.empty()) throw EnvironmentError("nothing reports its health on this host");
    show(options, rows);
    return 0;
  }
  for (const int number : {SIGINT, SIGTERM}) {
    std::signal(number, [](int) { ended = 1; });
  }
  while (ended == 0) {
    std::this_thread::sleep_for(seconds(options.period_s));
    show(options, listener.rows(bus->now()));
  }
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
