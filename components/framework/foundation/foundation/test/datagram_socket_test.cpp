// SPDX-License-Identifier: Apache-2.0
#include "foundation/datagram_socket.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <filesystem>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;

class DatagramSocketTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name = "socket") const {
    return folder_.path(name);
  }
  static std::string error_of(const std::string& path) {
    try {
      const DatagramSocket sut(path);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  }
  TemporaryFolder folder_;
};

TEST_F(DatagramSocketTest, HandsOverMessagesInTheirOrderAndNamesTheSender) {
  DatagramSocket sut(path());
  EXPECT_FALSE(sut.receive());
  DatagramSocket client(path("client"));
  EXPECT_FALSE(client.send(path(), "one"));
  EXPECT_FALSE(client.send(path(), ""));
  pollfd waiting{sut.descriptor(), POLLIN, 0};
  EXPECT_EQ(::poll(&waiting, 1, 0), 1);
  const auto first = sut.receive();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->text, "one");
  EXPECT_EQ(first->sender, path("client"));
  EXPECT_EQ(sut.receive()->text, "");
  EXPECT_FALSE(sut.receive());
}

TEST_F(DatagramSocketTest, OneThatOnlySendsCannotBeAnswered) {
  DatagramSocket sut(path());
  EXPECT_FALSE(DatagramSocket().send(path(), "one"));
  EXPECT_EQ(sut.receive()->sender, "");
}

TEST_F(DatagramSocketTest, CutsWhatIsTooLong) {
  DatagramSocket sut(path());
  EXPECT_FALSE(DatagramSocket().send(path(), std::string(3000, 'x')));
  EXPECT_EQ(sut.receive()->text.size(), 2048U);
}

TEST_F(DatagramSocketTest, TellsThatNobodyListens) {
  EXPECT_EQ(DatagramSocket().send(path(), "one"), std::errc::no_such_file_or_directory);
  EXPECT_EQ(DatagramSocket().send(path(std::string(200, 'x')), "one"),
            std::errc::filename_too_long);
}

TEST_F(DatagramSocketTest, GoesWithItsPath) {
  { const DatagramSocket sut(path()); }
  EXPECT_FALSE(std::filesystem::exists(path()));
}

TEST_F(DatagramSocketTest, ReplacesWhatADeadProcessLeft) {
  {
    const DatagramSocket dead(path("dead"));
    std::filesystem::rename(path("dead"), path());  // so that it does not go with its owner
  }
  ASSERT_TRUE(std::filesystem::exists(path()));
  EXPECT_EQ(error_of(path()), "no error");
}

TEST_F(DatagramSocketTest, LeavesALivingOneAndAFileAlone) {
  const DatagramSocket living(path());
  EXPECT_THAT(error_of(path()), HasSubstr("socket: another process listens there"));
  (void)folder_.write("file", "text");
  EXPECT_THAT(error_of(path("file")), HasSubstr("file: exists and is not a socket"));
  EXPECT_EQ(folder_.read("file"), "text");
}

TEST_F(DatagramSocketTest, SaysWhyItCannotBeMade) {
  EXPECT_THAT(error_of(path(std::string(200, 'x'))), HasSubstr("is longer than 107 characters"));
  EXPECT_THAT(error_of("/nowhere/socket"), HasSubstr("/nowhere/socket: cannot create the socket"));
}

}  // namespace
}  // namespace tocsin
