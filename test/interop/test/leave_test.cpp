// SPDX-License-Identifier: Apache-2.0
// Participants that leave in good order, long before a lease would end: 5 s for ours, 10 s for
// those of Cyclone DDS, 20 s for those of Fast DDS.
#include <gtest/gtest.h>

#include <algorithm>

#include "cyclone.hpp"
#include "peer.hpp"
#include "peer_process.hpp"
#include "runtime/middleware/host_graph.hpp"
#include "std_msgs.h"
#include "within.hpp"

namespace tocsin::interop {
namespace {

using std::chrono::seconds;

/// A peer looks each 50 ms whether it is to leave.
constexpr seconds at_once{2};

BusOptions on(int domain) {
  BusOptions options;
  options.name = "observer";
  options.host_domain = domain;
  return options;
}

/// How many ends of the peers' topic we know.
auto ends_of_peers(const HostGraph& graph) {
  const auto ends = graph.ends();
  return std::count_if(ends.begin(), ends.end(),
                       [](const GraphEnd& end) { return end.topic == topic_on_wire; });
}

TEST(Leave, AParticipantOfAnotherMakerThatIsDeletedIsForgottenAtOnce) {
  int domain = 160;
  for (const char* const maker : {"cyclone", "fast_dds"}) {
    const auto graph = make_host_graph(on(domain));
    PeerProcess theirs(maker, domain, maker);
    const PeerProcess ours("tocsin", domain, "ours");
    ASSERT_TRUE(eventually([&] {
      return ends_of_peers(*graph) == 4 && theirs.has_heard(ours) && ours.has_heard(theirs);
    })) << maker;
    theirs.leave();
    EXPECT_TRUE(within(at_once, [&] { return ends_of_peers(*graph) == 2; })) << maker;
    ++domain;
  }
}

/// A writer and a reader of the peers' topic, which tell whom they have matched.
class CycloneObserver {
 public:
  explicit CycloneObserver(int domain) : participant_(domain) {
    const auto qos = CycloneParticipant::qos();
    dds_qset_reliability(qos.get(), DDS_RELIABILITY_RELIABLE, DDS_MSECS(100));
    const dds_entity_t topic =
        participant_.topic(std_msgs_msg_String_desc, topic_on_wire, type_on_wire);
    reader_ = participant_.reader(topic, qos);
    writer_ = participant_.writer(topic, qos);
  }
  /// Without its own.
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> readers_and_writers() const {
    dds_publication_matched_status_t readers{};
    dds_subscription_matched_status_t writers{};
    (void)dds_get_publication_matched_status(writer_, &readers);
    (void)dds_get_subscription_matched_status(reader_, &writers);
    return {readers.current_count - 1, writers.current_count - 1};
  }

 private:
  CycloneParticipant participant_;
  dds_entity_t reader_ = 0;
  dds_entity_t writer_ = 0;
};

TEST(Leave, OursIsForgottenAtOnceByCycloneDds) {
  constexpr int domain = 162;
  const CycloneObserver sut(domain);
  PeerProcess ours("tocsin", domain, "ours");
  const std::pair<std::uint32_t, std::uint32_t> both{1, 1};
  const std::pair<std::uint32_t, std::uint32_t> none{0, 0};
  ASSERT_TRUE(eventually([&] { return sut.readers_and_writers() == both; }));
  ours.leave();
  EXPECT_TRUE(within(at_once, [&] { return sut.readers_and_writers() == none; }));
}

}  // namespace
}  // namespace tocsin::interop
