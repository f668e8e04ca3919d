// SPDX-License-Identifier: Apache-2.0
// What reaches whom between our runtime and Cyclone DDS: late readers, large samples, both ways.
#include <gtest/gtest.h>

#include <mutex>
#include <ros_idl/sensor_msgs.hpp>
#include <set>

#include "cyclone.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"
#include "sensor_msgs.h"
#include "within.hpp"

namespace tocsin::interop {
namespace {

using Image = sensor_msgs::msg::CompressedImage;

constexpr int domain = 28;

/// Sizes of the pictures that came.
class Sizes : public Receiver {
 public:
  void receive(const Sample& sample) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    sizes_.push_back(static_cast<const Image*>(sample.message.get())->data().size());
  }
  [[nodiscard]] std::vector<std::size_t> all() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return sizes_;
  }

 private:
  std::mutex mutex_;
  std::vector<std::size_t> sizes_;
};

class SamplesTest : public ::testing::Test {
 protected:
  static std::unique_ptr<Bus> make_bus() {
    BusOptions options;
    options.name = "samples";
    options.host_domain = domain;
    return make_fast_dds_bus(options);
  }
  static Endpoint pictures(const char* qos) {
    return {{"pictures", qos, Scope::host}, &type_info<Image>()};
  }
  static std::shared_ptr<const Image> picture(std::size_t bytes) {
    auto image = std::make_shared<Image>();
    image->data().assign(bytes, 7);
    return image;
  }
  /// Reliable; `state`: transient local, the last one only.
  [[nodiscard]] static CycloneParticipant::Qos qos(bool state) {
    auto qos = CycloneParticipant::qos();
    dds_qset_reliability(qos.get(), DDS_RELIABILITY_RELIABLE, DDS_SECS(10));
    dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, state ? 1 : 100);
    if (state) dds_qset_durability(qos.get(), DDS_DURABILITY_TRANSIENT_LOCAL);
    return qos;
  }
  [[nodiscard]] dds_entity_t topic() const {
    return cyclone_.topic(sensor_msgs_msg_CompressedImage_desc, "rt/pictures",
                          type_info<Image>().name);
  }
  static void write(dds_entity_t writer, std::size_t bytes) {
    std::vector<std::uint8_t> data(bytes, 7);
    sensor_msgs_msg_CompressedImage image{};
    image.header.frame_id = const_cast<char*>("");
    image.format = const_cast<char*>("jpeg");
    image.data = {static_cast<std::uint32_t>(bytes), static_cast<std::uint32_t>(bytes), data.data(),
                  false};
    EXPECT_EQ(dds_write(writer, &image), DDS_RETCODE_OK);
  }
  /// Sizes of what waits there.
  static std::vector<std::size_t> taken(dds_entity_t reader) {
    std::vector<std::size_t> sizes;
    void* sample = nullptr;
    dds_sample_info_t info{};
    while (dds_take(reader, &sample, &info, 1, 1) == 1) {
      if (info.valid_data) {
        sizes.push_back(static_cast<const sensor_msgs_msg_CompressedImage*>(sample)->data._length);
      }
      (void)dds_return_loan(reader, &sample, 1);
      sample = nullptr;
    }
    return sizes;
  }
  const CycloneParticipant cyclone_{domain};
};

using Sizes_t = std::vector<std::size_t>;

TEST_F(SamplesTest, ALateReaderOfCycloneDdsGetsTheLastStateOfOurs) {
  const auto bus = make_bus();
  const auto writer = bus->advertise(pictures("state"));
  (void)writer->write(picture(10));
  (void)writer->write(picture(20));
  const dds_entity_t reader = cyclone_.reader(topic(), qos(true));
  Sizes_t got;
  ASSERT_TRUE(eventually([&] { return !(got = taken(reader)).empty(); }));
  EXPECT_EQ(got, Sizes_t{20});
}

TEST_F(SamplesTest, ALateReaderOfOursGetsTheLastStateOfCycloneDds) {
  const dds_entity_t writer = cyclone_.writer(topic(), qos(true));
  write(writer, 10);
  write(writer, 20);
  const auto bus = make_bus();
  Sizes got;
  const auto reader = bus->subscribe(pictures("state"), got);
  ASSERT_TRUE(eventually([&] { return !got.all().empty(); }));
  EXPECT_EQ(got.all(), Sizes_t{20});
}

TEST_F(SamplesTest, EachPictureOfAMegabyteFromOursReachesCycloneDds) {
  const auto bus = make_bus();
  const auto writer = bus->advertise(pictures("event"));
  const dds_entity_t reader = cyclone_.reader(topic(), qos(false));
  // With the first heartbeat of a writer a volatile reader of Cyclone DDS takes all that the writer
  // had begun before for not meant for it, a picture on its way, too.
  ASSERT_TRUE(eventually([&] {
    (void)writer->write(picture(1'000'000));
    return !taken(reader).empty();
  }));
  Sizes_t got;
  for (std::size_t i = 1; i <= 10; ++i) {
    (void)writer->write(picture(1'000'000 + i));
    ASSERT_TRUE(eventually([&] {
      for (const std::size_t one : taken(reader)) {
        if (one > 1'000'000) got.push_back(one);
      }
      return got.size() == i;
    })) << i;
    EXPECT_EQ(got.back(), 1'000'000 + i);
  }
}

TEST_F(SamplesTest, EachPictureOfAMegabyteFromCycloneDdsReachesOurs) {
  const auto bus = make_bus();
  Sizes got;
  const auto reader = bus->subscribe(pictures("event"), got);
  const dds_entity_t writer = cyclone_.writer(topic(), qos(false));
  ASSERT_TRUE(eventually([&] {
    dds_publication_matched_status_t status{};
    (void)dds_get_publication_matched_status(writer, &status);
    return status.current_count == 1;
  }));
  for (std::size_t i = 1; i <= 10; ++i) {
    write(writer, 1'000'000 + i);
    ASSERT_TRUE(eventually([&] { return got.all().size() == i; })) << i;
    EXPECT_EQ(got.all().back(), 1'000'000 + i);
  }
}

}  // namespace
}  // namespace tocsin::interop
