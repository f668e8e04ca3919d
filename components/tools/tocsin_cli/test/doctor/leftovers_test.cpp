// SPDX-License-Identifier: Apache-2.0
#include "leftovers.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <thread>

#include "foundation/temporary_folder.hpp"

namespace tocsin::doctor {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Leftovers, FindsFilesOfFastDdsThatNobodyUses) {
  const TemporaryFolder folder;
  const std::string segment = folder.write("fastrtps_1234", "12345");
  const std::string sharing = folder.write("fast_datasharing_a_b", "678");
  const std::string lock = folder.write("sem.fastrtps_port7410_mutex", "");
  const Leftovers found = find_leftovers(folder.path(""));
  EXPECT_THAT(found.files, ElementsAre(sharing, segment, lock));
  EXPECT_EQ(found.bytes, 8U);
}

TEST(Leftovers, LeavesOtherFilesAlone) {
  const TemporaryFolder folder;
  folder.write("somebody_else", "1");
  EXPECT_THAT(find_leftovers(folder.path("")).files, IsEmpty());
}

TEST(Leftovers, LeavesAFileAloneThatAProcessHasOpen) {
  const TemporaryFolder folder;
  const int open_file = ::open(folder.write("fastrtps_port7410_el", "").c_str(), O_RDONLY);
  EXPECT_THAT(find_leftovers(folder.path("")).files, IsEmpty());
  ::close(open_file);
  EXPECT_EQ(find_leftovers(folder.path("")).files.size(), 1U);
}

TEST(Leftovers, LeavesAFileAloneThatAProcessHasMapped) {
  const TemporaryFolder folder;
  const int file = ::open(folder.write("fastrtps_1234", "12345").c_str(), O_RDONLY);
  void* const memory = ::mmap(nullptr, 5, PROT_READ, MAP_SHARED, file, 0);
  ::close(file);
  ASSERT_NE(memory, MAP_FAILED);
  EXPECT_THAT(find_leftovers(folder.path("")).files, IsEmpty());
  ::munmap(memory, 5);
  EXPECT_EQ(find_leftovers(folder.path("")).files.size(), 1U);
}

/// Makes files of Fast DDS, each of which is open as long as it is there.
class Participants {
 public:
  explicit Participants(const std::string& folder)
      : thread_([this, folder] {
          for (int i = 0; !ended_; ++i) {
            const std::string file = folder + "/fastrtps_" + std::to_string(i);
            const int open_file = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
            ::unlink(file.c_str());
            ::close(open_file);
          }
        }) {}
  ~Participants() {
    ended_ = true;
    thread_.join();
  }
  Participants(const Participants&) = delete;
  Participants& operator=(const Participants&) = delete;

 private:
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

TEST(Leftovers, AFileThatHasGoneIsNotCountedAsRemoved) {
  const TemporaryFolder folder;
  const std::string file = folder.write("fastrtps_1234", "12345");
  const Leftovers found = find_leftovers(folder.path());
  ASSERT_EQ(::unlink(file.c_str()), 0);
  EXPECT_EQ(remove(found), 0U);
}

TEST(Leftovers, ThoseOfOthersAreLeftToRoot) {
  if (::geteuid() != 0) GTEST_SKIP() << "needs root to give a file away";
  const TemporaryFolder folder;
  const std::string file = folder.write("fastrtps_1234", "12345");
  if (::chown(file.c_str(), 12345, 12345) != 0) GTEST_SKIP() << "cannot give a file away here";
  EXPECT_EQ(find_leftovers(folder.path()).files.size(), 1U);
}

TEST(Leftovers, AreRemovedAndCounted) {
  const TemporaryFolder folder;
  folder.write("fastrtps_1234", "12345");
  EXPECT_EQ(remove(find_leftovers(folder.path(""))), 1U);
  EXPECT_THAT(find_leftovers(folder.path("")).files, IsEmpty());
}

}  // namespace
}  // namespace tocsin::doctor
