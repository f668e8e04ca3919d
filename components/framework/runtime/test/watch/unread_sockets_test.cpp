// SPDX-License-Identifier: Apache-2.0
#include "watch/unread_sockets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// Lines of Linux 6.1; the second number of the queues is what waits to be read.
const char* const kernel_text =
    "   sl  local_address rem_address   st tx_queue rx_queue tr tm->when retrnsmt   uid  timeout "
    "inode ref pointer drops\n"
    "  311: 0100007F:1CF3 00000000:0000 07 00000000:00000300 00:00000000 00000000     0        0 "
    "4711 2 0000000000000000 0\n"
    "  312: 0100007F:1CF4 00000000:0000 07 00000000:00000000 00:00000000 00000000     0        0 "
    "4712 2 0000000000000000 0\n"
    "  313: 0100007F:1CF5 00000000:0000 07 00000500:00000000 00:00000000 00000000     0        0 "
    "4713 2 0000000000000000 0\n"
    "  314: 0100007F:1CF6 00000000:0000 07 00000000:00000100 00:00000000 00000000     0        0 "
    "9999 2 0000000000000000 0\n";

TEST(UnreadPorts, AreThoseOfOwnSocketsInWhichBytesWait) {
  std::istringstream text(kernel_text);
  EXPECT_THAT(unread_ports(text, {4711, 4712, 4713}), ElementsAre(0x1CF3));
}

TEST(UnreadPorts, LinesOfOtherShapeSayNothing) {
  std::istringstream text("a b c\n\n: : : : : : : : : :\n1: 2 3 4 5 6 7 8 9 4711\n");
  EXPECT_THAT(unread_ports(text, {4711}), IsEmpty());
}

}  // namespace
}  // namespace tocsin
