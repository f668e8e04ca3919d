// SPDX-License-Identifier: Apache-2.0
#include "strangers.hpp"

#include <sched.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <functional>
#include <thread>

#include "command_line/run_to_end.hpp"
#include "foundation/error.hpp"
#include "idl_support/raw_type.hpp"
#include "keystore/keystore.hpp"
#include "runtime/testing/relay.hpp"
#include "secured_cyclone.hpp"
#include "tocsin_idl/topics.hpp"
#include "within.hpp"

namespace tocsin::interop {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr int first_domain = 10;  // of five
constexpr int link_domain = first_domain + 4;
constexpr auto period = milliseconds(5);
constexpr auto patience = std::chrono::seconds(30);

/// What its process tells of it, behind what others print.
const std::string told_before = "stranger read ";

/// Stands in all that a stranger writes.
const std::string mark = "STRANGER";

/// Of all three, so that who is at the address of a peer does not help.
const std::string address = "127.0.0.1";

BusOptions options_of(Role role, const std::string& enclave) {
  BusOptions options;
  options.name = options.host = to_string(role);
  options.role = role;
  options.qos_file = TOCSIN_REPOSITORY "/config/qos.yaml";
  options.traffic_file = TOCSIN_REPOSITORY "/config/traffic.yaml";
  options.host_domain = first_domain + (role == Role::uxv ? 0 : 1);
  options.link_domain = link_domain;
  options.link_address = address;
  options.link_peers = {address};
  options.enclave = enclave;
  return options;
}

BusOptions on_host(BusOptions options) {
  options.link_address.clear();
  options.enclave.clear();
  return options;
}

/// A process of a host that writes all the time what its router carries.
template <class Topic>
class Talker {
 public:
  using Message = typename Topic::Message;
  Talker(const BusOptions& options, const Message& message)
      : bus_(make_fast_dds_bus(on_host(options))), thread_([this, message] { talk(message); }) {}
  ~Talker() {
    stopping_ = true;
    thread_.join();
  }
  Talker(const Talker&) = delete;
  Talker& operator=(const Talker&) = delete;

 private:
  void talk(const Message& message) {
    const auto writer = bus_->advertise({Topic::info, &type_info<Message>()});
    while (!stopping_) {
      (void)writer->write(std::make_shared<const Message>(message));
      std::this_thread::sleep_for(period);
    }
  }
  std::atomic<bool> stopping_{false};
  std::unique_ptr<Bus> bus_;
  std::thread thread_;
};

topic::Location::Message place(const std::string& text) {
  topic::Location::Message message;
  message.header().frame_id(text);
  return message;
}

topic::Goal::Message order(const std::string& text) {
  topic::Goal::Message message;
  std::uint64_t number = 0;
  std::memcpy(&number, text.data(), std::min(text.size(), sizeof number));
  message.mission(number);
  return message;
}

double milliseconds_between(Clock::time_point begin, Clock::time_point end) {
  return std::chrono::duration<double, std::milli>(end - begin).count();
}

bool is_marked(const link_event::LinkSample& one) {
  const auto& bytes = static_cast<const EncodedMessage*>(one.sample.content.get())->bytes;
  return std::search(bytes.begin(), bytes.end(), mark.begin(), mark.end()) != bytes.end();
}

std::size_t live_as_router(const Stranger& stranger) {
  BusOptions options = options_of(stranger.role, stranger.enclave);
  options.name = options.host = "stranger";
  options.host_domain += 2;
  Relay relay(options);
  if (stranger.role == Role::uxv) {
    const Talker<topic::Location> vehicle(options, place(mark));
    std::this_thread::sleep_for(stranger.time);
  } else {
    const Talker<topic::Goal> station(options, order(mark));
    std::this_thread::sleep_for(stranger.time);
  }
  return relay.crossed().size();
}

std::size_t live(const Stranger& stranger) {
  if (stranger.maker != "cyclone") return live_as_router(stranger);
  return speak_as_cyclone({link_domain, address, stranger.enclave}, mark, stranger.time);
}

std::vector<std::string> words_of(const Stranger& stranger) {
  return {"live", stranger.maker, to_string(stranger.role), std::to_string(stranger.time.count()),
          stranger.enclave};
}

Stranger stranger_of(const std::vector<std::string>& words) {
  const auto role = words.size() == 5 ? role_of(words[2]) : std::nullopt;
  if (!role) throw ConfigError("allowed: live fast_dds|cyclone uxv|gcs MILLISECONDS ENCLAVE");
  return {words[1], *role, words[4], milliseconds(std::stoi(words[3]))};
}

}  // namespace

int tell(const std::vector<std::string>& words) {
  const std::size_t read = live(stranger_of(words));
  std::printf("\n%s%zu\n", told_before.c_str(), read);
  return 0;
}

Identities::Identities() {
  for (const char* const name : {"good", "other"}) make(name);
  keystore::add(store("good"), {"stolen", {{"rt/*"}, {"rt/*"}}}, std::time(nullptr));
  fs::create_directories(store("copy/enclaves"));
  fs::copy(good("stolen"), revoked(), fs::copy_options::recursive);
  keystore::revoke(store("good"), "stolen", std::time(nullptr));
}

void Identities::make(const std::string& name) const {
  keystore::create(store(name), std::time(nullptr));
  for (const char* const host : {"uxv", "gcs", "rover"}) {
    keystore::add(store(name), {host, {{"rt/*"}, {"rt/*"}}}, std::time(nullptr));
  }
}

std::string Identities::good(const std::string& name) const {
  return store("good/enclaves/") + name;
}
std::string Identities::other(const std::string& name) const {
  return store("other/enclaves/") + name;
}
std::string Identities::revoked() const { return store("copy/enclaves/stolen"); }

Reached& Reached::operator+=(const Reached& more) {
  joined += more.joined;
  commanded += more.commanded;
  read += more.read;
  disturbed += more.disturbed;
  failed += more.failed;
  heard_ms = std::max(heard_ms, more.heard_ms);
  return *this;
}

bool enter_own_network() {
  if (::unshare(CLONE_NEWNET) != 0) return false;
  return std::system("ip link set lo up") == 0;
}

struct Link::Parts {
  explicit Parts(const Identities* identities)
      : station_options(options_of(Role::gcs, identities ? identities->good("gcs") : "")),
        vehicle_options(options_of(Role::uxv, identities ? identities->good("uxv") : "")),
        locations(vehicle_options, place("map")),
        goals(station_options, order("")),
        station(std::make_unique<Relay>(station_options)),
        vehicle(std::make_unique<Relay>(vehicle_options)) {}

  BusOptions station_options;
  BusOptions vehicle_options;
  Talker<topic::Location> locations;
  Talker<topic::Goal> goals;
  std::unique_ptr<Relay> station;
  std::unique_ptr<Relay> vehicle;

  /// Peers and flows that both have ever seen.
  [[nodiscard]] int seen() const {
    std::size_t all = 0;
    for (Relay* const one : {station.get(), vehicle.get()}) {
      all += one->peers().size() + one->peer_flows().size();
    }
    return static_cast<int>(all);
  }
};

Link::Link(const Identities* identities) : parts_(std::make_unique<Parts>(identities)) {
  (void)rejoin();
}
Link::~Link() = default;

double Link::rejoin() {
  parts_->vehicle.reset();
  (void)parts_->station->take_crossed();
  const auto begin = Clock::now();
  parts_->vehicle = std::make_unique<Relay>(parts_->vehicle_options);
  const auto has_crossed = [&](const std::unique_ptr<Relay>& to) {
    return within(patience, [&] { return !to->take_crossed().empty(); });
  };
  if (!has_crossed(parts_->station)) throw EnvironmentError("the right one is not heard");
  const auto heard = Clock::now();
  if (!has_crossed(parts_->vehicle)) throw EnvironmentError("the right one hears nothing");
  return milliseconds_between(begin, heard);
}

Reached Link::attempt(const Stranger& stranger) {
  (void)parts_->station->take_crossed();
  (void)parts_->vehicle->take_crossed();
  const int seen = parts_->seen();
  const auto begin = Clock::now();
  std::vector<std::string> command = words_of(stranger);
  command.insert(command.begin(), STRANGERS_PROGRAM);
  const Ended ended = run_to_end(command);
  const auto expected = (Clock::now() - begin) / period;
  Reached reached;
  const std::size_t told = ended.output.rfind(told_before);
  reached.failed = ended.code == 0 && told != std::string::npos ? 0 : 1;
  if (reached.failed == 0)
    reached.read = std::stoul(ended.output.substr(told + told_before.size()));
  reached.joined = parts_->seen() - seen;
  const auto heard = parts_->station->take_crossed();
  const auto obeyed = parts_->vehicle->take_crossed();
  for (const auto* const all : {&heard, &obeyed}) {
    for (const link_event::LinkSample& one : *all) {
      if (!is_marked(one)) continue;
      if (++reached.commanded == 1) reached.heard_ms = milliseconds_between(begin, one.received);
    }
  }
  reached.disturbed = 2 * static_cast<std::int64_t>(heard.size()) < expected ? 1 : 0;
  return reached;
}

}  // namespace tocsin::interop
