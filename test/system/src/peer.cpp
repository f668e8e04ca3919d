// SPDX-License-Identifier: Apache-2.0
#include "peer.hpp"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>

#include "deployment/running_host.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

/// Appends each sample as a line.
class WheelLog : public Receiver {
 public:
  explicit WheelLog(const std::string& file) : file_(file, std::ios::app) { file_.precision(15); }
  void receive(const Sample& sample) override {
    const auto* odom = static_cast<const topic::Odom::Message*>(sample.message.get());
    const auto& twist = odom->twist().twist();
    const double speed = std::hypot(twist.linear().x(), 0.1 * twist.angular().z());
    file_ << 1e-9 * static_cast<double>(sample.received_wall_ns) << ' ' << speed << std::endl;
  }

 private:
  std::ofstream file_;
};

template <class See>
void read(const std::string& file, See see) {
  std::ifstream lines(file);
  double wall_s = 0;
  double speed_mps = 0;
  while (lines >> wall_s >> speed_mps) see(wall_s, speed_mps);
}

}  // namespace

Peer::Peer(pid_t process, const BusOptions& domains, const std::function<void(Bus&)>& job)
    : Peer(process, [&] {
        const auto bus = make_fast_dds_bus(domains);
        job(*bus);
      }) {}

Peer::Peer(pid_t process, const std::function<void()>& job) : pid_(fork()) {
  if (pid_ != 0) return;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  try {
    deployment::enter_namespaces(process);
    job();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "peer: %s\n", error.what());
  }
  _exit(0);
}

Peer::~Peer() { kill(); }

void Peer::stop() { ::kill(pid_, SIGSTOP); }

void Peer::resume() { ::kill(pid_, SIGCONT); }

void Peer::kill() {
  if (pid_ <= 0) return;
  ::kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
  pid_ = 0;
}

BusOptions on_host(int domain) {
  BusOptions options;
  options.name = "peer";
  options.host_domain = domain;
  return options;
}

double wall_s() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

std::function<void(Bus&)> watch_wheels(const std::string& file) {
  return [file](Bus& bus) {
    WheelLog log(file);
    const auto odom = bus.subscribe({topic::Odom::info, &type_info<topic::Odom::Message>()}, log);
    for (;;) pause();
  };
}

double last_moved(const std::string& file) {
  double last = 0;
  read(file, [&](double wall_s, double speed_mps) {
    if (speed_mps > 0.01) last = wall_s;
  });
  return last;
}

double last_seen(const std::string& file) {
  double last = 0;
  read(file, [&](double wall_s, double) { last = wall_s; });
  return last;
}

}  // namespace tocsin
