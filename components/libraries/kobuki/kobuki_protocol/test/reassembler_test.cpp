// SPDX-License-Identifier: Apache-2.0
#include "kobuki_protocol/reassembler.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "frames.hpp"

namespace tocsin::kobuki {
namespace {

constexpr int frame_count = 300;

std::vector<Bytes> sent_frames() {
  std::vector<Bytes> frames;
  for (int i = 0; i < frame_count; ++i) frames.push_back(typical_frame(i));
  return frames;
}

Bytes joined(const std::vector<Bytes>& parts) {
  Bytes all;
  for (const Bytes& part : parts) append_to(all, part);
  return all;
}

/// Feeds the portions and returns the payloads that came out, as frames.
std::vector<Bytes> received(Reassembler& sut, const std::vector<Bytes>& portions) {
  std::vector<Bytes> frames;
  for (const Bytes& portion : portions) {
    sut.feed(view(portion), [&](ByteView payload) {
      frames.push_back(to_bytes({payload.data - 3, payload.size + 4}));
    });
  }
  return frames;
}

std::vector<Bytes> blocks_of(const Bytes& stream, std::size_t size) {
  std::vector<Bytes> blocks;
  for (std::size_t at = 0; at < stream.size(); at += size) {
    const auto from = stream.begin() + static_cast<std::ptrdiff_t>(at);
    blocks.emplace_back(from,
                        from + static_cast<std::ptrdiff_t>(std::min(size, stream.size() - at)));
  }
  return blocks;
}

/// What an FT232R hands over: a packet when 62 bytes wait or when its latency timer expires.
/// Frames every 20 ms, one byte every 86.8 us (10 bits at 115200 baud).
std::vector<Bytes> ftdi_packets(const std::vector<Bytes>& frames, double latency_ms) {
  std::vector<Bytes> packets(1);
  double timer_ms = latency_ms;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    for (std::size_t k = 0; k < frames[i].size(); ++k) {
      const double at_ms = 20.0 * static_cast<double>(i) + 0.0868 * static_cast<double>(k + 1);
      for (; timer_ms < at_ms; timer_ms += latency_ms) packets.emplace_back();
      if (packets.back().size() == 62) packets.emplace_back();
      packets.back().push_back(frames[i][k]);
    }
  }
  return packets;
}

void expect_all(const std::vector<Bytes>& portions) {
  Reassembler sut;
  EXPECT_EQ(received(sut, portions), sent_frames());
  EXPECT_EQ(sut.counts().frames, static_cast<std::uint64_t>(frame_count));
  EXPECT_EQ(sut.counts().rejected, 0U);
  EXPECT_EQ(sut.counts().discarded, 0U);
  EXPECT_EQ(sut.pending(), 0U);
}

TEST(ReassemblerDelivery, TellsHowManyBytesAFrameUnderWayLacks) {
  Reassembler sut;
  const Bytes frame = sent_frames().front();
  EXPECT_EQ(sut.lacking(), 0U);
  for (std::size_t i = 0; i + 1 < frame.size(); ++i) {
    sut.feed({&frame[i], 1}, [](ByteView) { FAIL(); });
    const bool knows_length = i >= 2;
    EXPECT_EQ(sut.lacking(), (knows_length ? frame.size() : min_payload + 4) - (i + 1)) << i;
  }
  sut.feed({&frame.back(), 1}, [](ByteView) {});
  EXPECT_EQ(sut.lacking(), 0U);
}

TEST(ReassemblerDelivery, UsbLatency1To16Ms) {
  for (const double latency_ms : {1.0, 2.0, 4.0, 8.0, 16.0}) {
    SCOPED_TRACE(latency_ms);
    expect_all(ftdi_packets(sent_frames(), latency_ms));
  }
}

TEST(ReassemblerDelivery, BlocksOfEverySize) {
  const Bytes stream = joined(sent_frames());
  for (std::size_t size = 1; size <= 260; ++size) {  // 62 and 32, and byte by byte, are among them
    SCOPED_TRACE(size);
    expect_all(blocks_of(stream, size));
  }
}

TEST(ReassemblerDelivery, EverySplitPosition) {
  const Bytes stream = joined({typical_frame(0), typical_frame(1), typical_frame(2)});
  const std::vector<Bytes> expected{typical_frame(0), typical_frame(1), typical_frame(2)};
  for (std::size_t cut = 0; cut <= stream.size(); ++cut) {
    const auto middle = stream.begin() + static_cast<std::ptrdiff_t>(cut);
    Reassembler sut;
    EXPECT_EQ(received(sut, {{stream.begin(), middle}, {middle, stream.end()}}), expected) << cut;
  }
}

TEST(Reassembler, LosesOnlyTheFrameWithABadChecksum) {
  std::vector<Bytes> frames = sent_frames();
  for (std::size_t i = 0; i < frames.size(); i += 10) frames[i].back() ^= 0x01U;
  Reassembler sut;
  EXPECT_EQ(received(sut, blocks_of(joined(frames), 62)).size(), 270U);
  EXPECT_EQ(sut.counts().rejected, 30U);
}

TEST(Reassembler, LosesOnlyTheFrameThatMissesAByte) {
  for (std::size_t lost = 0; lost < typical_frame(1).size(); ++lost) {
    Bytes damaged = typical_frame(1);
    damaged.erase(damaged.begin() + static_cast<std::ptrdiff_t>(lost));
    Reassembler sut;
    const auto frames = received(
        sut, {typical_frame(0), damaged, typical_frame(2), typical_frame(3), typical_frame(4)});
    EXPECT_EQ(frames.size(), 4U) << "lost byte " << lost;
  }
}

TEST(Reassembler, FindsGoodFramesInsideARejectedOne) {
  // A false header with the greatest length swallows three whole frames before it is rejected.
  std::vector<Bytes> portions{from_hex("aa55ff")};
  for (int i = 0; i < 5; ++i) portions.push_back(typical_frame(i));
  Reassembler sut;
  EXPECT_EQ(received(sut, portions).size(), 5U);
  EXPECT_EQ(sut.counts().discarded, 3U);
}

TEST(Reassembler, SurvivesHeaderBytesInsideThePayload) {
  Feedback feedback = typical_feedback(1);
  feedback.core->left_encoder = 0x55AA;
  feedback.core->right_encoder = 0x55AA;
  const Bytes tricky = to_bytes(encode_feedback(feedback).bytes());
  // Joining in the middle of such a frame must not cost the next one.
  const Bytes tail(tricky.begin() + 5, tricky.end());
  Reassembler sut;
  EXPECT_EQ(received(sut, {tail, tricky, tricky}), (std::vector<Bytes>{tricky, tricky}));
}

TEST(Reassembler, RejectsLengthsBelowTheSmallestPayloadAndTakesTheGreatest) {
  Reassembler sut;
  EXPECT_TRUE(received(sut, {from_hex("aa5500 00"), from_hex("aa5502 0000 02")}).empty());
  EXPECT_EQ(received(sut, {from_hex("aa5503 04 01 00 06")}).size(), 1U);
  EXPECT_EQ(sut.counts().rejected, 2U);
  Bytes greatest = from_hex("aa55ff");
  greatest.resize(258, 0x11);
  greatest.push_back(xor_of({greatest.data() + 2, 256}));
  EXPECT_EQ(received(sut, {greatest}).size(), 1U);
}

TEST(Reassembler, AccountsForEveryByteOfNoise) {
  std::mt19937 random(6);
  Reassembler sut;
  std::size_t fed = 0;
  std::size_t in_frames = 0;
  for (int i = 0; i < 20000; ++i) {
    Bytes portion = i % 10 == 0 ? typical_frame(i) : Bytes(random() % 30);
    // half of the noise consists of header bytes, the worst case for the search
    if (i % 10 != 0) {
      for (auto& byte : portion)
        byte = random() % 2 ? (random() % 2 ? 0xAA : 0x55) : random() & 0xFF;
    }
    fed += portion.size();
    sut.feed(view(portion), [&](ByteView payload) { in_frames += payload.size + 4; });
    ASSERT_EQ(fed, in_frames + sut.counts().discarded + sut.pending());
    ASSERT_LE(sut.pending(), max_frame);
  }
  EXPECT_GE(sut.counts().frames, 1990U);
}

TEST(Reassembler, HandsOverAFrameOnItsLastByteAlsoTheShortest) {
  for (const Bytes& frame : {from_hex("aa 55 03 04 01 04 02"), typical_frame(1)}) {
    Reassembler sut;
    for (const std::uint8_t noise : from_hex("99 aa 42 55")) (void)received(sut, {{noise}});
    EXPECT_EQ(received(sut, {{frame.begin(), frame.end() - 1}}).size(), 0U);
    EXPECT_EQ(received(sut, {{frame.back()}}), std::vector<Bytes>{frame});
    EXPECT_EQ(sut.pending(), 0U);
    EXPECT_EQ(sut.counts().discarded, 4U);
  }
}

TEST(Reassembler, ForgetsAHalfFrameWhenCleared) {
  Reassembler sut;
  const Bytes frame = typical_frame(1);
  (void)received(sut, {Bytes(frame.begin(), frame.begin() + 20)});
  sut.clear();
  EXPECT_EQ(sut.pending(), 0U);
  EXPECT_EQ(sut.counts().discarded, 20U);
  EXPECT_EQ(received(sut, {frame}).size(), 1U);
}

}  // namespace
}  // namespace tocsin::kobuki
