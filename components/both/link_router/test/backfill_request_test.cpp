// SPDX-License-Identifier: Apache-2.0
// Samples that a BackfillSender sends because somebody asked for them.
#include "backfill_sender_fixture.hpp"

namespace tocsin::router {
namespace {

using BackfillRequestTest = BackfillSenderTest;

TEST_F(BackfillRequestTest, WhatIsRequestedGoesBehindWhatIsStored) {
  sut_.begin_session();
  sut_.request(id(1, 9, 5));
  sut_.request(id(2, 9, 5));
  sut_.request(id(1, 9, 5));  // known
  miss(id(7));
  EXPECT_THAT(sut_.take_wanted(), ElementsAre(id(7), id(1, 9, 5), id(2, 9, 5)));
}

TEST_F(BackfillRequestTest, RequestedOnesThatWereReadDoNotKeepStoredOnesFromBeingRead) {
  sut_.begin_session();
  for (std::uint64_t i = 1; i <= 40; ++i) sut_.request(id(i, 9, 5));
  const auto first = sut_.take_wanted();
  std::vector<LogEntry> read;
  for (const SampleId& one : first) read.push_back({one, 0, {}});
  sut_.on_read(first, read);
  EXPECT_THAT(sut_.take_wanted(), IsEmpty()) << "enough of the requested ones is read";
  miss(id(7));
  EXPECT_EQ(sut_.take_wanted().at(0), id(7));
  sut_.on_read({id(7)}, {{id(7), 0, {}}});
  const auto batch = next();
  ASSERT_TRUE(batch);
  EXPECT_THAT(sequences(*batch), ElementsAre(7)) << "and goes before them";
}

TEST_F(BackfillRequestTest, WhatIsWithdrawnIsNotSent) {
  sut_.begin_session();
  for (std::uint64_t i = 1; i <= 3; ++i) sut_.request(id(i, 9, 5));
  miss(id(7));
  sut_.withdraw(id(2, 9, 5));
  sut_.withdraw(id(7));
  EXPECT_THAT(sut_.take_wanted(), ElementsAre(id(7), id(1, 9, 5), id(3, 9, 5)))
      << "what is stored cannot be withdrawn";
  sut_.on_read({id(7), id(1, 9, 5), id(3, 9, 5)},
               {{id(7), 0, {}}, {id(1, 9, 5), 0, {}}, {id(3, 9, 5), 0, {}}});
  ASSERT_TRUE(next());
  sut_.withdraw(id(3, 9, 5));
  const auto batch = next();
  ASSERT_TRUE(batch);
  EXPECT_THAT(sequences(*batch), ElementsAre(1));
  sut_.withdraw(id(1, 9, 5));
  EXPECT_THAT(sut_.on_progress({1, 2}, now_), ElementsAre(id(7), id(1, 9, 5)))
      << "it was under way";
}

TEST_F(BackfillRequestTest, WhatIsRequestedAgainAfterItsConfirmationIsSentAgain) {
  sut_.begin_session();
  sut_.request(id(1));
  read_all();
  ASSERT_TRUE(next());
  EXPECT_THAT(sut_.on_progress({1, 1}, now_), ElementsAre(id(1)));
  sut_.request(id(1));
  EXPECT_THAT(sut_.take_wanted(), ElementsAre(id(1)));
}

TEST_F(BackfillRequestTest, TellsWhetherWhatTheLogsBoundsTookIsSentAllTheSame) {
  sut_.begin_session();
  sut_.request(id(1));
  sut_.request(id(2));
  const auto wanted = sut_.take_wanted();
  sut_.on_read({id(1)}, {{id(1), 0, {}}});
  EXPECT_FALSE(sut_.on_retired(id(1))) << "it is in memory";
  EXPECT_TRUE(sut_.on_retired(id(2)));
  EXPECT_FALSE(sut_.on_retired(id(3)));
}

}  // namespace
}  // namespace tocsin::router
