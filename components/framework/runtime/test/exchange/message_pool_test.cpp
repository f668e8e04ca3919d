// SPDX-License-Identifier: Apache-2.0
#include "exchange/message_pool.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "ros_idl/std_msgs.hpp"

namespace tocsin {
namespace {

const TypeInfo& type = type_info<std_msgs::msg::String>();

TEST(MessagePool, GivesAMessageAgainOnlyWhenNobodyHoldsIt) {
  MessagePool sut(type);
  std::shared_ptr<void> first = sut.take();
  const void* const where = first.get();
  EXPECT_NE(sut.take().get(), where);
  first.reset();
  EXPECT_EQ(sut.take().get(), where);
}

TEST(MessagePool, NeverGivesOneMessageTwiceHoweverManyAreHeld) {
  MessagePool sut(type);
  std::vector<std::shared_ptr<void>> held;
  std::set<const void*> different;
  for (int i = 0; i < 100; ++i) different.insert(held.emplace_back(sut.take()).get());
  EXPECT_EQ(different.size(), 100U);
}

}  // namespace
}  // namespace tocsin
