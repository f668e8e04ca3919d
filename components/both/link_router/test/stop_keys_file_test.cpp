// SPDX-License-Identifier: Apache-2.0
#include "stop_keys_file.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

StopToken token(std::uint8_t first) { return {first, 0xab, 0xff}; }

TEST(StopKeysFileTest, ASuccessorReadsWhatWasKept) {
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/keys";
  EXPECT_TRUE(StopKeysFile(path).save({true, false, {{token(1), true}, {token(2), false}}}));
  const auto content = StopKeysFile(path).load();
  EXPECT_TRUE(content.stands);
  EXPECT_FALSE(content.others);
  ASSERT_EQ(content.tokens.size(), 2U);
  EXPECT_EQ(content.tokens[0].token, token(1));
  EXPECT_TRUE(content.tokens[0].flag);
  EXPECT_EQ(content.tokens[1].token, token(2));
  EXPECT_FALSE(content.tokens[1].flag);
}

TEST(StopKeysFileTest, AnotherLaunchKeepsTheKeysAndStandsByNothing) {
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/keys";
  const pid_t child = ::fork();  // its parent is another process than ours
  if (child == 0) ::_exit(StopKeysFile(path).save({true, true, {{token(1), false}}}) ? 0 : 1);
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_EQ(status, 0);
  const auto content = StopKeysFile(path).load();
  EXPECT_FALSE(content.stands);
  EXPECT_FALSE(content.others);
  EXPECT_EQ(content.tokens.size(), 1U);
}

TEST(StopKeysFileTest, OfManyTokensTheLastAreKept) {
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/keys";
  StopKeysFile::Content content;
  for (std::uint8_t i = 0; i < 12; ++i) content.tokens.push_back({token(i), false});
  EXPECT_TRUE(StopKeysFile(path).save(content));
  const auto kept = StopKeysFile(path).load();
  ASSERT_EQ(kept.tokens.size(), StopKeysFile::most_tokens);
  EXPECT_EQ(kept.tokens.back().token, token(11));
}

TEST(StopKeysFileTest, ADamagedOrAbsentFileIsEmpty) {
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/keys";
  EXPECT_TRUE(StopKeysFile(path).load().tokens.empty());
  std::ofstream(path) << "nonsense";
  EXPECT_TRUE(StopKeysFile(path).load().tokens.empty());
  EXPECT_TRUE(StopKeysFile("").save({true, true, {}}));
}

TEST(StopKeysFileTest, AFailureIsToldOnce) {
  StopKeysFile sut("/nowhere/at/all");
  EXPECT_FALSE(sut.save({true, false, {}}));
  EXPECT_TRUE(sut.save({true, true, {}}));
}

}  // namespace
}  // namespace tocsin
