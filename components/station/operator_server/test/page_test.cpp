// SPDX-License-Identifier: Apache-2.0
// The page's files, over HTTP.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "foundation/parameters.hpp"
#include "foundation/temporary_folder.hpp"
#include "served.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;

class PageTest : public ::testing::Test {
 protected:
  PageTest() {
    const std::filesystem::path root = folder_.path();
    std::filesystem::create_directories(root / "page/assets");
    std::ofstream(root / "secret.txt") << "secret";
    std::ofstream(root / "page/index.html") << "<p>page</p>";
    std::ofstream(root / "page/assets/app.js") << "let a;";
    std::ofstream(root / "page/assets/app.js.gz") << "zipped";
    params_.page = root / "page";
  }
  const TemporaryFolder folder_;
  OperatorServerComponent::Params params_;
};

TEST_F(PageTest, ServesTheFilesOfAFolder) {
  const Served sut(params_);
  ClientFacts facts = sut.facts();
  HttpAnswer answer = fetch(facts);
  EXPECT_EQ(answer.status, 200);
  EXPECT_EQ(answer.body, "<p>page</p>");
  EXPECT_EQ(answer.headers["Content-Type"], "text/html; charset=utf-8");
  EXPECT_THAT(answer.headers["Content-Security-Policy"], HasSubstr("default-src 'self'"));
  facts.target = "/assets/app.js?v=1";
  answer = fetch(facts);
  EXPECT_EQ(answer.body, "let a;");
  EXPECT_EQ(answer.headers["Content-Type"], "text/javascript; charset=utf-8");
  facts.headers["Accept-Encoding"] = "br, gzip";
  answer = fetch(facts);
  EXPECT_EQ(answer.body, "zipped");
  EXPECT_EQ(answer.headers["Content-Encoding"], "gzip");
}

TEST_F(PageTest, WithoutAPageItSaysSoAndHowOthersConnect) {
  params_.page = "/no/such/folder";
  const Served sut(params_);
  const HttpAnswer answer = fetch(sut.facts());
  EXPECT_EQ(answer.status, 404);
  EXPECT_THAT(answer.body, HasSubstr("operator_page"));
  EXPECT_THAT(answer.body, HasSubstr("Foxglove"));
}

TEST_F(PageTest, AHeadOfRequestThatIsTooLongIsRefused) {
  const Served sut(params_);
  ClientFacts facts = sut.facts();
  facts.headers["X-Long"] = std::string(20'000, 'x');
  EXPECT_NE(fetch(facts).status, 200);
  facts.headers.clear();
  EXPECT_EQ(fetch(facts).status, 200);
}

class RunFilesTest : public PageTest {
 protected:
  RunFilesTest() {
    params_.bags = folder_.path();
    (void)folder_.write("gcs/bag_0.mcap", "0123456789");
  }
  static HttpAnswer get(const Served& sut, const std::string& target,
                        const std::string& range = "") {
    ClientFacts facts = sut.facts();
    facts.target = target;
    if (!range.empty()) facts.headers["Range"] = range;
    return fetch(facts);
  }
};

TEST_F(RunFilesTest, TheRecordingsAreListedAndServed) {
  const Served sut(params_);
  const HttpAnswer list = get(sut, "/bags");
  EXPECT_EQ(list.status, 200);
  EXPECT_EQ(list.body, R"({"bags":[{"bytes":10,"path":"gcs/bag_0.mcap"}]})");
  HttpAnswer whole = get(sut, "/bags/gcs/bag_0.mcap");
  EXPECT_EQ(whole.status, 200);
  EXPECT_EQ(whole.body, "0123456789");
  EXPECT_EQ(whole.headers["Accept-Ranges"], "bytes");
  EXPECT_EQ(get(sut, "/bags/gcs/none.mcap").status, 404);
  EXPECT_EQ(get(sut, "/bags/secret.txt").status, 404);
}

TEST_F(RunFilesTest, ARecordingIsServedInParts) {
  const Served sut(params_);
  HttpAnswer part = get(sut, "/bags/gcs/bag_0.mcap", "bytes=3-5");
  EXPECT_EQ(part.status, 206);
  EXPECT_EQ(part.body, "345");
  EXPECT_EQ(part.headers["Content-Range"], "bytes 3-5/10");
  EXPECT_EQ(get(sut, "/bags/gcs/bag_0.mcap", "bytes=-2").body, "89");
  HttpAnswer none = get(sut, "/bags/gcs/bag_0.mcap", "bytes=10-");
  EXPECT_EQ(none.status, 416);
  EXPECT_EQ(none.headers["Content-Range"], "bytes */10");
}

TEST_F(RunFilesTest, ALargeRecordingComesWhole) {
  std::string large(3'000'000, 'x');
  for (std::size_t i = 0; i < large.size(); i += 1000) large[i] = static_cast<char>('a' + i % 23);
  (void)folder_.write("gcs/large.mcap", large);
  const Served sut(params_);
  EXPECT_EQ(get(sut, "/bags/gcs/large.mcap").body, large);
  ClientFacts facts = sut.facts();
  facts.target = "/bags/gcs/large.mcap";
  HttpAnswer head = fetch(facts, "HEAD");
  EXPECT_EQ(head.headers["Content-Length"], "3000000");
  EXPECT_EQ(head.body, "");
}

TEST_F(RunFilesTest, WithoutARunThereIsNothingToDecideAgain) {
  const Served sut(params_);
  EXPECT_EQ(get(sut, "/what_if?host=moon").status, 400);
  EXPECT_EQ(get(sut, "/what_if?host=uxv").status, 404);
}

TEST(OperatorServerReadme, HasTheParameters) {
  std::ostringstream readme;
  readme << std::ifstream(std::string(TOCSIN_SOURCE_DIR) + "/README.md").rdbuf();
  EXPECT_THAT(readme.str(), HasSubstr(default_yaml<OperatorServerComponent::Params>()));
}

}  // namespace
}  // namespace tocsin
