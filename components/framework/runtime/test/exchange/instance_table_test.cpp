// SPDX-License-Identifier: Apache-2.0
#include "runtime/detail/instance_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(InstanceTable, AnInstanceEndsWithItsLastWriter) {
  InstanceTable sut;
  sut.on_sample(1, 7);
  sut.on_sample(2, 7);
  EXPECT_FALSE(sut.on_unregistered(1, 7));
  EXPECT_TRUE(sut.on_unregistered(2, 7));
  EXPECT_FALSE(sut.on_unregistered(2, 7)) << "it has ended already";
}

TEST(InstanceTable, WhoNeverWroteItDoesNotEndIt) {
  InstanceTable sut;
  sut.on_sample(1, 7);
  EXPECT_FALSE(sut.on_unregistered(2, 7));
  EXPECT_FALSE(sut.on_unregistered(1, 8));
}

TEST(InstanceTable, ADisposedInstanceEndsOnceWhoeverWroteIt) {
  InstanceTable sut;
  sut.on_sample(1, 7);
  sut.on_sample(2, 7);
  EXPECT_TRUE(sut.on_disposed(7));
  EXPECT_FALSE(sut.on_disposed(7));
  EXPECT_THAT(sut.on_writer_gone(1), IsEmpty());
  sut.on_sample(1, 7);
  EXPECT_TRUE(sut.on_disposed(7)) << "it lives again";
}

TEST(InstanceTable, AWriterThatIsGoneLeavesTheInstancesThatNobodyElseWrites) {
  InstanceTable sut;
  sut.on_sample(1, 7);
  sut.on_sample(1, 8);
  sut.on_sample(2, 8);
  EXPECT_THAT(sut.on_writer_gone(1), ElementsAre(7));
  EXPECT_THAT(sut.on_writer_gone(1), IsEmpty());
  EXPECT_THAT(sut.on_writer_gone(2), ElementsAre(8));
}

}  // namespace
}  // namespace tocsin
