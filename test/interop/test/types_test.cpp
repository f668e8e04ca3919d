// SPDX-License-Identifier: Apache-2.0
// Every type of the workspace there and back: our runtime writes it, Cyclone DDS decodes it by the
// code that its own generator made from the same IDL, encodes it again, and we compare the bytes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <list>
#include <mutex>

#include "cyclone.hpp"
#include "idl_support/encode.hpp"
#include "runtime/middleware/host_graph.hpp"
#include "types.hpp"
#include "within.hpp"

namespace tocsin::interop {
namespace {

using ::testing::IsEmpty;
using Bytes = std::vector<std::uint8_t>;

constexpr int domain = 26;
constexpr std::size_t encapsulation_bytes = 4;

/// Cyclone DDS fills up to four bytes, and says in the header's last two bits by how many.
Bytes without_padding(Bytes bytes) {
  constexpr std::size_t options_at = 3;
  if (bytes.size() < encapsulation_bytes) return bytes;
  bytes.resize(bytes.size() - (bytes[options_at] & 3U));
  bytes[options_at] = 0;
  return bytes;
}

BusOptions options() {
  BusOptions options;
  options.name = "types";
  options.host_domain = domain;
  return options;
}

/// The way of one type.
class Echo {
 public:
  /// What comes back is taken as bytes, by another participant: each has one type of a name.
  Echo(Bus& bus, HostGraph& raw, const CycloneParticipant& cyclone, const MessageType& type)
      : type_(type) {
    const auto qos = CycloneParticipant::qos();
    dds_qset_reliability(qos.get(), DDS_RELIABILITY_RELIABLE, DDS_MSECS(100));
    dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, 100);
    reader_ = cyclone.reader(cyclone.topic(*type.cyclone, "rt/" + there_, type.ours->name), qos);
    writer_ = cyclone.writer(cyclone.topic(*type.cyclone, "rt/" + back_, type.ours->name), qos);
    publication_ = bus.advertise({{there_.c_str(), "event", Scope::host}, type.ours});
    reading_ = raw.read({"rt/" + back_, type.ours->name, true}, [this](RawSample&& sample) {
      const std::lock_guard<std::mutex> lock(mutex_);
      returned_.push_back(*sample.bytes);
    });
  }
  [[nodiscard]] const char* name() const { return type_.ours->name; }
  /// Both ends of the way there know each other: a volatile reader that learns late of a writer
  /// gets nothing of before.
  [[nodiscard]] bool is_connected() const {
    dds_subscription_matched_status_t there{};
    dds_publication_matched_status_t back{};
    (void)dds_get_subscription_matched_status(reader_, &there);
    (void)dds_get_publication_matched_status(writer_, &back);
    return publication_->has_readers() && there.current_count == 1 && back.current_count == 1;
  }
  void send(Random& random) {
    const std::shared_ptr<const void> message = type_.make(random);
    sent_.push_back(encode(*type_.ours, message.get()));
    (void)publication_->write(message);
  }
  /// Lets Cyclone DDS write what it has read.
  void return_all() const {
    take_all<char>(reader_, [this](const char& sample) { (void)dds_write(writer_, &sample); });
  }
  [[nodiscard]] std::size_t sent() const { return sent_.size(); }
  [[nodiscard]] std::size_t returned() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return returned_.size();
  }
  [[nodiscard]] bool bytes_are_equal() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::equal(sent_.begin(), sent_.end(), returned_.begin(), returned_.end(),
                      [](const Bytes& one, const Bytes& other) {
                        return without_padding(one) == without_padding(other);
                      });
  }

 private:
  static inline int count = 0;
  const MessageType type_;
  const std::string number_ = std::to_string(++count);
  const std::string there_ = "there_" + number_;
  const std::string back_ = "back_" + number_;
  dds_entity_t reader_ = 0;
  dds_entity_t writer_ = 0;
  std::mutex mutex_;
  std::vector<Bytes> sent_;
  std::vector<Bytes> returned_;
  std::unique_ptr<Publication> publication_;
  std::unique_ptr<RawReading> reading_;
};

TEST(Types, EveryOneHasTheBytesOfCycloneDdsThereAndBack) {
  const auto bus = make_fast_dds_bus(options());
  const auto raw = make_host_graph(options());
  const CycloneParticipant cyclone(domain);
  std::list<Echo> echoes;
  for (const MessageType& type : all_types()) {
    echoes.emplace_back(*bus, *raw, cyclone, type);
  }
  ASSERT_GT(echoes.size(), 50U);
  ASSERT_TRUE(eventually([&] {
    return std::all_of(echoes.begin(), echoes.end(), [](auto& one) { return one.is_connected(); });
  }));
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    for (Echo& one : echoes) one.send(random);
  }
  (void)eventually([&] {
    bool all = true;
    for (Echo& one : echoes) {
      one.return_all();
      all = all && one.returned() == one.sent();
    }
    return all;
  });
  std::vector<std::string> different;
  for (Echo& one : echoes) {
    if (!one.bytes_are_equal()) different.emplace_back(one.name());
  }
  EXPECT_THAT(different, IsEmpty());
  RecordProperty("types", static_cast<int>(echoes.size()));
}

}  // namespace
}  // namespace tocsin::interop
