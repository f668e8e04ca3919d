// SPDX-License-Identifier: Apache-2.0
// Stored streams over a random link, with logs, pauses, outages and routers that are killed: what
// must hold whatever happens. A failure names its seed.
#include <gtest/gtest.h>

#include <deque>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "link_router/backfill_receiver.hpp"
#include "link_router/backfill_sender.hpp"
#include "link_router/link_receiver.hpp"
#include "link_router/link_sender.hpp"
#include "sample_log/ledger.hpp"
#include "sample_log/sample_log.hpp"

namespace tocsin::router {
namespace {

using sample_log::SampleId;

constexpr Duration ms = std::chrono::milliseconds(1);
constexpr StreamId backfill_stream = 100;
constexpr StreamId streams = 4;
constexpr SourceId sources = 2;
constexpr std::size_t history_depth = 30;

std::string name_of(StreamId stream) { return "topic" + std::to_string(stream); }
SampleId id_of(StreamId stream, const Origin& origin) {
  return {sample_log::stream_key(name_of(stream)), origin.source, origin.sequence};
}

/// A vehicle's router with its log and a station's with its ledger. Files outlive a kill.
class RandomStore {
 public:
  explicit RandomStore(unsigned seed) : random_(seed) {
    if (seed % 2 == 0) limits_.bytes = 20'000;
    for (StreamId stream = 1; stream <= streams; ++stream) rules_[stream] = random_rule(stream);
    start_vehicle();
    start_station();
  }

  void run(int steps) {
    for (int i = 0; i < steps && !::testing::Test::HasFailure(); ++i) {
      disturb();
      step(true);
    }
  }
  /// The link is good and nobody disturbs: everything must come.
  void settle() {
    loss_ = 0;
    delay_ms_ = 5;
    pause(false);
    for (int i = 0; i < 60'000 && (i % 100 != 0 || !missing().empty()); ++i) step(false);
    for (const SampleId& id : missing()) {
      ADD_FAILURE() << "never came: sequence " << id.sequence << " of " << id.source;
    }
  }
  [[nodiscard]] std::size_t backfilled() const { return backfilled_; }
  [[nodiscard]] std::size_t retired() const { return retired_.size(); }

 private:
  struct Offered {
    StreamId stream;
    Origin origin;
    std::size_t bytes;
  };
  struct OnAir {
    Transmission what;
    TransmissionNumber number;
    BackfillBatch batch;
  };
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  bool chance(double p) { return below(100000) < static_cast<int>(p * 100000); }

  StreamRule random_rule(StreamId stream) {
    StreamRule rule;
    rule.name = name_of(stream);
    rule.traffic_class = traffic_classes[stream % 4];
    rule.stored = true;
    rule.repaired = chance(0.5);
    rule.depth = static_cast<std::size_t>(chance(0.5) ? 1 : 1 + below(4));
    if (chance(0.4)) rule.lifespan = (50 + below(2000)) * ms;
    rule.durable = chance(0.3);
    if (rule.traffic_class >= TrafficClass::normal) {
      rule.while_paused = static_cast<WhilePaused>(below(3));
    }
    return rule;
  }

  [[nodiscard]] std::int64_t wall_ns() const { return now_.time_since_epoch().count(); }

  void start_vehicle() {
    sender_ = std::make_unique<LinkSender>(LinkRouterParams{});
    ++vehicle_instance_;
    numbers_.clear();
    backfill_ = std::make_unique<BackfillSender>(LinkRouterParams{});
    log_.reset();
    log_ =
        std::make_unique<sample_log::SampleLog>(vehicle_files_, limits_, Instant{now_, wall_ns()});
    air_.clear();
    confirmations_.clear();
    paused_ = false;
    for (const auto& [stream, rule] : rules_) {
      sender_->add_stream(stream, rule);
      log_->add({rule.name, "/" + rule.name, {}, {}});
    }
    sender_->add_backfill_stream(backfill_stream);
    if (receiver_) receiver_->on_peer("vehicle", vehicle_instance_);
    meet();
    read_log_amid_histories();
  }
  /// Writers give their history again; the answer that the log is open comes at any moment.
  void read_log_amid_histories() {
    const auto histories = histories_now();
    const auto before = static_cast<std::size_t>(below(static_cast<int>(histories.size()) + 1));
    for (std::size_t i = 0; i < before; ++i) announce(histories[i]);
    for (const SampleId& id : log_->waiting()) backfill_->recover(id);
    for (std::size_t i = 0; i < before; ++i) log(histories[i]);
    for (std::size_t i = before; i < histories.size(); ++i) {
      announce(histories[i]);
      log(histories[i]);
    }
  }
  void start_station() {
    receiver_ = std::make_unique<LinkReceiver>();
    ++station_instance_;
    filled_ = std::make_unique<BackfillReceiver>();
    ledger_.reset();
    ledger_ = std::make_unique<sample_log::Ledger>(station_files_, "given");
    filled_->recover(ledger_->done());
    confirmations_.clear();
    receiver_->on_peer("vehicle", vehicle_instance_);
    meet();
  }
  void meet() {
    if (!receiver_) return;
    sender_->on_peer("station", station_instance_, now_);
    for (const auto& [stream, rule] : rules_) {
      receiver_->on_stream("vehicle", stream, rule);
      sender_->set_wanted("station", stream, true, now_);
    }
    StreamRule any;
    any.name = "backfill";
    any.depth = 1000;
    receiver_->on_stream("vehicle", backfill_stream, any);
    sender_->set_wanted("station", backfill_stream, true, now_);
    backfill_->begin_session();
  }

  void disturb() {
    if (chance(0.002)) loss_ = chance(0.4) ? 1 : 0.01 * below(60);
    if (chance(0.002)) delay_ms_ = 1 + below(200);
    if (chance(0.003)) pause(!paused_);
    if (chance(0.001)) start_vehicle();
    if (chance(0.001)) start_station();
  }
  void pause(bool paused) {
    paused_ = paused;
    sender_->set_paused(paused, now_);
  }

  void step(bool offers) {
    now_ += Duration{1 + below(8'000'000)};
    if (offers) offer();
    arrive();
    send();
    follow_fates();
    answer();
    for (const SampleId& id : log_->retire(now_)) {
      backfill_->on_retired(id);
      retired_.insert(id);
    }
    const auto wanted = backfill_->take_wanted();
    if (!wanted.empty()) backfill_->on_read(wanted, log_->read(wanted));
  }

  void offer() {
    while (chance(0.2)) {
      const auto stream = static_cast<StreamId>(1 + below(streams));
      const auto source = static_cast<SourceId>(below(sources));
      const Origin origin{source, ++sequences_[{stream, source}], now_};
      const auto bytes = static_cast<std::size_t>(1 + below(chance(0.1) ? 6000 : 600));
      const Offered one{stream, origin, bytes};
      announce(one);
      log(one);
      offered_.insert(id_of(stream, origin));
      auto& history = histories_[{stream, source}];
      history.push_back(one);
      if (history.size() > history_depth) history.pop_front();
    }
  }
  void announce(const Offered& one) {
    backfill_->offer(id_of(one.stream, one.origin));
    sender_->offer(one.stream, {one.origin, one.bytes, nullptr}, now_);
  }
  void log(const Offered& one) {
    const SampleId id = id_of(one.stream, one.origin);
    const auto logged =
        log_->append({{id, wall_ns(), std::vector<std::uint8_t>(one.bytes)}}, {now_, wall_ns()});
    backfill_->on_logged(id, logged.at(0));
  }
  [[nodiscard]] std::vector<Offered> histories_now() const {
    std::vector<Offered> all;
    for (const auto& entry : histories_) {
      for (const Offered& one : entry.second) {
        if (retired_.count(id_of(one.stream, one.origin)) == 0) all.push_back(one);
      }
    }
    return all;
  }

  void send() {
    while (const auto one = sender_->next(now_)) put(*one, {});
    while (sender_->may_backfill(now_)) {
      const auto batch = backfill_->next(now_, sender_->capacity_bytes_per_s(now_));
      if (!batch) break;
      EXPECT_FALSE(paused_) << "silent while paused";
      std::size_t bytes = 160;
      for (const auto& entry : batch->samples) bytes += entry.bytes.size() + 28;
      const Origin origin{0, std::uint64_t{batch->session} << 32U | batch->number, now_};
      const Sample sample{origin, bytes, nullptr};
      for (const Transmission& one : sender_->backfill(backfill_stream, sample, now_)) {
        put(one, *batch);
      }
    }
    EXPECT_GT(sender_->deadline(now_), now_);
  }
  void put(const Transmission& one, const BackfillBatch& batch) {
    const TransmissionNumber number = ++numbers_[one.stream];
    sender_->on_written(one, number);
    if (chance(loss_)) return;
    const int copies = chance(0.02) ? 2 : 1;
    for (int i = 0; i < copies; ++i) {
      air_.emplace(now_ + (1 + below(delay_ms_)) * ms, OnAir{one, number, batch});
    }
  }

  void follow_fates() {
    std::vector<SampleId> done;
    for (const StoredFate& one : sender_->take_fates()) {
      const SampleId id = id_of(one.stream, one.origin);
      if (backfill_->on_fate(id, one.fate)) done.push_back(id);
    }
    log_->confirm(done);
  }

  void arrive() {
    for (; !air_.empty() && air_.begin()->first <= now_; air_.erase(air_.begin())) {
      const auto& [one, number, batch] = air_.begin()->second;
      const Origin& origin = one.sample.origin;
      const Arrived arrived{one.stream, number, origin, one.piece, nullptr};
      if (!receiver_->on_piece("vehicle", arrived, now_)) continue;
      const auto disposition = receiver_->on_arrived("vehicle", arrived, now_);
      if (one.stream == backfill_stream) {
        take(batch);
      } else if (disposition == Disposition::deliver) {
        deliver_live(id_of(one.stream, origin));
      }
    }
  }
  void deliver_live(const SampleId& id) {
    // A restarted receiver gets the newest of a durable stream again, as a late reader does.
    if (!filled_->on_live(id)) return;
    EXPECT_TRUE(delivered_.insert(id).second) << "delivered twice, live";
    (void)ledger_->add(id);
    EXPECT_EQ(ledger_->save(), mcap::Kept::all);
  }
  void take(const BackfillBatch& batch) {
    for (const BackfillBatch& one : filled_->on_batch("vehicle", vehicle_instance_, batch)) {
      for (const auto& entry : one.samples) {
        ++backfilled_;
        EXPECT_TRUE(delivered_.insert(entry.id).second) << "delivered twice";
        auto& last = last_filled_[{entry.id.stream, entry.id.source}];
        EXPECT_GT(entry.id.sequence, last) << "out of the order of its writer";
        last = entry.id.sequence;
        (void)ledger_->add(entry.id);
      }
    }
    EXPECT_EQ(ledger_->save(), mcap::Kept::all);
  }

  void answer() {
    while (const auto acknowledgement = receiver_->take_acknowledgement(now_)) {
      if (chance(loss_)) continue;
      confirmations_.emplace(now_ + (1 + below(delay_ms_)) * ms,
                             std::make_pair(acknowledgement->acknowledgement,
                                            filled_->progress("vehicle", vehicle_instance_)));
    }
    for (; !confirmations_.empty() && confirmations_.begin()->first <= now_;
         confirmations_.erase(confirmations_.begin())) {
      sender_->on_acknowledgement("station", confirmations_.begin()->second.first, now_);
      log_->confirm(backfill_->on_progress(confirmations_.begin()->second.second, now_));
    }
  }

  [[nodiscard]] std::vector<SampleId> missing() const {
    std::vector<SampleId> missing;
    for (const SampleId& id : offered_) {
      if (delivered_.count(id) == 0 && retired_.count(id) == 0) missing.push_back(id);
    }
    return missing;
  }
  std::mt19937 random_;
  sample_log::LogLimits limits_;
  std::map<StreamId, StreamRule> rules_;
  Time now_{std::chrono::hours(1)};
  sample_log::MemoryFiles vehicle_files_;
  sample_log::MemoryFiles station_files_;
  InstanceId vehicle_instance_ = 0;
  InstanceId station_instance_ = 1000;
  std::unique_ptr<LinkSender> sender_;
  std::unique_ptr<BackfillSender> backfill_;
  std::unique_ptr<sample_log::SampleLog> log_;
  std::unique_ptr<LinkReceiver> receiver_;
  std::unique_ptr<BackfillReceiver> filled_;
  std::unique_ptr<sample_log::Ledger> ledger_;
  bool paused_ = false;
  double loss_ = 0;
  int delay_ms_ = 5;
  std::map<StreamId, TransmissionNumber> numbers_;
  std::multimap<Time, OnAir> air_;
  std::multimap<Time, std::pair<LinkAcknowledgement, BackfillProgress>> confirmations_;
  std::map<std::pair<StreamId, SourceId>, std::uint64_t> sequences_;
  std::map<std::pair<StreamId, SourceId>, std::deque<Offered>> histories_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::uint64_t> last_filled_;
  std::set<SampleId> offered_;
  std::set<SampleId> delivered_;
  std::set<SampleId> retired_;
  std::size_t backfilled_ = 0;
};

TEST(RandomStore, LosesNothingButByTheLogsBoundsAndDeliversEachSampleOnceAndInOrder) {
  std::size_t backfilled = 0;
  std::size_t retired = 0;
  for (unsigned seed = 1; seed <= 16 && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomStore store(seed);
    store.run(1500);
    store.settle();
    backfilled += store.backfilled();
    retired += store.retired();
  }
  EXPECT_GT(backfilled, 1500U);
  EXPECT_GT(retired, 0U);
}

}  // namespace
}  // namespace tocsin::router
