// SPDX-License-Identifier: Apache-2.0
#include "foundation/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/inotify.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <optional>

namespace tocsin {
namespace {

/// A process that has made a temporary folder with a file in it, and waits for its end.
class FolderOfAnother {
 public:
  FolderOfAnother() {
    int ends[2];
    if (::pipe(ends) != 0) std::abort();
    process_ = ::fork();
    if (process_ == 0) hold_one(ends[1]);
    std::array<char, 200> name{};
    const auto length = ::read(ends[0], name.data(), name.size());
    path_.assign(name.data(), static_cast<std::size_t>(std::max<ssize_t>(length, 0)));
    ::close(ends[0]);
    ::close(ends[1]);
  }
  /// Ends the process by `signal`; whether the folder goes within ten seconds.
  bool goes_after(int signal) {
    const int watch = ::inotify_init1(IN_CLOEXEC);
    ::inotify_add_watch(watch, path_.c_str(), IN_DELETE_SELF);
    ::kill(process_, signal);
    ::waitpid(process_, nullptr, 0);
    pollfd event{watch, POLLIN, 0};
    const bool gone = ::poll(&event, 1, 10'000) == 1;
    ::close(watch);
    return gone;
  }

 private:
  [[noreturn]] static void hold_one(int pipe_end) {
    const TemporaryFolder folder;
    folder.write("inner/file", "text");
    const std::string path = folder.path();
    if (::write(pipe_end, path.data(), path.size()) < 0) std::abort();
    for (;;) ::pause();
  }
  pid_t process_ = -1;
  std::string path_;
};

TEST(TemporaryFolder, IsRemovedWithEverythingInIt) {
  std::optional<TemporaryFolder> sut(std::in_place);
  const std::string path = sut->path();
  sut->write("inner/file", "text");
  EXPECT_EQ(sut->read("inner/file"), "text");
  sut.reset();
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(TemporaryFolder, IsRemovedWhenTheProcessIsEndedByASignal) {
  EXPECT_TRUE(FolderOfAnother().goes_after(SIGINT));
  EXPECT_TRUE(FolderOfAnother().goes_after(SIGTERM));
}

TEST(TemporaryFolder, IsRemovedWhenTheProcessIsKilledOrCrashes) {
  EXPECT_TRUE(FolderOfAnother().goes_after(SIGKILL));
  EXPECT_TRUE(FolderOfAnother().goes_after(SIGSEGV));
}

TEST(TemporaryFolder, IsMadeWhereTheEnvironmentWantsIt) {
  const TemporaryFolder outer;
  ::setenv("TMPDIR", outer.path().c_str(), 1);
  const TemporaryFolder sut;
  ::unsetenv("TMPDIR");
  EXPECT_EQ(std::filesystem::path(sut.path()).parent_path(), outer.path());
}

}  // namespace
}  // namespace tocsin
