// SPDX-License-Identifier: Apache-2.0
// The program as a user types it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "command_line/run_to_end.hpp"
#include "foundation/temporary_folder.hpp"
#include "keystore/enclave.hpp"

namespace tocsin::keystore_tool {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

class KeystoreProgram : public ::testing::Test {
 protected:
  [[nodiscard]] Ended run(std::vector<std::string> words) const {
    const bool names_file = std::find(words.begin(), words.end(), "--traffic") != words.end();
    const bool makes_identity = (words[0] == "add" || words[0] == "permit") && !names_file;
    words.insert(words.begin(), KEYSTORE_PROGRAM);
    if (makes_identity) {
      words.insert(words.end(),
                   {"--traffic", std::string(TOCSIN_REPOSITORY) + "/config/traffic.yaml"});
    }
    return run_to_end(words, {"", folder_.path()});
  }
  [[nodiscard]] std::string path(const std::string& file) const {
    return folder_.path() + "/" + file;
  }
  const TemporaryFolder folder_;
};

TEST_F(KeystoreProgram, TheCommandsOfTheReadmeMakeIdentitiesInAFolderCalledKeystore) {
  for (const auto& words : std::vector<std::vector<std::string>>{
           {"create"}, {"add", "uxv1"}, {"add", "gcs"}, {"check"}}) {
    const Ended ended = run(words);
    EXPECT_EQ(ended.code, 0) << ended.output;
  }
  const auto gcs = keystore::read_enclave(path("keystore/enclaves/gcs")).permissions;
  ASSERT_TRUE(gcs);
  EXPECT_THAT(gcs->publish, Contains("rt/goal"));
}

TEST_F(KeystoreProgram, MistakesEndWithTwoAndOneLine) {
  const Ended none = run({"list"});
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.output, HasSubstr("is no keystore"));
  (void)run({"create"});
  const Ended again = run({"create"});
  EXPECT_EQ(again.code, 2);
  EXPECT_THAT(again.output, HasSubstr("keystore: is not empty"));
  EXPECT_EQ(run({"revoke", "nobody"}).code, 2);
  EXPECT_EQ(run({"make"}).code, 2);
}

TEST_F(KeystoreProgram, AnIdentityWithOtherPermissionsKeepsItsKey) {
  (void)run({"create"});
  (void)run({"add", "uxv1"});
  std::ofstream(path("traffic.yaml")) << "uxv: {low: {topics: [chatter]}}\ngcs: {}\n";
  EXPECT_EQ(run({"permit", "uxv1", "--traffic", path("traffic.yaml")}).code, 0);
  const auto permissions = keystore::read_enclave(path("keystore/enclaves/uxv1")).permissions;
  ASSERT_TRUE(permissions);
  EXPECT_THAT(permissions->publish, Contains("rt/chatter"));
  EXPECT_EQ(run({"check"}).code, 0);
}

}  // namespace
}  // namespace tocsin::keystore_tool
