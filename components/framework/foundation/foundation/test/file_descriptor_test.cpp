// SPDX-License-Identifier: Apache-2.0
#include "foundation/file_descriptor.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>

namespace tocsin {
namespace {

int open_one() { return ::open("/dev/null", O_RDONLY | O_CLOEXEC); }
bool is_open(int descriptor) { return ::fcntl(descriptor, F_GETFD) >= 0; }

TEST(FileDescriptor, OwnsNothingByItself) {
  const FileDescriptor sut;
  EXPECT_FALSE(sut);
  EXPECT_FALSE(FileDescriptor(-1));
}

TEST(FileDescriptor, ClosesWhatItOwns) {
  int number = 0;
  {
    const FileDescriptor sut(open_one());
    ASSERT_TRUE(sut);
    number = sut.get();
    EXPECT_TRUE(is_open(number));
  }
  EXPECT_FALSE(is_open(number));
}

TEST(FileDescriptor, HasOneOwnerAfterAMove) {
  FileDescriptor first(open_one());
  const int number = first.get();
  FileDescriptor second(std::move(first));
  EXPECT_FALSE(first);  // NOLINT(bugprone-use-after-move): what a move leaves is tested
  EXPECT_EQ(second.get(), number);
  FileDescriptor third(open_one());
  const int closed = third.get();
  third = std::move(second);
  EXPECT_EQ(third.get(), number);
  EXPECT_FALSE(is_open(closed));
  EXPECT_TRUE(is_open(number));
}

TEST(FileDescriptor, StaysOpenWhenItIsGivenToItself) {
  FileDescriptor sut(open_one());
  FileDescriptor& same = sut;
  sut = std::move(same);
  EXPECT_TRUE(sut);
  EXPECT_TRUE(is_open(sut.get()));
}

TEST(FileDescriptor, GivesAwayWhatItReleases) {
  int number = 0;
  {
    FileDescriptor sut(open_one());
    number = sut.release();
    EXPECT_FALSE(sut);
  }
  EXPECT_TRUE(is_open(number));
  FileDescriptor(number).reset();
  EXPECT_FALSE(is_open(number));
}

}  // namespace
}  // namespace tocsin
