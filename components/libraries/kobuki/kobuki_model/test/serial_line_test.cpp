// SPDX-License-Identifier: Apache-2.0
#include "kobuki_model/serial_line.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "kobuki_model/base_model.hpp"

namespace tocsin::kobuki {
namespace {

const Time t0 = Time{} + seconds(100);
using Bytes = std::vector<std::uint8_t>;

LineParams latency(int ms) {
  LineParams params;
  params.usb_latency_ms = ms;
  return params;
}

/// All packets until `end`, calling exactly when the line asks for it.
std::vector<Bytes> packets(SerialLine& sut, Time end) {
  std::vector<Bytes> result;
  while (sut.next_delivery() <= end) {
    sut.deliver(sut.next_delivery(), [&](ByteView p) { result.emplace_back(p.begin(), p.end()); });
  }
  return result;
}

TEST(SerialLine, TakesTheTimeOf115200Baud) {
  SerialLine sut{latency(16), 1, t0};
  const Bytes frame(81, 7);
  sut.send({frame.data(), frame.size()}, t0);
  EXPECT_NEAR(to_seconds(sut.next_delivery() - t0), 62 * 86.806e-6, 1e-9);  // the packet is full
  EXPECT_EQ(packets(sut, t0 + seconds(0.005)).size(), 0U);
  const auto got = packets(sut, t0 + seconds(1));
  ASSERT_EQ(got.size(), 2U);
  EXPECT_EQ(got[0].size(), 62U);
  EXPECT_EQ(got[1].size(), 19U);
}

TEST(SerialLine, HandsOverAtTheLatencyTimer) {
  SerialLine sut{latency(2), 1, t0};
  const Bytes bytes(100, 7);
  sut.send({bytes.data(), bytes.size()}, t0);
  EXPECT_EQ(sut.next_delivery(), t0 + std::chrono::milliseconds(2));
  const auto got = packets(sut, t0 + seconds(1));
  EXPECT_EQ(got.size(), 5U);  // 8.7 ms of line time
  EXPECT_EQ(got[0].size(), 23U);
}

TEST(SerialLine, IsDoneAtTheLastDeliveryWithNothingLateAndNothingLeft) {
  for (const int timer_ms : {1, 2, 5, 16}) {
    SerialLine each(latency(timer_ms), 1, t0);
    SerialLine whole(latency(timer_ms), 1, t0);
    const Bytes frame(86, 7);
    for (SerialLine* line : {&each, &whole}) line->send({frame.data(), frame.size()}, t0);
    Time last{};
    while (each.next_delivery() != never)
      each.deliver(last = each.next_delivery(), [](ByteView) {});
    std::size_t bytes = 0;
    Time at{};
    while (whole.last_delivery() != never) {
      at = whole.last_delivery();
      whole.deliver(at, [&bytes](ByteView p) { bytes += p.size; });
    }
    EXPECT_EQ(at, last) << timer_ms;
    EXPECT_EQ(bytes, frame.size());
  }
}

/// 300 frames of a base through the line and a reassembler.
std::uint64_t received_frames(const LineParams& params, std::uint64_t seed) {
  BaseModel model(ModelParams{}, open_floor(), {}, seed, t0);
  SerialLine line(params, seed, t0);
  Reassembler reassembler;
  for (int ms = 1; ms <= 6100; ++ms) {
    const Time now = t0 + std::chrono::milliseconds(ms);
    if (ms <= 6000) model.step(now, [&](Time at, ByteView frame) { line.send(frame, at); });
    line.deliver(now, [&](ByteView p) { reassembler.feed(p, [](ByteView) {}); });
  }
  return reassembler.counts().frames;
}

TEST(SerialLine, LosesNoFrameAtAnyLatency) {
  for (int ms = 1; ms <= 16; ++ms) EXPECT_EQ(received_frames(latency(ms), 1), 300U) << ms;
}

TEST(SerialLine, LosesNoFrameAtAnyPacketSize) {
  for (int size = 1; size <= 62; ++size) {
    LineParams params = latency(16);
    params.usb_packet_bytes = size;
    EXPECT_EQ(received_frames(params, 1), 300U) << size;
  }
}

TEST(SerialLine, LosesFlipsAndAddsBytesEachOfWhichCostsAtMostOneFrame) {
  for (const auto probability : {&LineParams::loss_probability, &LineParams::flip_probability,
                                 &LineParams::noise_probability}) {
    LineParams params = latency(1);
    params.*probability = 0.001;  // about 24 of 24300 bytes
    const std::uint64_t frames = received_frames(params, 4);
    EXPECT_LT(frames, 300U);
    EXPECT_GT(frames, 255U);
  }
}

TEST(SerialLine, GivesTheSameBytesInOnePieceAsInPackets) {
  for (const int ms : {1, 16}) {  // with 16 ms packets fill, and move the timer
    SerialLine in_packets{latency(ms), 1, t0};
    SerialLine sut{latency(ms), 1, t0};
    Bytes expected;
    Bytes whole;
    for (Time now = t0; now < t0 + seconds(1); now += std::chrono::milliseconds(20)) {
      const Bytes frame(81, static_cast<std::uint8_t>(to_seconds(now - t0) * 50));
      in_packets.send({frame.data(), frame.size()}, now);
      sut.send({frame.data(), frame.size()}, now);
      const auto add_to = [](Bytes& all) {
        return [&all](ByteView p) { all.insert(all.end(), p.begin(), p.end()); };
      };
      while (sut.last_delivery() < now + std::chrono::milliseconds(20)) {
        const Time due = sut.last_delivery();
        sut.deliver_all(due, add_to(whole));
        in_packets.deliver(due, add_to(expected));
      }
      EXPECT_EQ(whole, expected);
      EXPECT_EQ(sut.next_delivery(), in_packets.next_delivery());
    }
    EXPECT_GT(whole.size(), 3900U);
  }
}

TEST(SerialLine, LosesWhatIsOnTheWayWhenCleared) {
  SerialLine sut{latency(1), 1, t0};
  EXPECT_EQ(sut.next_delivery(), never);
  const Bytes bytes(40, 7);
  sut.send({bytes.data(), bytes.size()}, t0);
  sut.clear();
  EXPECT_EQ(sut.next_delivery(), never);
}

}  // namespace
}  // namespace tocsin::kobuki
