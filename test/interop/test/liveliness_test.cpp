// SPDX-License-Identifier: Apache-2.0
// Leases of writers: each silence beyond the lease is noticed once, and nothing else is, between
// our runtime and Cyclone DDS in both directions.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <ros_idl/std_msgs.hpp>

#include "cyclone.hpp"
#include "foundation/temporary_folder.hpp"
#include "runtime/host_control.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"
#include "std_msgs.h"
#include "within.hpp"

namespace tocsin::interop {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using std::chrono::steady_clock;
using Message = std_msgs::msg::String;

constexpr milliseconds lease{1000};

struct Nobody : Receiver {
  void receive(const Sample&) override {}
};

std::unique_ptr<Bus> make_bus(int domain, const std::string& kind) {
  const TemporaryFolder folder;
  BusOptions options;
  options.name = "lease";
  options.host_domain = domain;
  options.qos_file = folder.write("qos.yaml", "lease: {reliability: reliable, liveliness: " + kind +
                                                  ", liveliness_lease_s: 1}\n");
  return make_fast_dds_bus(options);
}

CycloneParticipant::Qos qos_of(dds_liveliness_kind_t kind) {
  auto qos = CycloneParticipant::qos();
  dds_qset_reliability(qos.get(), DDS_RELIABILITY_RELIABLE, DDS_MSECS(100));
  dds_qset_liveliness(qos.get(), kind, DDS_MSECS(lease.count()));
  return qos;
}

/// A topic in each direction, and how often each reader has lost its writer.
class Both {
 public:
  Both(int domain, dds_liveliness_kind_t kind, const std::string& word)
      : cyclone_(domain), bus_(make_bus(domain, word)) {
    const TypeInfo& type = type_info<Message>();
    const auto topic = [&](const char* name) {
      return cyclone_.topic(std_msgs_msg_String_desc, name, type.name);
    };
    reader_ = cyclone_.reader(topic("rt/ours"), qos_of(kind));
    writer_ = cyclone_.writer(topic("rt/theirs"), qos_of(kind));
    publication_ = bus_->advertise({{"ours", "lease", Scope::host}, &type});
    subscription_ = bus_->subscribe({{"theirs", "lease", Scope::host}, &type}, nobody_);
  }
  void write() const {
    std_msgs_msg_String theirs{const_cast<char*>("")};
    (void)dds_write(writer_, &theirs);
    (void)publication_->write(std::make_shared<Message>());
  }
  [[nodiscard]] bool match() const {
    const auto health = bus_->host_control().health();
    return std::count_if(health.begin(), health.end(),
                         [](const EndpointHealth& one) { return one.matched == 1; }) == 2;
  }
  [[nodiscard]] int lost_by_cyclone() {
    dds_liveliness_changed_status_t status{};
    (void)dds_get_liveliness_changed_status(reader_, &status);
    lost_by_cyclone_ += std::max(status.not_alive_count_change, 0);
    alive_for_cyclone_ = status.alive_count == 1;
    return lost_by_cyclone_;
  }
  [[nodiscard]] bool alive_for_cyclone() {
    (void)lost_by_cyclone();
    return alive_for_cyclone_;
  }
  [[nodiscard]] int lost_by_ours() const {
    for (const EndpointHealth& one : bus_->host_control().health()) {
      if (one.topic == "theirs") return static_cast<int>(one.liveliness_lost);
    }
    return -1;
  }
  /// Returns the longest time between two writes.
  [[nodiscard]] steady_clock::duration write_for(milliseconds time) const {
    const auto begin = steady_clock::now();
    auto last = begin;
    steady_clock::duration longest{};
    while (last - begin < time) {
      write();
      std::this_thread::sleep_for(milliseconds(50));
      const auto now = steady_clock::now();
      longest = std::max(longest, now - last);
      last = now;
    }
    return longest;
  }

 private:
  CycloneParticipant cyclone_;
  std::unique_ptr<Bus> bus_;
  Nobody nobody_;
  dds_entity_t reader_ = 0;
  dds_entity_t writer_ = 0;
  std::unique_ptr<Publication> publication_;
  std::unique_ptr<Subscription> subscription_;
  int lost_by_cyclone_ = 0;
  bool alive_for_cyclone_ = false;
};

TEST(Liveliness, EachSilenceOfAWriterThatMustSpeakIsNoticedOnceByBothMakers) {
  Both sut(180, DDS_LIVELINESS_MANUAL_BY_TOPIC, "manual_by_topic");
  ASSERT_TRUE(eventually([&] { return sut.match(); }));
  int silences = 0;
  for (int attempt = 0; attempt < 10 && silences < 3; ++attempt) {
    ASSERT_TRUE(eventually([&] {
      sut.write();
      return sut.alive_for_cyclone();
    }));
    const int ours = sut.lost_by_ours();
    const int cyclone = sut.lost_by_cyclone();
    if (sut.write_for(2 * lease) > lease / 2) continue;  // the machine was elsewhere
    EXPECT_EQ(sut.lost_by_ours(), ours) << "while it spoke";
    EXPECT_EQ(sut.lost_by_cyclone(), cyclone) << "while it spoke";
    EXPECT_TRUE(eventually([&] { return sut.lost_by_ours() == ours + 1; }));
    EXPECT_TRUE(eventually([&] { return sut.lost_by_cyclone() == cyclone + 1; }));
    ++silences;
  }
  EXPECT_EQ(silences, 3);
}

TEST(Liveliness, AWriterWhoseLibrarySpeaksForItIsNotLostWhileItWritesNothing) {
  Both sut(181, DDS_LIVELINESS_AUTOMATIC, "automatic");
  ASSERT_TRUE(eventually([&] { return sut.match() && sut.alive_for_cyclone(); }));
  sut.write();
  EXPECT_FALSE(within(3 * lease, [&] { return sut.lost_by_ours() + sut.lost_by_cyclone() > 0; }));
}

}  // namespace
}  // namespace tocsin::interop
