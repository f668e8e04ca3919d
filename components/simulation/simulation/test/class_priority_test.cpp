// SPDX-License-Identifier: Apache-2.0
// Link messages go with the priority of their topic's class.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

#include "sim_host.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::simulation {
namespace {

/// Writes one sample on one side and reads the topic on the other.
template <class Topic>
class CrossingTopic {
 public:
  CrossingTopic(SimHost& from, SimHost& to)
      : subscription_(to.add_process(Topic::info.name).subscribe(endpoint(), receiver_)),
        publication_(from.add_process(Topic::info.name).advertise(endpoint())) {
    EXPECT_EQ(publication_->write(std::make_shared<const typename Topic::Message>()), Status::ok);
  }

 private:
  struct Nobody : Receiver {
    void receive(const Sample&) override {}
  };
  static Endpoint endpoint() { return {Topic::info, &type_info<typename Topic::Message>()}; }
  Nobody receiver_;
  std::unique_ptr<Subscription> subscription_;
  std::unique_ptr<Publication> publication_;
};

void run_for_two_seconds(Core& core, RadioLink& link) {
  const Time end = core.now + seconds(2);
  const auto next = [&] { return std::min(core.events.next(), link.next_event()); };
  for (Time at = next(); at <= end; at = next()) {
    core.now = std::max(core.now, at);
    core.events.run(core.now);
    link.advance();
  }
}

/// Keeps what the channel told last.
class ChannelWatch : public Observer {
 public:
  void on_channel(const radio::LinkReport& report, Time) override { report_ = report; }
  [[nodiscard]] std::uint64_t up(radio::AccessCategory category) const {
    return report_.uplink.categories[static_cast<std::size_t>(category)].pushed;
  }
  [[nodiscard]] std::uint64_t down(radio::AccessCategory category) const {
    return report_.downlink.categories[static_cast<std::size_t>(category)].pushed;
  }

 private:
  radio::LinkReport report_{};
};

TEST(ClassPriority, PacketsCarryTheDscpOfTheirTopicsClassAndAnswersTheSame) {
  using Category = radio::AccessCategory;
  const std::string config = TOCSIN_REPOSITORY "/config/";
  ChannelWatch watch;
  Core core;
  core.observer = &watch;
  RadioLink link(core, radio::ChannelParams{}, {}, 1);
  Network network{core, link, QosProfiles(config + "qos.yaml"), {}};
  SimHost uxv(network, "uxv", "uxv", config + "traffic.yaml");
  SimHost gcs(network, "gcs", "gcs", config + "traffic.yaml");
  const CrossingTopic<topic::TransmissionState> critical(uxv, gcs);  // a reliable topic
  const CrossingTopic<topic::Location> high(uxv, gcs);
  const CrossingTopic<topic::BatteryState> low(uxv, gcs);
  run_for_two_seconds(core, link);
  EXPECT_GE(watch.up(Category::voice), 1U);
  EXPECT_EQ(watch.up(Category::video), 1U);
  EXPECT_GE(watch.up(Category::background), 1U);
  EXPECT_EQ(watch.up(Category::best_effort), 0U);
  EXPECT_GE(watch.down(Category::voice), 1U);
  EXPECT_EQ(watch.down(Category::best_effort), 0U);
}

}  // namespace
}  // namespace tocsin::simulation
