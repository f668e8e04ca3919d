// SPDX-License-Identifier: Apache-2.0
#include "verbs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "keystore/enclave.hpp"

namespace tocsin::keystore_tool {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr std::int64_t now_s = 1'795'000'000;

class VerbsTest : public ::testing::Test {
 protected:
  /// As from the command line, `tocsin keystore` before the words.
  Answer run(std::vector<std::string> words) {
    Options options;
    CLI::App app;
    declare(app, options);
    words.insert(words.begin(), {"--keystore", folder()});
    std::reverse(words.begin(), words.end());
    app.parse(words);
    options.traffic_file = std::string(TOCSIN_REPOSITORY) + "/config/traffic.yaml";
    return run_verb(app.get_subcommands().front()->get_name(), options, now_s);
  }
  [[nodiscard]] std::string folder() const { return temporary_.path() + "/keystore"; }
  TemporaryFolder temporary_;
};

/// The number that follows these words; -1 when they are not there.
int number_behind(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  return at == std::string::npos ? -1 : std::atoi(text.c_str() + at + words.size());
}

TEST_F(VerbsTest, FourCommandsMakeASecuredLink) {
  EXPECT_THAT(run({"create"}).text, HasSubstr("keep it here"));
  const std::string vehicle = run({"add", "uxv1"}).text;
  const std::string station = run({"add", "gcs"}).text;
  EXPECT_THAT(vehicle, HasSubstr("made identity uxv1 (uxv: publishes "));
  EXPECT_THAT(station, HasSubstr("made identity gcs (gcs: publishes "));
  EXPECT_GT(number_behind(vehicle, "publishes "), 10);
  EXPECT_EQ(number_behind(vehicle, "publishes "), number_behind(station, "hears "));
  EXPECT_EQ(number_behind(vehicle, "hears "), number_behind(station, "publishes "));
  const Answer checked = run({"check"});
  EXPECT_EQ(checked.code, 0);
  EXPECT_EQ(checked.text, "2 identities looked at, all sound\n");
}

TEST_F(VerbsTest, ListSaysHowLongTheyAreValid) {
  (void)run({"create"});
  EXPECT_THAT(run({"list"}).text, HasSubstr("no identities"));
  (void)run({"add", "uxv1", "--days", "30"});
  EXPECT_EQ(run({"list"}).text, "uxv1             30 days\n");
}

TEST_F(VerbsTest, ARevokedIdentityIsListedAndFoundByTheCheck) {
  (void)run({"create"});
  (void)run({"add", "uxv1"});
  EXPECT_THAT(run({"revoke", "uxv1"}).text, HasSubstr("public/crl.pem to every host"));
  EXPECT_THAT(run({"list"}).text, AllOf(StartsWith("uxv1"), HasSubstr("is revoked")));
  const Answer checked = run({"check", "uxv1"});
  EXPECT_EQ(checked.code, 1);
  EXPECT_THAT(checked.text, HasSubstr("cert.pem: is revoked"));
}

TEST_F(VerbsTest, ARoleOverrulesTheName) {
  (void)run({"create"});
  (void)run({"add", "tower", "--role", "gcs"});
  const auto permissions = keystore::read_enclave(folder() + "/enclaves/tower").permissions;
  ASSERT_TRUE(permissions);
  EXPECT_THAT(permissions->publish, ::testing::Contains("rt/goal"));
  EXPECT_THAT(run({"permit", "tower"}).text, HasSubstr("(uxv)")) << "by its name now";
}

TEST(RoleByName, KnowsAStationByItsName) {
  for (const char* name : {"gcs", "gcs2", "station", "station_b"}) {
    EXPECT_EQ(role_by_name(name), Role::gcs) << name;
  }
  for (const char* name : {"uxv", "uxv1", "rover", "agcs"}) {
    EXPECT_EQ(role_by_name(name), Role::uxv) << name;
  }
}

TEST_F(VerbsTest, MistakesHaveOneClearError) {
  EXPECT_THROW((void)run({"add", "uxv1", "--role", "boat"}), CLI::ValidationError);
  EXPECT_THROW((void)run({"add"}), CLI::RequiredError);
  EXPECT_THROW((void)run({}), CLI::RequiredError);
  EXPECT_THROW((void)run({"add", "uxv1"}), ConfigError) << "no keystore yet";
  (void)run({"create"});
  EXPECT_THROW((void)run({"create"}), ConfigError);
  EXPECT_THROW((void)run({"check", "uxv9"}), ConfigError);
}

}  // namespace
}  // namespace tocsin::keystore_tool
