// SPDX-License-Identifier: Apache-2.0
#include "page_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/temporary_folder.hpp"

namespace tocsin::foxglove {
namespace {

using ::testing::HasSubstr;

class PageFilesTest : public ::testing::Test {
 protected:
  PageFilesTest() {
    (void)folder_.write("index.html", "index");
    (void)folder_.write("app.js", "app");
    (void)folder_.write("app.js.gz", "zipped");
    (void)folder_.write("assets/a.svg", "picture");
  }
  const TemporaryFolder folder_;
};

TEST_F(PageFilesTest, ServesAFileWithItsType) {
  const PageFile file = page_file(folder_.path(), "assets/a.svg", true);
  EXPECT_EQ(file.status, 200U);
  EXPECT_STREQ(file.type, "image/svg+xml");
  EXPECT_EQ(file.bytes, "picture");
  EXPECT_FALSE(file.zipped);
}

TEST_F(PageFilesTest, ServesTheZippedOneToWhoTakesIt) {
  EXPECT_EQ(page_file(folder_.path(), "app.js", false).bytes, "app");
  const PageFile file = page_file(folder_.path(), "app.js", true);
  EXPECT_EQ(file.bytes, "zipped");
  EXPECT_TRUE(file.zipped);
  EXPECT_STREQ(file.type, "text/javascript; charset=utf-8");
}

TEST_F(PageFilesTest, AFolderIsNoFile) {
  EXPECT_EQ(page_file(folder_.path(), "assets", true).status, 404U);
  EXPECT_EQ(page_file(folder_.path(), "none.js", true).status, 404U);
}

TEST_F(PageFilesTest, WithoutAPageTheIndexSaysHowOthersConnect) {
  for (const char* folder : {"", "/no/such/folder"}) {
    const PageFile file = page_file(folder, "index.html", true);
    EXPECT_EQ(file.status, 404U);
    EXPECT_THAT(file.bytes, HasSubstr("Foxglove"));
    EXPECT_EQ(page_file(folder, "app.js", true).bytes, "there is no such file\n");
  }
}

}  // namespace
}  // namespace tocsin::foxglove
