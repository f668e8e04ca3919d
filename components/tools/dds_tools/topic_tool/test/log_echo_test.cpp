// SPDX-License-Identifier: Apache-2.0
#include "log_echo.hpp"

#include <gmock/gmock.h>

#include <string>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "log_folder.hpp"

namespace tocsin::topic_tool {
namespace {

class LogEchoTest : public ::testing::Test {
 protected:
  /// What one that ends after a message prints.
  [[nodiscard]] std::string once(const LogWish& wish) const {
    ::testing::internal::CaptureStdout();
    LogEcho(folder_.path("log"), "/chatter", wish).run({}, true);
    return ::testing::internal::GetCapturedStdout();
  }
  TemporaryFolder folder_;
  TextLog log_{folder_.path("log"), "/chatter"};
};

TEST_F(LogEchoTest, PrintsAsTopicEchoDoes) {
  log_.write({"one", "two", "three"});
  LogWish wish;
  wish.from_start = true;
  EXPECT_EQ(once(wish), "data: one\n---\n");
  LogWish last;
  last.last = 2;
  EXPECT_EQ(once(last), "data: two\n---\n");
  LogWish since;
  since.since_s = 3600;
  EXPECT_EQ(once(since), "data: one\n---\n");
}

TEST_F(LogEchoTest, AConsumerGoesOnWhereTheLastOfItsNameWas) {
  log_.write({"one", "two", "three"});
  LogWish wish;
  wish.from_start = true;
  wish.consumer = "plot";
  EXPECT_EQ(once(wish), "data: one\n---\n");
  EXPECT_EQ(once(wish), "data: two\n---\n");
  wish.from_start = false;
  EXPECT_EQ(once(wish), "data: three\n---\n");
  wish.consumer = "other";
  wish.last = 1;
  EXPECT_EQ(once(wish), "data: three\n---\n");
}

TEST_F(LogEchoTest, AConsumerThatAnotherProcessIsIsRefused) {
  log_.write({"one"});
  LogWish wish;
  wish.from_start = true;
  wish.consumer = "plot";
  const LogEcho first(folder_.path("log"), "/chatter", wish);
  EXPECT_THROW(LogEcho(folder_.path("log"), "/chatter", wish), ConfigError);
  wish.consumer = "a/b";
  EXPECT_THROW(LogEcho(folder_.path("log"), "/chatter", wish), ConfigError);
}

TEST_F(LogEchoTest, BytesThatAreNoMessageAreSaid) {
  ::testing::internal::CaptureStderr();
  EXPECT_FALSE(print(type_info<TextLog::Message>(), {0, 1}, {}));
  EXPECT_EQ(::testing::internal::GetCapturedStderr(),
            "a sample of 2 bytes is no std_msgs/msg/String\n");
}

}  // namespace
}  // namespace tocsin::topic_tool
