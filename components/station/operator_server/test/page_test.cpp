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

TEST_F(PageTest, HeadHasTheLengthAndNoBody) {
  const Served sut(params_);
  HttpAnswer answer = fetch(sut.facts(), "HEAD");
  EXPECT_EQ(answer.status, 200);
  EXPECT_EQ(answer.headers["Content-Length"], "11");
  EXPECT_EQ(answer.body, "");
}

TEST_F(PageTest, NothingOutsideOfTheFolderIsServed) {
  const Served sut(params_);
  for (const char* target : {"/../secret.txt", "/assets/../../secret.txt", "/%2e%2e/secret.txt",
                             "//etc/passwd", "/nothing.js", "/assets"}) {
    ClientFacts facts = sut.facts();
    facts.target = target;
    EXPECT_EQ(fetch(facts).status, 404) << target;
  }
  EXPECT_EQ(fetch(sut.facts(), "POST").status, 405);
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

TEST(OperatorServerReadme, HasTheParameters) {
  std::ostringstream readme;
  readme << std::ifstream(std::string(TOCSIN_SOURCE_DIR) + "/README.md").rdbuf();
  EXPECT_THAT(readme.str(), HasSubstr(default_yaml<OperatorServerComponent::Params>()));
}

}  // namespace
}  // namespace tocsin
