// SPDX-License-Identifier: Apache-2.0
#include "foundation/network_interface.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

// What is up without carrier: LateLinkTest of package runtime.
TEST(NetworkInterface, LoopbackRunsAndWhatNoInterfaceHasDoesNot) {
  EXPECT_TRUE(interface_is_running("127.0.0.1"));
  EXPECT_FALSE(interface_is_running("192.0.2.1"));
  for (const char* text : {"localhost", "", "256.0.0.1", "127.0.0"}) {
    EXPECT_FALSE(interface_is_running(text)) << text;
  }
}

}  // namespace
}  // namespace tocsin
