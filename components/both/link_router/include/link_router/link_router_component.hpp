// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "link_router/gate_keeper.hpp"
#include "link_router/history_requests.hpp"
#include "link_router/link_receiver.hpp"
#include "link_router/link_sender.hpp"
#include "runtime/component.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "runtime/middleware/thinning.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

class ArrivalLog;
class CallLink;
class FetchTrigger;
class BackfillLink;
class HeldArrivals;
class RouterStop;
class RouterStore;

/// The one owner of the link on its host. It takes what the traffic file names from the host and
/// puts it on the link, in the order, at the time and as often as `router::LinkSender` decides;
/// what comes from the link it gives to the host once. It follows its role's transmission state:
/// while that is passive, the classes that the traffic file pauses are silent.
class LinkRouterComponent final : public Component {
 public:
  struct Params {
    router::LinkRouterParams link;
    double silence_limit_s = 5.0;
    double report_period_s = 1.0;
    double budget_period_s = 0.2;
    std::string store_directory;
    int store_bytes = 64'000'000;
    double store_age_s = 86'400;
    int history_bytes = 256'000'000;
    double history_age_s = 86'400;
    double fetch_around_stop_s = 0;
    template <class Visitor>
    void visit(Visitor& v) {
      link.visit(v);
      v("silence_limit_s", silence_limit_s, {1, 600},
        "[s] without a transmission state for longer the gate opens");
      v("report_period_s", report_period_s, {0.1, 60}, "[s] between link states");
      v("budget_period_s", budget_period_s, {0.02, 10}, "[s] between budgets of adaptive topics");
      v("store_directory", store_directory,
        "folder of stored topics, for this router alone; empty: run folder/role/store, which later "
        "runs do not see");
      v("store_bytes", store_bytes, {100'000, 2e9}, "[B] of it at most; the oldest goes");
      v("store_age_s", store_age_s, {1, 1e8}, "[s] what is older goes");
      v("history_bytes", history_bytes, {100'000, 2e9},
        "[B] of the log of what crosses when it is asked for, folder history of store_directory");
      v("history_age_s", history_age_s, {1, 1e8}, "[s] what is older goes there");
      v("fetch_around_stop_s", fetch_around_stop_s, {0, 600},
        "[s] before and after an emergency stop, of which all that is logged crosses by itself; 0: "
        "none; other events: list fetch of the traffic file");
    }
  };

  /// Throws ConfigError when the process has no way over the link.
  LinkRouterComponent(Context& context, const Params& params);
  ~LinkRouterComponent() override;
  void tick(Time now) override;

 private:
  /// A flow of this host on its way to the link.
  struct Outgoing {
    FlowId on_link = 0;
    std::string topic;
    router::StreamRule rule;
    std::uint64_t sent_bytes = 0;
    Duration interval{0};                         ///< of each writer's samples at least; zero: any
    std::map<std::uint64_t, RateLimit> limits{};  ///< by writer
  };
  /// A flow of a peer on its way to the host.
  struct Incoming {
    PeerId peer = 0;
    std::uint32_t wire_id = 0;
    enum class Kind : std::uint8_t { samples, acknowledgements, backfills, services, calls };
    Kind kind = Kind::samples;
    router::StreamRule rule;
    Flow what;
  };

  void take_events(Time now);
  /// Whether the traffic file lets this sample of a flow cross.
  [[nodiscard]] static bool passes(Outgoing& flow, std::uint64_t writer, Time now);
  void on(const link_event::HostFlow& event, Time now);
  void on(const link_event::HostFlowGone& event, Time now);
  void on(const link_event::HostSample& event, Time now);
  void on(const link_event::PeerFound& event, Time now);
  void on(const link_event::PeerLost& event, Time now);
  void on(const link_event::PeerFlow& event, Time now);
  void on(const link_event::PeerFlowGone& event, Time now);
  void on(const link_event::PeerListens& event, Time now);
  void on(const link_event::HostListens& event, Time now);
  void on(const link_event::LinkSample& event, Time now);

  [[nodiscard]] static Incoming::Kind kind_of(const std::string& topic);
  void follow_gate(Time now);
  void give_held(Time now);
  void send(Time now);
  void answer(Time now);
  void keep_store(Time now);
  void take_requests(Time now);
  void fetch_around(const FetchTrigger& trigger, Time event, Time now);
  void take_acknowledgement(const Incoming& from, const CarriedSample& sample, Time now);
  void tell_budgets(Time now);
  void report(Time now);
  void report_traffic(Time now);
  [[nodiscard]] std::optional<router::StreamId> stream_of(std::uint32_t wire_id) const;

  OptionalInput<topic::TransmissionState> state_{*this};
  OptionalInput<topic::LogRequest> log_requests_{*this};
  std::vector<std::unique_ptr<FetchTrigger>> triggers_;  ///< what the log is fetched around
  Output<topic::LinkState> link_state_{*this};
  Output<topic::LinkBudget> budget_{*this};
  Output<topic::TrafficReport> traffic_{*this};
  const Params params_;
  router::GateKeeper keeper_;
  router::LinkSender sender_;
  router::LinkReceiver receiver_;
  std::unique_ptr<LinkBus> link_;
  std::unique_ptr<RouterStop> stop_;
  FlowId acknowledgements_;
  std::unique_ptr<RouterStore> store_;
  std::unique_ptr<RouterStore> history_;
  std::unique_ptr<ArrivalLog> arrivals_;
  std::unique_ptr<BackfillLink> backfills_;
  std::unique_ptr<CallLink> calls_;
  std::unique_ptr<HeldArrivals> held_;
  std::map<FlowId, Outgoing> outgoing_;  ///< by the flow on the host
  std::map<FlowId, Outgoing> own_;       ///< what routers tell each other, by the flow on the link
  std::map<FlowId, Outgoing*> by_link_;  ///< by the flow on the link
  std::map<FlowId, Incoming> incoming_;  ///< by the peer's flow
  std::map<PeerId, std::string> peers_;
  std::map<std::string, PeerId> lives_;
  router::StandingRequests standing_;  ///< of this host, for logs of others
  bool open_ = true;
  Time next_report_{};
  Time next_budget_{};
  Time next_keep_{};
};

}  // namespace tocsin
