// SPDX-License-Identifier: Apache-2.0
#include "stored_topics.hpp"

#include <unistd.h>

#include <algorithm>
#include <set>

#include "foundation/error.hpp"
#include "idl_support/topic_registry.hpp"
#include "sample_log/log_follower.hpp"

namespace tocsin {
namespace {

KnownTopic known(const std::string& name) {
  for (const KnownTopic& one : known_topics()) {
    if (one.info.name == name) return one;
  }
  throw ConfigError(name + ": is no topic of this stack");
}

using Writer = std::uint64_t;
using Id = std::pair<Writer, std::uint64_t>;

}  // namespace

class StationReaders::Reading final : public Receiver {
 public:
  Reading(Samples& shared, std::uint32_t topic, bool backfilled)
      : shared_(shared), topic_(topic), backfilled_(backfilled) {}
  /// All readers of the process; several threads.
  void receive(const Sample& sample) override {
    const std::size_t at = shared_.claimed.fetch_add(1);
    if (at >= most) return;
    shared_.samples[at] = {topic_, backfilled_, sample.source, sample.sequence,
                           sample.received_wall_ns};
    shared_.written[at].store(true, std::memory_order_release);
  }

 private:
  Samples& shared_;
  const std::uint32_t topic_;
  const bool backfilled_;
};

StationReaders::StationReaders(pid_t station, int domain, const std::string& qos,
                               const std::vector<std::string>& topics) {
  BusOptions options;
  options.qos_file = qos;
  options.name = "station_readers";
  options.host_domain = domain;
  peer_ = std::make_unique<Peer>(station, options, [this, topics](Bus& bus) {
    std::vector<std::unique_ptr<Reading>> readings;
    std::vector<std::unique_ptr<Subscription>> subscriptions;
    for (std::uint32_t i = 0; i < topics.size(); ++i) {
      const KnownTopic topic = known(topics[i]);
      const TopicInfo live = make_topic_info(topics[i], topic.info.qos, Scope::host);
      const TopicInfo filled = make_topic_info(topics[i] + "/backfilled", "event", Scope::host);
      for (const bool is_filled : {false, true}) {
        readings.push_back(std::make_unique<Reading>(*shared_, i, is_filled));
        subscriptions.push_back(
            bus.subscribe({is_filled ? filled : live, topic.type}, *readings.back()));
      }
    }
    for (;;) pause();
  });
}

std::vector<GotSample> StationReaders::got() const {
  std::vector<GotSample> all;
  const std::size_t count = std::min(shared_->claimed.load(), most);
  for (std::size_t i = 0; i < count; ++i) {
    if (shared_->written[i].load(std::memory_order_acquire)) all.push_back(shared_->samples[i]);
  }
  return all;
}

std::vector<LoggedOne> logged_in(const std::string& folder, const std::string& topic) {
  const sample_log::FolderSource files(folder);
  sample_log::LogFollower log(files, "/" + topic, {sample_log::LogStart::From::beginning});
  std::vector<LoggedOne> logged;
  for (auto some = log.read(1000); !some.empty(); some = log.read(1000)) {
    for (const auto& one : some) {
      logged.push_back({one.id.source, one.id.sequence, static_cast<std::int64_t>(one.place)});
    }
  }
  return logged;
}

StoredTopicFigures figures_of(std::uint32_t topic, const BothLogs& logs,
                              const std::vector<GotSample>& got, std::int64_t end_ns) {
  StoredTopicFigures figures;
  std::map<Id, GotSample> first;
  std::map<std::pair<Writer, bool>, std::uint64_t> last;
  std::int64_t begin_ns = 0;
  for (const GotSample& one : got) {
    if (one.topic != topic) continue;
    if (begin_ns == 0) begin_ns = one.at_ns;
    if (!first.try_emplace({one.source, one.sequence}, one).second) ++figures.twice;
    std::uint64_t& highest = last[{one.source, one.backfilled}];
    if (one.sequence < highest) ++figures.disordered;
    highest = std::max(highest, one.sequence);
  }
  std::map<Writer, std::uint64_t> last_logged;
  std::map<Id, std::int64_t> arrived;
  for (const LoggedOne& one : logs.station) arrived[{one.source, one.sequence}] = one.at_ns;
  for (const LoggedOne& one : logs.vehicle) {
    if (one.at_ns < begin_ns || one.at_ns > end_ns) continue;
    ++figures.logged;
    const auto before = last_logged.find(one.source);
    const bool has_gap = before != last_logged.end() && one.sequence > before->second;
    if (has_gap) figures.unrouted += one.sequence - before->second - 1;
    last_logged[one.source] = one.sequence;
    const auto there = arrived.find({one.source, one.sequence});
    if (there == arrived.end()) {
      ++figures.missing;
      continue;
    }
    figures.last_ns = std::max(figures.last_ns, there->second);
    const auto found = first.find({one.source, one.sequence});
    if (found == first.end()) {
      ++figures.unheard;
    } else {
      ++(found->second.backfilled ? figures.backfilled : figures.live);
    }
  }
  return figures;
}

}  // namespace tocsin
