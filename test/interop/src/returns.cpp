// SPDX-License-Identifier: Apache-2.0
#include "returns.hpp"

#include <signal.h>

#include <algorithm>
#include <stdexcept>
#include <thread>

#include "within.hpp"

namespace tocsin::interop {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using std::chrono::steady_clock;

constexpr seconds patience{60};
/// Of bringup/mission.yaml; the station's is the next.
constexpr int vehicle_domain = 40;

const std::vector<std::string>& makers() {
  static const std::vector<std::string> all{"tocsin", "cyclone", "fast_dds"};
  return all;
}

/// The mission without what drives and shows, and with the topic of the peers.
std::string bringup_file(const TemporaryFolder& folder) {
  (void)folder.write("peers_traffic.yaml",
                     "extends: traffic.yaml\n"
                     "uxv: {critical: {topics: [interop]}}\n"
                     "gcs: {critical: {topics: [interop]}}\n");
  return folder.write("peers.yaml",
                      "extends: mission.yaml\n"
                      "traffic: peers_traffic.yaml\n"
                      "stop_when_exits: ~\n"
                      "hosts:\n"
                      "  gcs:\n"
                      "    containers:\n"
                      "      - mission: ~\n"
                      "      - view: ~\n"
                      "      - page: ~\n");
}

std::vector<std::unique_ptr<PeerProcess>> peers_of(const std::string& host, int domain,
                                                   pid_t network) {
  std::vector<std::unique_ptr<PeerProcess>> peers;
  for (const std::string& maker : makers()) {
    const int lifespan_ms = static_cast<int>(RoutedPeers::lifespan.count());
    peers.push_back(std::make_unique<PeerProcess>(
        PeerOptions{maker, domain, host + "_" + maker, network, 0, lifespan_ms}));
  }
  return peers;
}

}  // namespace

std::string to_text(const Interruption& interruption) {
  const std::string time = std::to_string(interruption.time.count()) + " s";
  return interruption.process.empty() ? "outage of " + time
                                      : interruption.process + " stopped for " + time;
}

RoutedPeers::RoutedPeers() : stack_({bringup_file(folder_), "--seed", "1"}) {
  // Then both have the networks of their hosts, which the peers enter.
  wait_until(patience, [this] {
    return stack_.logged("gcs is on the link") && stack_.logged("uxv is on the link");
  });
  vehicle_ = peers_of("vehicle", vehicle_domain, stack_.pid("uxv/link"));
  station_ = peers_of("station", vehicle_domain + 1, stack_.pid("gcs/link"));
  const auto all_hear = [this] { return unheard(Time{}).empty(); };
  if (!within(patience, all_hear)) throw std::runtime_error(unheard({}) + stack_.output());
}

std::string RoutedPeers::unheard(Time since) const {
  std::string text;
  for (const Pair& one : pairs()) {
    if (one.reader.has_heard(one.writer, since)) continue;
    text += one.reader.name() + " does not hear " + one.writer.name() + "\n";
  }
  return text;
}

std::vector<RoutedPeers::Pair> RoutedPeers::pairs() const {
  std::vector<Pair> all;
  for (std::size_t v = 0; v < vehicle_.size(); ++v) {
    for (std::size_t s = 0; s < station_.size(); ++s) {
      const std::string both = makers()[v] + " " + makers()[s];
      all.push_back({*vehicle_[v], *station_[s], both});
      all.push_back({*station_[s], *vehicle_[v], both});
    }
  }
  return all;
}

void RoutedPeers::wait_until(seconds limit, const std::function<bool()>& condition) const {
  if (!within(limit, condition)) {
    throw std::runtime_error("not within " + std::to_string(limit.count()) + " s\n" +
                             stack_.output());
  }
}

RoutedPeers::Time RoutedPeers::interrupt(const Interruption& interruption) const {
  const bool outage = interruption.process.empty();
  const pid_t process = outage ? 0 : stack_.pid(interruption.process);
  const auto begin = steady_clock::now();
  if (outage) {
    stack_.control("radio.sock", "set outage " + std::to_string(interruption.time.count()));
  } else if (process <= 0 || ::kill(process, SIGSTOP) != 0) {
    throw std::runtime_error(interruption.process + " does not run");
  }
  std::this_thread::sleep_until(begin + interruption.time);
  if (!outage) ::kill(process, SIGCONT);
  return begin;
}

Return RoutedPeers::after(const Interruption& interruption) {
  const auto begin = interrupt(interruption);
  const auto back = begin + interruption.time;
  const auto all = pairs();
  for (const Pair& one : all) {  // what was under way may still have arrived
    if (interruption.time > seconds(2) && one.reader.has_heard(one.writer, begin + seconds(1))) {
      throw std::runtime_error(to_text(interruption) + ": samples crossed nevertheless");
    }
  }
  Return result;
  std::vector<bool> heard(all.size(), false);
  const auto look = [&] {
    const auto now = std::chrono::duration_cast<milliseconds>(steady_clock::now() - back);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (heard[i] || !all[i].reader.has_heard(all[i].writer, back)) continue;
      heard[i] = true;
      result.longest = now;
      for (const std::string& maker : makers()) {
        if (all[i].makers.find(maker) != std::string::npos) result.heard_after[maker] = now;
      }
    }
    return std::find(heard.begin(), heard.end(), false) == heard.end();
  };
  if (!within(patience, look)) {
    stack_.keep();
    throw std::runtime_error(to_text(interruption) + ": see " + stack_.folder() + "\n" +
                             unheard(back) + stack_.output());
  }
  for (const Pair& one : all) {
    const auto oldest = one.reader.oldest(one.writer, back);
    if (oldest <= result.oldest) continue;
    result.oldest = oldest;
    result.oldest_is = one.reader.name() + " of " + one.writer.name();
  }
  return result;
}

}  // namespace tocsin::interop
