// SPDX-License-Identifier: Apache-2.0
#include "sample_log/ledger.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace tocsin::sample_log {
namespace {

class LedgerTest : public ::testing::Test {
 protected:
  /// What is left when the process is killed now: files as they are, and a new life.
  void restart() {
    sut_.reset();
    sut_.emplace(files_, "given");
  }
  [[nodiscard]] bool has(std::uint64_t sequence) const {
    return sut_->done().contains({1, 2, sequence});
  }

  MemoryFiles files_;
  std::optional<Ledger> sut_{std::in_place, files_, "given"};
};

TEST_F(LedgerTest, RemembersWhatWasSavedOverLives) {
  EXPECT_TRUE(sut_->add({1, 2, 10}));
  EXPECT_TRUE(sut_->add({1, 2, 11}));
  EXPECT_FALSE(sut_->add({1, 2, 11}));
  EXPECT_EQ(sut_->save(), mcap::Kept::all);
  EXPECT_TRUE(sut_->add({1, 2, 12}));
  restart();
  EXPECT_TRUE(has(10));
  EXPECT_TRUE(has(11));
  EXPECT_FALSE(has(12)) << "was not saved";
  EXPECT_FALSE(sut_->done().contains({1, 3, 10})) << "another writer";
  EXPECT_FALSE(sut_->done().contains({2, 2, 10})) << "another stream";
}

TEST_F(LedgerTest, ARecordThatWasHalfWrittenIsLeftOut) {
  sut_->add({1, 2, 10});
  EXPECT_EQ(sut_->save(), mcap::Kept::all);
  sut_->add({1, 2, 20});
  EXPECT_EQ(sut_->save(), mcap::Kept::all);
  auto& bytes = files_.bytes_of(files_.names().front());
  bytes.resize(bytes.size() - 1);
  restart();
  EXPECT_TRUE(has(10));
  EXPECT_FALSE(has(20));
  EXPECT_EQ(sut_->damaged(), 0U) << "a cut is no damage";
}

TEST_F(LedgerTest, ADamagedRecordTakesNoOtherWithIt) {
  for (const std::uint64_t sequence : {10, 20, 30}) {
    sut_->add({1, 2, sequence});
    EXPECT_EQ(sut_->save(), mcap::Kept::all);
  }
  auto& bytes = files_.bytes_of(files_.names().front());
  bytes[bytes.size() / 2] ^= 1;
  restart();
  EXPECT_TRUE(has(10));
  EXPECT_FALSE(has(20));
  EXPECT_TRUE(has(30));
  EXPECT_EQ(sut_->damaged(), 1U);
}

TEST_F(LedgerTest, AFullDiskIsTriedAgain) {
  files_.room = files_.size();
  sut_->add({1, 2, 10});
  EXPECT_EQ(sut_->save(), mcap::Kept::nothing);
  files_.room += 1000;
  EXPECT_EQ(sut_->save(), mcap::Kept::all);
  restart();
  EXPECT_TRUE(has(10));
}

TEST_F(LedgerTest, AKilledRewriteLosesNothing) {
  sut_->add({1, 2, 10});
  EXPECT_EQ(sut_->save(), mcap::Kept::all);
  const auto old = files_.bytes_of("given.00000001");
  restart();  // makes given.00000002
  (void)files_.make("given.00000001");
  files_.bytes_of("given.00000001") = old;  // as if it had not been removed yet
  auto& half = files_.bytes_of("given.00000002");
  half.resize(half.size() / 2);
  restart();
  EXPECT_TRUE(has(10));
}

TEST_F(LedgerTest, AFileThatIsNoneOfItsOwnIsLeftAlone) {
  for (const char* const other : {"given", "given.txt", "confirmed.00000001"}) {
    const auto file = files_.make(other);
    const std::vector<std::uint8_t> bytes(80, 0x5a);
    EXPECT_EQ(file->append({{bytes.data(), bytes.size()}}), mcap::Kept::all);
  }
  sut_->add({1, 2, 10});
  EXPECT_EQ(sut_->save(), mcap::Kept::all);
  restart();
  EXPECT_EQ(sut_->damaged(), 0U);
  EXPECT_TRUE(has(10));
  EXPECT_EQ(files_.names().size(), 4U);
}

TEST_F(LedgerTest, AFileWithManyRecordsIsWrittenAnew) {
  for (std::uint64_t i = 0; i < 100'010; ++i) {
    sut_->add({1, 2, i});
    ASSERT_EQ(sut_->save(), mcap::Kept::all);
  }
  EXPECT_LT(files_.size(), 1000U);
  restart();
  EXPECT_TRUE(has(0));
  EXPECT_TRUE(has(100'009));
}

}  // namespace
}  // namespace tocsin::sample_log
