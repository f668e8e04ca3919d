// SPDX-License-Identifier: Apache-2.0
#include "foundation/folder_lock.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <optional>

#include "foundation/error.hpp"
#include "foundation/free_space.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;

class FolderLockTest : public ::testing::Test {
 protected:
  const TemporaryFolder folder_;
};

TEST_F(FolderLockTest, RefusesASecondHolderAndNamesTheFolder) {
  const FolderLock first(folder_.path());
  try {
    const FolderLock second(folder_.path());
    FAIL() << "two have it";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr(folder_.path() + ": another run is using it"));
  }
}

TEST_F(FolderLockTest, GivesItBackAtItsEnd) {
  std::optional<FolderLock> first(folder_.path());
  FolderLock moved(std::move(*first));
  first.reset();
  EXPECT_THROW(FolderLock{folder_.path()}, ConfigError);
  { const FolderLock last(std::move(moved)); }
  EXPECT_NO_THROW(FolderLock{folder_.path()});
}

TEST_F(FolderLockTest, IsGivenBackByTheDeathOfItsProcess) {
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t holder = ::fork();
  if (holder == 0) {
    const FolderLock held(folder_.path());
    (void)!::write(ready[1], "x", 1);
    ::pause();
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  EXPECT_THROW(FolderLock{folder_.path()}, ConfigError);
  ::kill(holder, SIGKILL);
  ::waitpid(holder, nullptr, 0);
  EXPECT_NO_THROW(FolderLock{folder_.path()});
}

TEST_F(FolderLockTest, IsNotKeptByAProgramThatWasStarted) {
  pid_t child = 0;
  {
    const FolderLock held(folder_.path());
    int started[2];
    ASSERT_EQ(::pipe2(started, O_CLOEXEC), 0);  // closed by the exec
    child = ::fork();
    if (child == 0) ::execl("/bin/sleep", "sleep", "100", nullptr);
    ::close(started[1]);
    char byte = 0;
    EXPECT_EQ(::read(started[0], &byte, 1), 0);
  }
  EXPECT_NO_THROW(FolderLock{folder_.path()});
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
}

TEST_F(FolderLockTest, NeedsAFolder) {
  EXPECT_THROW(FolderLock{folder_.path("absent")}, EnvironmentError);
}

TEST(FreeBytes, AreThoseOfTheFoldersDisk) {
  const TemporaryFolder folder;
  EXPECT_GT(free_bytes(folder.path()).value_or(0), 0U);
  EXPECT_FALSE(free_bytes(folder.path("absent")));
  EXPECT_FALSE(free_bytes("/proc"));  // has no blocks to count
  EXPECT_GT(free_share(folder.path()).value_or(0), 0);
  EXPECT_LE(free_share(folder.path()).value_or(2), 1);
  EXPECT_FALSE(free_share("/proc"));
}

}  // namespace
}  // namespace tocsin
