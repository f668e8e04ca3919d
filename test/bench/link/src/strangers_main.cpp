// SPDX-License-Identifier: Apache-2.0
// Tries to get onto a secured link: a ground station's router with a good identity, by real UDP on
// loopback, and one participant after the other that should not be let in. Between them, and in the
// end, one that should.
// usage: link_strangers [TRIES [MILLISECONDS [KIND]]]
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "foundation/program.hpp"
#include "foundation/temporary_folder.hpp"
#include "keystore/keystore.hpp"
#include "link/relay.hpp"
#include "measure.hpp"
#include "stack.hpp"
#include "tocsin_idl/topics.hpp"

namespace {

using namespace tocsin;
namespace fs = std::filesystem;
using std::chrono::milliseconds;

/// Of three. Fast DDS numbers the participants of a process, and their ports must stay below
/// 65,536.
constexpr int first_domain = 10;

BusOptions options_of(Role role) {
  BusOptions options;
  options.name = options.host = to_string(role);
  options.role = role;
  options.qos_file = Stack::share("config/qos.yaml");
  options.traffic_file = Stack::share("config/traffic.yaml");
  options.host_domain = first_domain + (role == Role::uxv ? 0 : 1);
  options.link_domain = first_domain + 2;
  options.link_address = "127.0.0.1";
  options.link_peers = {"127.0.0.1"};
  return options;
}

/// Keystores: the good one, another authority's, and a copy from before a revocation.
class Identities {
 public:
  Identities() {
    for (const char* const name : {"good", "other"}) make(name);
    keystore::add(store("good"), {"stolen", {{"rt/*"}, {"rt/*"}}}, std::time(nullptr));
    fs::create_directories(store("copy/enclaves"));
    fs::copy(store("good/enclaves/stolen"), store("copy/enclaves/stolen"),
             fs::copy_options::recursive);
    keystore::revoke(store("good"), "stolen", std::time(nullptr));
  }
  [[nodiscard]] BusOptions options(Role role, const std::string& enclave) const {
    BusOptions secured = options_of(role);
    secured.enclave = store(enclave);
    return secured;
  }

 private:
  void make(const std::string& name) const {
    keystore::create(store(name), std::time(nullptr));
    for (const char* const host : {"uxv", "gcs"}) {
      keystore::add(store(name), {host, {{"rt/*"}, {"rt/*"}}}, std::time(nullptr));
    }
  }
  [[nodiscard]] std::string store(const std::string& name) const { return folder_.path(name); }
  const TemporaryFolder folder_;
};

/// A process of a host that writes all the time what its router carries.
template <class Topic>
class Talker {
 public:
  explicit Talker(Role role) : bus_(make_fast_dds_bus(on_host(role))) {
    thread_ = std::thread([this] {
      const auto writer = bus_->advertise({Topic::info, &type_info<typename Topic::Message>()});
      while (!stopping_) {
        (void)writer->write(std::make_shared<const typename Topic::Message>());
        std::this_thread::sleep_for(milliseconds(5));
      }
    });
  }
  ~Talker() {
    stopping_ = true;
    thread_.join();
  }
  Talker(const Talker&) = delete;
  Talker& operator=(const Talker&) = delete;

 private:
  static BusOptions on_host(Role role) {
    BusOptions options = options_of(role);
    options.link_address.clear();
    return options;
  }
  std::unique_ptr<Bus> bus_;
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

/// What a stranger has reached.
struct Reached {
  std::size_t joined = 0;     ///< the station took it for a peer, or saw a flow of it
  std::size_t commanded = 0;  ///< samples of it that the station got
  std::size_t read = 0;       ///< samples of the station that it got
};

using Stranger = std::function<std::size_t()>;  ///< lives for a while; samples that it read

/// The right one's time from its start to its first sample at the station [ms].
double join(Relay& station, const BusOptions& options) {
  const std::size_t before = station.crossed().size();
  const auto begin = std::chrono::steady_clock::now();
  const Relay good(options);
  while (station.crossed().size() == before) std::this_thread::sleep_for(milliseconds(1));
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
      .count();
}

/// The two who may be on the link.
struct Routers {
  BusOptions station;
  BusOptions vehicle;
};

void campaign(const std::string& name, const Stranger& stranger, int tries,
              const Routers& routers) {
  constexpr int tries_between = 100;
  Relay station(routers.station);
  bench::Series joins;
  const auto admit = [&] {
    joins.add(static_cast<std::int64_t>(1e6 * join(station, routers.vehicle)));
  };
  admit();
  Reached reached;
  for (int i = 1; i <= tries; ++i) {
    const std::size_t peers = station.peers().size();
    const std::size_t flows = station.peer_flows().size();
    const std::size_t crossed = station.crossed().size();
    reached.read += stranger();
    reached.joined += station.peers().size() - peers + station.peer_flows().size() - flows;
    reached.commanded += station.crossed().size() - crossed;
    if (i % tries_between == 0) admit();
  }
  fmt::print("{:<28} {:5} tries: joined {}, samples written {}, read {}; ", name, tries,
             reached.joined, reached.commanded, reached.read);
  fmt::print("the right one joins in {:.0f} ms, at most {:.0f}\n", 1e-6 * joins.percentile(0.5),
             1e-6 * joins.percentile(1));
  std::fflush(stdout);
}

/// A participant of Cyclone DDS that writes and reads, as a process.
std::size_t cyclone(milliseconds time) {
  const pid_t pid = ::fork();
  if (pid == 0) {
    ::setenv("CYCLONEDDS_URI",
             "<General><Interfaces><NetworkInterface address='127.0.0.1'/></Interfaces>"
             "<AllowMulticast>false</AllowMulticast></General><Discovery><Peers>"
             "<Peer address='127.0.0.1'/></Peers></Discovery>",
             1);
    (void)!std::freopen("/dev/null", "w", stdout);
    (void)!std::freopen("/dev/null", "w", stderr);
    const std::string domain = std::to_string(first_domain + 2);
    ::execlp("ddsperf", "ddsperf", "-i", domain.c_str(), "pub", "100Hz", "size", "64", nullptr);
    ::_exit(127);
  }
  std::this_thread::sleep_for(time);
  ::kill(pid, SIGKILL);
  ::waitpid(pid, nullptr, 0);
  return 0;
}

void try_all(int tries, milliseconds time, const std::string& only) {
  const Identities identities;
  const Talker<topic::Location> vehicle(Role::uxv);
  const Talker<topic::Goal> station(Role::gcs);
  const auto as = [time](const BusOptions& options) {
    return [time, options] {
      Relay relay(options);
      std::this_thread::sleep_for(time);
      return relay.crossed().size();
    };
  };
  const Routers plain{options_of(Role::gcs), options_of(Role::uxv)};
  const Routers secured{identities.options(Role::gcs, "good/enclaves/gcs"),
                        identities.options(Role::uxv, "good/enclaves/uxv")};
  const Stranger nobody = as(options_of(Role::uxv));
  const Stranger vendor = [time] { return cyclone(2 * time); };
  constexpr int few = 5;  // that this program sees who gets in
  campaign("on a plain link: no identity", nobody, few, plain);
  campaign("on a plain link: Cyclone DDS", vendor, few, plain);
  campaign("the right identity", as(secured.vehicle), few, secured);
  const std::vector<std::pair<std::string, Stranger>> strangers{
      {"no identity", nobody},
      {"another authority's", as(identities.options(Role::uxv, "other/enclaves/uxv"))},
      {"revoked", as(identities.options(Role::uxv, "copy/enclaves/stolen"))},
      {"Cyclone DDS", vendor}};
  for (const auto& [name, stranger] : strangers) {
    if (only.empty() || only == name) campaign(name, stranger, tries, secured);
  }
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("link_strangers", [&] {
    try_all(argc > 1 ? std::stoi(argv[1]) : 1000, milliseconds(argc > 2 ? std::stoi(argv[2]) : 300),
            argc > 3 ? argv[3] : "");
    return 0;
  });
}
