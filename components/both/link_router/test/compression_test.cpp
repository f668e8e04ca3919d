// SPDX-License-Identifier: Apache-2.0
// Samples that cross as what is new in them: what the sender bases them on, what the receiver
// keeps.
#include "link_pair.hpp"
#include "link_router/compressed_samples.hpp"
#include "link_router/compressed_source.hpp"

namespace tocsin::router {
namespace {

using Sequences = std::vector<std::uint64_t>;

Sample sample(std::uint64_t sequence, std::size_t bytes = 700) {
  return {{7, sequence, t0}, bytes, std::make_shared<std::uint64_t>(sequence), {}};
}

/// Half of a sample is left of it, a tenth where there is a base.
std::optional<Sample> halve(const Sample& plain, const Sample* base) {
  Sample compressed = plain;
  compressed.bytes = plain.bytes / (base != nullptr ? 10 : 2);
  const std::uint64_t before = base != nullptr ? plain.origin.sequence - base->origin.sequence : 0;
  compressed.coding = {true, static_cast<std::uint8_t>(before)};
  return compressed;
}

/// As random bytes: nothing is gained.
std::optional<Sample> gain_nothing(const Sample& plain, const Sample*) {
  Sample compressed = plain;
  compressed.bytes += 14;
  compressed.coding.is_compressed = true;
  return compressed;
}

TEST(CompressedSource, TheFirstOnesAreCompressedByThemselves) {
  CompressedSource sut;
  EXPECT_EQ(sut.send(sample(1), halve).coding, (SampleCoding{true, 0}));
  const Sample second = sut.send(sample(2), halve);
  EXPECT_EQ(second.coding, (SampleCoding{true, 0})) << "nobody has acknowledged the first";
  EXPECT_EQ(second.bytes, 350U);
}

TEST(CompressedSource, TheNewestThatAllReadersHaveIsTheBase) {
  CompressedSource sut;
  for (std::uint64_t i = 1; i <= 4; ++i) (void)sut.send(sample(i), halve);
  sut.on_delivered(sample(3));
  sut.on_delivered(sample(2));
  const Sample next = sut.send(sample(5), halve);
  EXPECT_EQ(next.coding, (SampleCoding{true, 2}));
  EXPECT_EQ(next.bytes, 70U);
  EXPECT_EQ(next.origin.sequence, 5U);
}

TEST(CompressedSource, OfAWriterOfSeveralKindsOneOfItsSizeIsTheBase) {
  CompressedSource sut;
  const std::size_t sizes[] = {2000, 100, 700, 2100, 110, 720};
  for (std::uint64_t i = 1; i <= 6; ++i) {
    (void)sut.send(sample(i, sizes[i - 1]), halve);
    sut.on_delivered(sample(i, sizes[i - 1]));
  }
  EXPECT_EQ(sut.send(sample(7, 2050), halve).coding.base, 3U) << "the newer of two";
  EXPECT_EQ(sut.send(sample(8, 690), halve).coding.base, 2U);
  EXPECT_EQ(sut.send(sample(9, 400), halve).coding.base, 3U) << "none is: the newest";
}

TEST(CompressedSource, ABaseThatIsNotRenewedIsGivenUp) {
  CompressedSource sut;
  (void)sut.send(sample(1), halve);
  sut.on_delivered(sample(1));
  std::size_t based = 0;
  for (std::uint64_t i = 2; i <= 40; ++i) based += sut.send(sample(i), halve).coding.base > 0;
  EXPECT_EQ(based, kept_bases) << "a receiver may have lost it, and acknowledge nothing";
}

TEST(CompressedSource, ABaseIsNotTooFarBefore) {
  CompressedSource sut;
  (void)sut.send(sample(1), halve);
  sut.on_delivered(sample(1));
  EXPECT_EQ(sut.send(sample(255), halve).coding.base, 254U);
  EXPECT_EQ(sut.send(sample(256), halve).coding.base, 0U);
  EXPECT_EQ(sut.send(sample(1), halve).coding.base, 0U) << "a writer that begins anew";
}

TEST(CompressedSource, ANewReaderHasNoBase) {
  CompressedSource sut;
  (void)sut.send(sample(1), halve);
  sut.on_delivered(sample(1));
  (void)sut.send(sample(2), halve);
  sut.on_new_reader();
  EXPECT_EQ(sut.send(sample(3), halve).coding.base, 0U);
  sut.on_delivered(sample(2));
  EXPECT_EQ(sut.send(sample(4), halve).coding.base, 0U) << "it was sent before";
  sut.on_delivered(sample(3));
  EXPECT_EQ(sut.send(sample(5), halve).coding.base, 2U);
}

TEST(CompressedSource, WhatGainsNothingGoesAsItIsAndIsTriedAgainAfterAWhile) {
  CompressedSource sut;
  EXPECT_TRUE(sut.send(sample(1), gain_nothing).coding.is_compressed) << "it may be a base";
  sut.on_delivered(sample(1));
  int tries = 0;
  const Compress count = [&](const Sample& plain, const Sample* base) {
    ++tries;
    return gain_nothing(plain, base);
  };
  for (std::uint64_t i = 2; i <= 131; ++i) EXPECT_EQ(sut.send(sample(i), count).bytes, 700U);
  EXPECT_EQ(tries, 2);
}

TEST(CompressedSource, ThatSmallOnesGainNothingKeepsNoLargerOneFromIt) {
  CompressedSource sut;
  (void)sut.send(sample(1, 100), gain_nothing);
  sut.on_delivered(sample(1, 100));
  EXPECT_FALSE(sut.send(sample(2, 100), gain_nothing).coding.is_compressed);
  EXPECT_FALSE(sut.send(sample(3, 90), halve).coding.is_compressed);
  EXPECT_TRUE(sut.send(sample(4, 2000), halve).coding.is_compressed);
}

TEST(CompressedSource, OfALargeSampleOnlyAGainCounts) {
  CompressedSource sut;
  EXPECT_FALSE(sut.send(sample(1, largest_base + 1), gain_nothing).coding.is_compressed);
  CompressedSource other;
  EXPECT_TRUE(other.send(sample(1, largest_base + 1), halve).coding.is_compressed);
  other.on_delivered(sample(1, largest_base + 1));
  EXPECT_EQ(other.send(sample(2), halve).coding.base, 0U) << "nobody keeps it";
  EXPECT_FALSE(other.send(sample(3, SampleCoding::largest + 1), halve).coding.is_compressed);
}

TEST(CompressedSamples, OfASourceTheNewestAreKept) {
  CompressedSamples sut;
  for (std::uint64_t i = 100; i >= 1; --i) sut.add(1, sample(i));
  EXPECT_EQ(sut.find(1, 7, 100)->origin.sequence, 100U);
  EXPECT_NE(sut.find(1, 7, 101 - 2 * kept_bases), nullptr);
  EXPECT_EQ(sut.find(1, 7, 100 - 2 * kept_bases), nullptr) << "whatever came last";
  EXPECT_EQ(sut.find(2, 7, 100), nullptr) << "another stream";
  EXPECT_EQ(sut.find(1, 8, 100), nullptr) << "another source";
}

TEST(CompressedSamples, TheMemoryOfAllIsBounded) {
  CompressedSamples sut;
  for (std::uint64_t source = 0; source < 2000; ++source) {
    Sample one = sample(1, largest_base);
    one.origin.source = source;
    sut.add(1, one);
  }
  EXPECT_LE(sut.bytes(), CompressedSamples::most_bytes);
  EXPECT_EQ(sut.find(1, 0, 1), nullptr);
  EXPECT_NE(sut.find(1, 1999, 1), nullptr);
  sut.add(1, sample(5, largest_base + 1));
  EXPECT_EQ(sut.find(1, 7, 5), nullptr) << "no base";
  sut.forget(1);
  EXPECT_EQ(sut.bytes(), 0U);
}

/// A stream of class high whose receiver restores what it has the base for, as LinkEvents does.
class CompressedLink : public ::testing::Test {
 protected:
  CompressedLink() {
    StreamRule rule = rule_of(TrafficClass::high);
    rule.compressed = true;
    link.sender.set_compress(halve);
    link.add(1, rule);
  }
  /// Ten samples a second.
  void run(std::uint64_t samples) {
    for (std::uint64_t i = 0; i < samples; ++i) {
      link.offer(1, ++sequence_, 700);
      link.run(100 * ms);
    }
  }
  [[nodiscard]] std::size_t based() const {
    std::size_t count = 0;
    for (const Transmission& one : link.sent) count += one.sample.coding.base > 0 ? 1 : 0;
    return count;
  }
  LinkPair link;

 private:
  std::uint64_t sequence_ = 0;
};

TEST_F(CompressedLink, AcknowledgedSamplesAreTheBasesOfLaterOnes) {
  run(20);
  EXPECT_EQ(link.delivered[1].size(), 20U);
  EXPECT_GE(based(), 17U);
  EXPECT_EQ(link.sent.back().sample.bytes, 70U);
  EXPECT_EQ(link.sent.back().plain_bytes, 700U);
  EXPECT_LE(link.sent.back().record.cost.bytes, wire_cost(70).bytes);
}

TEST_F(CompressedLink, NothingIsCompressedWhileSomebodyReadsWhoCannotRestoreIt) {
  link.sender.set_largest_piece(0);
  run(5);
  for (const Transmission& one : link.sent) EXPECT_FALSE(one.sample.coding.is_compressed);
}

TEST_F(CompressedLink, ARepairIsWhatWasSentFirst) {
  run(5);
  link.sent.clear();
  link.loses = [](const Transmission& one) { return !one.repair; };
  run(3);
  std::map<std::uint64_t, SampleCoding> first;
  bool is_repaired = false;
  for (const Transmission& one : link.sent) {
    const auto sequence = one.sample.origin.sequence;
    if (!one.repair) first[sequence] = one.sample.coding;
    is_repaired = is_repaired || one.repair;
    EXPECT_EQ(one.sample.coding, first[sequence]);
  }
  EXPECT_TRUE(is_repaired);
  const ClassCounts counts = link.counts(TrafficClass::high);
  EXPECT_EQ(counts.repair_bytes, counts.repairs * wire_cost(70).bytes);
}

TEST_F(CompressedLink, APeerThatComesLateGetsTheNewestOfADurableStreamAsItIs) {
  StreamRule rule = rule_of(TrafficClass::high);
  rule.compressed = true;
  rule.durable = true;
  link.add(2, rule);
  for (std::uint64_t i = 1; i <= 5; ++i) {
    link.offer(2, i, 700);
    link.run(100 * ms);
  }
  EXPECT_GT(link.sent.back().sample.coding.base, 0U);
  link.sent.clear();
  link.sender.on_peer("other", 9, link.now);
  link.sender.set_wanted("other", 2, true, link.now);
  link.run(20 * ms);
  ASSERT_FALSE(link.sent.empty());
  EXPECT_FALSE(link.sent.front().sample.coding.is_compressed);
  EXPECT_EQ(link.sent.front().sample.bytes, 700U);
  link.offer(2, 6, 700);
  link.run(10 * ms);
  EXPECT_EQ(link.sent.back().sample.coding, (SampleCoding{true, 0})) << "the new peer has no base";
}

TEST_F(CompressedLink, PiecesOfAnotherCodingMakeAnotherSample) {
  LinkReceiver& receiver = link.receiver;
  const SamplePiece one{0, 2};
  const SamplePiece two{1, 2};
  const Arrived plain{1, 1, {7, 1, t0}, one, nullptr, {}};
  const Arrived compressed{1, 2, {7, 1, t0}, two, nullptr, {true, 0}};
  EXPECT_FALSE(receiver.on_piece("vehicle", plain, link.now));
  EXPECT_FALSE(receiver.on_piece("vehicle", compressed, link.now));
  const Arrived rest{1, 3, {7, 1, t0}, two, nullptr, {}};
  EXPECT_TRUE(receiver.on_piece("vehicle", rest, link.now));
}

}  // namespace
}  // namespace tocsin::router
