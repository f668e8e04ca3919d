// SPDX-License-Identifier: Apache-2.0
// How long the wheels turn after a press of the emergency stop at the ground station, many times
// under each of many conditions. See README.md of this folder.
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "foundation/program.hpp"
#include "foundation/temporary_folder.hpp"
#include "keystore/keystore.hpp"
#include "link/forger.hpp"
#include "peer.hpp"
#include "stack.hpp"
#include "storm.hpp"
#include "tocsin_idl/topics.hpp"

namespace {

using namespace tocsin;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr int domain = 40;  // of bringup/mission.yaml: the vehicle's host, the station's, the link
constexpr const char* vehicle_address = "10.77.0.1";
constexpr const char* station_address = "10.77.0.2";

double wall_s() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

BusOptions on_host(int host_domain) {
  BusOptions options;
  options.name = "stranger";
  options.host_domain = host_domain;
  return options;
}

/// As a peer at the station, on the link too.
BusOptions on_link() {
  BusOptions options = on_host(domain + 1);
  options.link_domain = domain + 2;
  options.link_address = station_address;
  options.link_peers = {vehicle_address};
  return options;
}

/// Somebody who turns the vehicle on the spot, past all components, so that it moves unless the
/// driver holds the stop.
void turn(Bus& bus) {
  const auto writer = bus.advertise({topic::CmdVel::info, &type_info<topic::CmdVel::Message>()});
  topic::CmdVel::Message message;
  message.angular().z(1);
  const auto whole = std::make_shared<const topic::CmdVel::Message>(message);
  for (;;) {
    (void)writer->write(whole);
    std::this_thread::sleep_for(milliseconds(20));
  }
}

/// A person at the station: asks ten times a second for what was typed last.
class Person {
 public:
  explicit Person(pid_t station) : pipe_(open()), peer_(station, on_host(domain + 1), asks()) {}
  ~Person() {
    ::close(pipe_[0]);
    ::close(pipe_[1]);
  }
  Person(const Person&) = delete;
  Person& operator=(const Person&) = delete;
  void wants(bool stop) const {
    const char word = stop ? '1' : '0';
    if (::write(pipe_[1], &word, 1) != 1) throw std::runtime_error("the person has gone");
  }

 private:
  static std::array<int, 2> open() {
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_NONBLOCK) != 0) throw std::runtime_error("no pipe");
    return pipe;
  }
  [[nodiscard]] std::function<void(Bus&)> asks() const {
    return [from = pipe_[0]](Bus& bus) {
      const auto writer = bus.advertise(
          {topic::EmergencyStopRequest::info, &type_info<topic::EmergencyStopRequest::Message>()});
      topic::EmergencyStopRequest::Message wanted;
      for (int turn = 0;; ++turn) {
        char word = 0;
        const bool typed = ::read(from, &word, 1) == 1;
        if (typed) wanted.data(word == '1');
        if (typed || turn % 100 == 0) {
          (void)writer->write(std::make_shared<const topic::EmergencyStopRequest::Message>(wanted));
        }
        std::this_thread::sleep_for(milliseconds(1));
      }
    };
  }
  const std::array<int, 2> pipe_;
  const Peer peer_;
};

struct Plan {
  int times = 50;
  bool loses = false;
  bool secured = false;
  std::string only;
};

/// A vehicle without a mission and its station, over the emulated radio.
class Site {
 public:
  explicit Site(const Plan& plan, int disk_mib = 0) {
    std::vector<std::string> arguments{bringup(), "--seed", "1"};
    if (plan.secured) {
      const std::string keys = folder_.path("keys");
      keystore::create(keys, std::time(nullptr));
      for (const char* const name : {"uxv", "gcs"}) {
        keystore::add(keys, {name, {{"rt/*"}, {"rt/*"}}}, std::time(nullptr));
      }
      arguments.insert(arguments.end(), {"--security", keys});
    }
    stack_ = std::make_unique<Stack>(arguments, disk_mib);
    wheels_ = stack_->scratch() + "/wheels";
    if (!Stack::eventually(seconds(40), [&] { return stack_->pid("gcs/recorder") != 0; })) {
      throw std::runtime_error(stack_->output());
    }
    watch_.emplace(stack_->pid("uxv/recorder"), on_host(domain), watch_wheels(wheels_));
    rogue_.emplace(stack_->pid("uxv/recorder"), on_host(domain), turn);
    person_.emplace(stack_->pid("gcs/recorder"));
    if (!moves(seconds(40))) throw std::runtime_error("does not move\n" + stack_->output());
    if (!plan.loses) return;
    stack_->control("radio.sock", "set mode bernoulli");
    stack_->control("radio.sock", "set loss 0.3");
  }
  /// [s] from the press to the last turn of a wheel that is followed by a second of rest; none: it
  /// did not stop.
  [[nodiscard]] std::optional<double> press() const {
    const double pressed = wall_s();
    person_->wants(true);
    const bool rests = Stack::eventually(seconds(10), [&] {
      return last_seen(wheels_) > std::max(pressed, last_moved(wheels_)) + 1;
    });
    if (!rests) return std::nullopt;
    return std::max(0.0, last_moved(wheels_) - pressed);
  }
  [[nodiscard]] bool release() const {
    person_->wants(false);
    return moves(seconds(20));
  }
  [[nodiscard]] bool moves(seconds limit) const {
    const double now = wall_s();
    return Stack::eventually(limit, [&] { return last_moved(wheels_) > now; });
  }
  [[nodiscard]] const Stack& stack() const { return *stack_; }

 private:
  [[nodiscard]] std::string bringup() const {
    return folder_.write("site.yaml",
                         "extends: mission.yaml\nstop_when_exits: ~\n"
                         "hosts:\n  uxv: {containers: [{payload: ~}]}\n"
                         "  gcs: {containers: [{view: ~}, {page: ~}, {mission: ~}]}\n");
  }
  const TemporaryFolder folder_;
  std::unique_ptr<Stack> stack_;
  std::string wheels_;
  std::optional<Peer> watch_;
  std::optional<Peer> rogue_;
  std::optional<Person> person_;
};

/// What is wrong while it is pressed: begun before each press, and for as long as what it returns
/// lives.
using Trouble = std::function<std::shared_ptr<void>(const Site&)>;

std::shared_ptr<void> nothing(const Site&) { return nullptr; }

Trouble frozen(const std::string& router, int time_s) {
  return [=](const Site& site) -> std::shared_ptr<void> {
    const pid_t pid = site.stack().pid(router);
    if (pid <= 0) throw std::runtime_error(router + " does not run");
    ::kill(pid, SIGSTOP);
    std::this_thread::sleep_for(seconds(time_s));
    ::kill(pid, SIGCONT);
    return nullptr;
  };
}

Trouble killed(const std::string& router) {
  return [=](const Site& site) -> std::shared_ptr<void> {
    const pid_t before = site.stack().pid(router);
    ::kill(before, SIGKILL);
    (void)Stack::eventually(seconds(10), [&] {
      const pid_t now = site.stack().pid(router);
      return now != 0 && now != before;
    });
    return nullptr;
  };
}

using Forge = std::function<void(const Forger& forger, const Forger::Overheard& victim, int turn)>;

/// Somebody on each host's network speaks to the other in its router's name, fifty times a second.
std::shared_ptr<void> forging(const Site& site, const Forge& forge) {
  struct Forgers {
    std::vector<std::unique_ptr<Peer>> all;
  };
  auto forgers = std::make_shared<Forgers>();
  for (const std::string host : {"uxv", "gcs"}) {
    const bool up = host == "uxv";
    const Forger::Way way{up ? vehicle_address : station_address,
                          up ? station_address : vehicle_address};
    forgers->all.push_back(std::make_unique<Peer>(site.stack().pid(host + "/recorder"), [=] {
      const Forger forger(domain + 2, way);
      const auto victim = forger.overhear(host);
      if (!victim) throw std::runtime_error("nothing is overheard of " + host);
      for (int turn = 0;; ++turn) {
        forge(forger, *victim, turn);
        std::this_thread::sleep_for(milliseconds(20));
      }
    }));
  }
  std::this_thread::sleep_for(milliseconds(1500));
  return forgers;
}

void departs(const Forger& forger, const Forger::Overheard& victim, int) {
  forger.send(Forger::departure_of(victim), victim.port);
}

void leases(const Forger& forger, const Forger::Overheard& victim, int turn) {
  forger.send(Forger::with_lease(victim, turn % 2 == 0 ? 0 : 0x7fffffff), victim.port);
}

void names(const Forger& forger, const Forger::Overheard& victim, int turn) {
  const auto number = static_cast<std::uint32_t>(turn % 128 + 1);
  forger.send(Forger::stranger_like(victim, number), forger.port());
}

void exaggerates(const Forger& forger, const Forger::Overheard&, int turn) {
  for (const Forger::Overheard& heard : forger.overhear_all()) {
    forger.send(Forger::exaggerated(heard.announcement, turn % 2 == 0 ? 5 : 1U << 20U), heard.port);
  }
}

Trouble with(Forge forge) {
  return [=](const Site& site) { return forging(site, forge); };
}

/// A stranger on the link publishes velocities for the vehicle.
std::shared_ptr<void> stranger(const Site& site) {
  auto peer = std::make_shared<Peer>(site.stack().pid("gcs/recorder"), on_link(), turn);
  std::this_thread::sleep_for(milliseconds(1500));
  return peer;
}

/// Odd packets for all sockets of both hosts, as many as they take.
std::shared_ptr<void> flood(const Site& site) {
  auto peers = std::make_shared<std::vector<std::unique_ptr<Peer>>>();
  for (const char* process : {"uxv/recorder", "gcs/recorder"}) {
    peers->push_back(std::make_unique<Peer>(site.stack().pid(process), [] {
      const fuzz::Attacker attacker;
      for (unsigned seed = 1;; ++seed) {
        fuzz::send_storm(attacker, {5000, 5000, 2000, seed});
      }
    }));
  }
  std::this_thread::sleep_for(milliseconds(500));
  return peers;
}

std::shared_ptr<void> full_disk(const Site& site) {
  std::ofstream file(site.stack().path("fill"), std::ios::app);
  const std::string block(1U << 16U, 'x');
  while (file << block << std::flush) {
  }
  return nullptr;
}

struct Condition {
  std::string name;
  Trouble trouble;
  bool lasts = false;  ///< the trouble begins once, and not before each press
  int disk_mib = 0;
};

std::vector<Condition> conditions() {
  return {{"nothing", nothing},
          {"station's router frozen 1 s", frozen("gcs/link", 1)},
          {"station's router frozen 5 s", frozen("gcs/link", 5)},
          {"station's router frozen 30 s", frozen("gcs/link", 30)},
          {"vehicle's router frozen 1 s", frozen("uxv/link", 1)},
          {"vehicle's router frozen 5 s", frozen("uxv/link", 5)},
          {"vehicle's router frozen 30 s", frozen("uxv/link", 30)},
          {"station's router killed", killed("gcs/link")},
          {"vehicle's router killed", killed("uxv/link")},
          {"forged departures", with(departs), true},
          {"forged leases", with(leases), true},
          {"forged names", with(names), true},
          {"forged origins and receipts", with(exaggerates), true},
          {"stranger's cmd_vel on the link", stranger, true},
          {"flood of odd packets", flood, true},
          {"full disk", full_disk, true, 24}};
}

struct Figures {
  std::vector<double> times_s;
  int never = 0;
  int not_released = 0;
};

/// The vehicle drives before each press: where it stands by a silent router, once that is received.
Figures run(const Plan& plan, const Condition& condition) {
  const Site site(plan, condition.disk_mib);
  Figures figures;
  std::shared_ptr<void> trouble;
  if (condition.lasts) trouble = condition.trouble(site);
  for (int i = 0; i < plan.times; ++i) {
    if (!condition.lasts) trouble = condition.trouble(site);
    if (!site.moves(seconds(20))) ++figures.not_released;
    if (const auto time_s = site.press()) {
      figures.times_s.push_back(*time_s);
    } else {
      ++figures.never;
    }
    if (!site.release()) ++figures.not_released;
  }
  std::sort(figures.times_s.begin(), figures.times_s.end());
  return figures;
}

/// Prints a line; whether each press stopped the wheels in time.
bool tell(const Condition& condition, const Figures& figures, double limit_s) {
  const auto& times = figures.times_s;
  const auto in_time =
      std::count_if(times.begin(), times.end(), [&](double one) { return one <= limit_s; });
  const double median = times.empty() ? -1 : times[times.size() / 2];
  const double worst = times.empty() ? -1 : times.back();
  fmt::print("{:<32}{:>8}{:>10.3f}{:>10.3f}{:>12}{:>8}{:>10}\n", condition.name, times.size(),
             median, worst, in_time, figures.never, figures.not_released);
  std::fflush(stdout);
  return figures.never == 0 && in_time == static_cast<std::ptrdiff_t>(times.size());
}

int campaign(const Plan& plan) {
  const double limit_s = plan.loses ? 2 : 0.5;
  fmt::print("wheels at rest after a press, {} times, {} link, {}; in time: {} s\n", plan.times,
             plan.secured ? "secured" : "plain", plan.loses ? "30 % loss" : "good", limit_s);
  fmt::print("{:<32}{:>8}{:>10}{:>10}{:>12}{:>8}{:>10}\n", "condition", "presses", "median s",
             "worst s", "in time", "never", "not freed");
  bool sound = true;
  for (const Condition& condition : conditions()) {
    if (condition.name.find(plan.only) == std::string::npos) continue;
    sound = tell(condition, run(plan, condition), limit_s) && sound;
  }
  return sound ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Plan plan;
  CLI::App app("How long wheels turn after a press of the emergency stop");
  app.add_option("--times", plan.times, "presses under each condition [50]");
  app.add_flag("--loss", plan.loses, "30 % of the packets are lost");
  app.add_flag("--secured", plan.secured, "a link with a keystore");
  app.add_option("--only", plan.only, "conditions with this text");
  CLI11_PARSE(app, argc, argv);
  return run_program("stop_campaign", [&] { return campaign(plan); });
}
