// SPDX-License-Identifier: Apache-2.0
#include "transport/stop_channel.hpp"

#include <gtest/gtest.h>

#include "foundation/temporary_folder.hpp"
#include "keystore/keystore.hpp"
#include "link/rtps_bytes.hpp"

namespace tocsin {
namespace {

using std::chrono::milliseconds;

constexpr std::uint32_t vehicle = 0x0a4d0001;
constexpr std::uint32_t station = 0x0a4d0002;
constexpr std::int64_t wall_s = 1'795'000'000;
constexpr std::size_t packet_bytes = 1400;

StopValue value(bool stands, std::uint64_t number = 1) {
  StopValue one;
  one.host = "gcs";
  one.instance = 5;
  one.number = number;
  one.stands = stands;
  return one;
}

/// The station's channel, and the vehicle's; packets between them.
class StopChannelTest : public ::testing::Test {
 protected:
  void open(const std::string& station_enclave = "", const std::string& vehicle_enclave = "") {
    station_.emplace(StopChannel::Options{{vehicle}, station_enclave, packet_bytes});
    vehicle_.emplace(
        StopChannel::Options{{station}, vehicle_enclave, packet_bytes, [this] { ++news_; }});
  }
  /// A packet of the station's participant with a sample, and what rides in it.
  static Bytes packet(const std::shared_ptr<const Bytes>& rider) {
    Bytes bytes = message();
    append(bytes, data, data_of(7));
    if (rider) bytes.insert(bytes.end(), rider->begin(), rider->end());
    return bytes;
  }
  static Bytes alone(const Bytes& content) {
    Bytes bytes = message();
    bytes.insert(bytes.end(), content.begin(), content.end());
    return bytes;
  }
  std::size_t arrive(const Bytes& bytes, std::uint32_t from = station) {
    return vehicle_->take(bytes.data(), bytes.size(), from, now_, wall_s);
  }
  std::optional<StopChannel> station_;
  std::optional<StopChannel> vehicle_;
  int news_ = 0;
  Time now_ = Time(std::chrono::seconds(100));
};

TEST_F(StopChannelTest, AValueRidesInAPacketThatLosesItOnArrival) {
  open();
  station_->say(value(true), now_);
  const Bytes plain = packet(nullptr);
  const Bytes bytes = packet(station_->ride(vehicle, plain.size(), now_));
  ASSERT_GT(bytes.size(), plain.size());
  EXPECT_EQ(arrive(bytes), plain.size());
  const StopNews news = vehicle_->take_news();
  ASSERT_EQ(news.values.size(), 1U);
  EXPECT_EQ(news.values.front().value, value(true));
  EXPECT_EQ(news.values.front().received, now_);
  ASSERT_EQ(news.packets.size(), 1U);
  EXPECT_EQ(news.packets.front().router, news.values.front().router);
  EXPECT_EQ(news_, 1);
}

TEST_F(StopChannelTest, RidesInNoPacketWithoutRoomNorToStrangers) {
  open();
  EXPECT_EQ(station_->ride(vehicle, 100, now_), nullptr) << "nothing was said";
  station_->say(value(true), now_);
  const std::size_t rider = station_->ride(vehicle, 100, now_)->size();
  EXPECT_NE(station_->ride(vehicle, packet_bytes - rider, now_), nullptr);
  EXPECT_EQ(station_->ride(vehicle, packet_bytes - rider + 1, now_), nullptr);
  EXPECT_EQ(station_->ride(0x0a4d0009, 100, now_), nullptr);
}

TEST_F(StopChannelTest, GoesAloneTenTimesASecondWhereNothingElseGoes) {
  open();
  station_->say(value(false), now_);
  int sent = 0;
  for (const Time end = now_ + std::chrono::seconds(2); now_ < end; now_ += milliseconds(1)) {
    if (now_.time_since_epoch() % milliseconds(100) == Duration::zero()) {
      station_->say(value(false), now_);
    }
    for (const Bytes& one : station_->due(vehicle, now_)) {
      ++sent;
      EXPECT_EQ(arrive(alone(one)), 0U) << "nothing is left for DDS";
    }
  }
  EXPECT_GE(sent, 20);
  EXPECT_LE(sent, 25);
}

TEST_F(StopChannelTest, DoesNotGoAloneSoonAfterItRode) {
  open();
  station_->say(value(false), now_);
  for (int i = 0; i < 5; ++i) {
    (void)station_->due(vehicle, now_);
    now_ += milliseconds(20);
  }
  (void)station_->ride(vehicle, 100, now_);
  EXPECT_TRUE(station_->due(vehicle, now_ + milliseconds(99)).empty());
  EXPECT_EQ(station_->due(vehicle, now_ + milliseconds(100)).size(), 1U);
}

TEST_F(StopChannelTest, AChangedValueGoesFourTimesAtOnceAndWakesTheSender) {
  open();
  int woken = 0;
  station_->on_say([&] { ++woken; });
  station_->say(value(false), now_);
  station_->say(value(false, 2), now_ + milliseconds(100));
  EXPECT_EQ(woken, 1);
  now_ += milliseconds(300);
  station_->say(value(true, 3), now_);
  EXPECT_EQ(woken, 2);
  int sent = 0;
  for (int i = 0; i < 60; ++i, now_ += milliseconds(1)) {
    sent += static_cast<int>(station_->due(vehicle, now_).size());
  }
  EXPECT_EQ(sent, 4);
}

TEST_F(StopChannelTest, AValueThatIsNotSaidAgainIsSentForHalfASecond) {
  open();
  station_->say(value(false), now_);
  EXPECT_NE(station_->ride(vehicle, 100, now_ + milliseconds(499)), nullptr);
  EXPECT_EQ(station_->ride(vehicle, 100, now_ + milliseconds(500)), nullptr);
  EXPECT_TRUE(station_->due(vehicle, now_ + milliseconds(500)).empty());
}

TEST_F(StopChannelTest, NothingIsTakenFromOtherAddresses) {
  open();
  station_->say(value(true), now_);
  const Bytes bytes = packet(station_->ride(vehicle, 100, now_));
  EXPECT_EQ(arrive(bytes, 0x0a4d0009), bytes.size());
  EXPECT_TRUE(vehicle_->take_news().values.empty());
}

TEST_F(StopChannelTest, APacketWithoutAValueIsNotedAllTheSame) {
  open();
  const Bytes bytes = packet(nullptr);
  EXPECT_EQ(arrive(bytes), bytes.size());
  EXPECT_EQ(vehicle_->take_news().packets.size(), 1U);
  EXPECT_EQ(news_, 0);
}

TEST_F(StopChannelTest, AFloodOfOtherValuesDoesNotHideAStop) {
  open();
  station_->say(value(true), now_);
  arrive(packet(station_->ride(vehicle, 100, now_)));
  for (std::uint64_t i = 0; i < 1000; ++i) {
    station_->say(value(false, i), now_);
    arrive(packet(station_->ride(vehicle, 100, now_)));
  }
  const StopNews news = vehicle_->take_news();
  EXPECT_LE(news.values.size(), 64U);
  EXPECT_TRUE(std::any_of(news.values.begin(), news.values.end(),
                          [](const auto& one) { return one.value.stands; }));
}

TEST_F(StopChannelTest, HostileBytesAreReadWithinTheirEnds) {
  open();
  station_->say(value(true), now_);
  const Bytes whole = packet(station_->ride(vehicle, 100, now_));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_LE(arrive(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size))),
              size);
  }
}

class SecuredStopChannelTest : public StopChannelTest {
 protected:
  SecuredStopChannelTest() {
    keystore::create(store(), wall_s);
    for (const char* name : {"uxv1", "gcs", "other"}) {
      keystore::add(store(), {name, {{"rt/goal"}, {"rt/goal"}}}, wall_s);
    }
  }
  [[nodiscard]] std::string store() const { return folder_.path() + "/keystore"; }
  [[nodiscard]] std::string enclave(const std::string& name) const {
    return store() + "/enclaves/" + name;
  }
  /// All that goes alone at an instant.
  void deliver_due() {
    for (const Bytes& one : station_->due(vehicle, now_)) arrive(alone(one));
  }
  TemporaryFolder folder_;
};

TEST_F(SecuredStopChannelTest, NamesTheIdentityOnceItsCertificateHasArrived) {
  open(enclave("gcs"), enclave("uxv1"));
  station_->say(value(true), now_);
  deliver_due();
  now_ += milliseconds(20);
  station_->say(value(true, 2), now_);
  deliver_due();
  const StopNews news = vehicle_->take_news();
  ASSERT_FALSE(news.values.empty());
  EXPECT_EQ(news.values.back().identity, "CN=/gcs");
}

TEST_F(SecuredStopChannelTest, TellsARestartedPeerItsCertificateWithin200Milliseconds) {
  open(enclave("gcs"), enclave("uxv1"));
  station_->say(value(true), now_);
  deliver_due();
  vehicle_.emplace(StopChannel::Options{{station}, enclave("uxv1"), packet_bytes});
  Bytes of_successor = packet(nullptr);
  of_successor[8] ^= 1U;  // the GUID prefix
  (void)station_->take(of_successor.data(), of_successor.size(), vehicle, now_, wall_s);
  for (int i = 0; i < 3; ++i) {
    now_ += milliseconds(100);
    station_->say(value(true, 2 + static_cast<std::uint64_t>(i)), now_);
    deliver_due();
  }
  EXPECT_FALSE(vehicle_->take_news().values.empty());
}

TEST_F(SecuredStopChannelTest, TellsARestartedPeerItsCertificateTenTimesInASecond) {
  open(enclave("gcs"), enclave("uxv1"));
  const auto certificates_in_a_second = [&] {
    constexpr std::uint8_t certificate = 0xc9;
    int sent = 0;
    for (int i = 0; i < 10; ++i) {
      station_->say(value(true), now_);
      for (const Bytes& one : station_->due(vehicle, now_)) sent += one[0] == certificate ? 1 : 0;
      now_ += milliseconds(100);
    }
    return sent;
  };
  EXPECT_EQ(certificates_in_a_second(), 1);
  const Bytes of_successor = packet(nullptr);
  (void)station_->take(of_successor.data(), of_successor.size(), vehicle, now_, wall_s);
  EXPECT_EQ(certificates_in_a_second(), 10);
  EXPECT_EQ(certificates_in_a_second(), 1);
}

TEST_F(SecuredStopChannelTest, TakesNothingWithoutAValidSignature) {
  open("", enclave("uxv1"));
  station_->say(value(true), now_);
  deliver_due();
  EXPECT_TRUE(vehicle_->take_news().values.empty());
}

TEST_F(SecuredStopChannelTest, TakesNothingOfAChangedValue) {
  open(enclave("gcs"), enclave("uxv1"));
  station_->say(value(true), now_);
  deliver_due();
  (void)vehicle_->take_news();
  now_ += milliseconds(20);
  station_->say(value(false, 2), now_);
  Bytes bytes = packet(station_->ride(vehicle, 100, now_));
  const std::size_t at = packet(nullptr).size() + 4 + 3;  // the flags
  ASSERT_EQ(bytes[at] & 1U, 0U);
  bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ 1U);
  arrive(bytes);
  EXPECT_TRUE(vehicle_->take_news().values.empty());
}

TEST_F(SecuredStopChannelTest, ARevokedIdentitySaysNothing) {
  keystore::revoke(store(), "gcs", wall_s);
  open(enclave("gcs"), enclave("uxv1"));
  station_->say(value(true), now_);
  deliver_due();
  now_ += milliseconds(20);
  deliver_due();
  EXPECT_TRUE(vehicle_->take_news().values.empty());
}

}  // namespace
}  // namespace tocsin
