// SPDX-License-Identifier: Apache-2.0
// Processes of both hosts whose routers have identities, over the emulated radio.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ctime>
#include <filesystem>

#include "crossing.hpp"
#include "foundation/temporary_folder.hpp"
#include "keystore/keystore.hpp"
#include "packet_tap.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;
using ::testing::AllOf;
using ::testing::HasSubstr;
using Way = Crossings::Way;

class SecuredMission : public ::testing::Test {
 protected:
  SecuredMission() {
    keystore::create(store(), std::time(nullptr));
    for (const char* const name : {"uxv", "gcs"}) {
      keystore::add(store(), {name, {{"rt/*"}, {"rt/*"}}}, std::time(nullptr));
    }
  }
  [[nodiscard]] std::string store() const { return folder_.path() + "/keystore"; }
  const TemporaryFolder folder_;
};

TEST_F(SecuredMission, SamplesCrossBothWaysAndSoonAgainAfterAKilledRouter) {
  const Stack stack({standing_mission(folder_.path(), "restart: {backoff_s: 2}\n"), "--seed", "1",
                     "--security", store()});
  ASSERT_TRUE(routers_run(stack)) << stack.output();
  const PacketTap tap(stack.running("uxv/link"));
  const Crossings crossings(stack.running("uxv/link"), stack.running("gcs/link"), standing_domain);
  constexpr std::size_t enough = 1200;  // 6 s: a launcher takes what was up for 5 s as sound
  const auto cross = [&] {
    return crossings.all(Way::up).size() > enough && crossings.all(Way::down).size() > enough;
  };
  ASSERT_TRUE(Stack::eventually(seconds(30), cross)) << stack.output();
  const auto recovery = kill_and_time(stack, "uxv/link", crossings);
  ASSERT_TRUE(recovery) << "the router does not carry again\n" << stack.output();
  // Who may speak joins within 2 s.
  EXPECT_LT(recovery->up_s, 2.0);
  EXPECT_LT(recovery->down_s, 2.0);
  ASSERT_TRUE(tap.ok());
  for (const TappedPacket& packet : tap.packets()) EXPECT_LE(packet.bytes.size(), 1428U);
}

TEST_F(SecuredMission, AnIdentityThatPeersWouldRefuseIsRefusedBeforeAnythingStarts) {
  std::filesystem::remove(store() + "/enclaves/gcs/key.pem");
  const Ended ended =
      run_to_end(Stack::program("tocsin"), "launch mission.yaml --security " + store() +
                                               " --run-dir " + folder_.path() + "/run");
  EXPECT_EQ(ended.code, 2) << ended.output;
  EXPECT_THAT(ended.output, AllOf(HasSubstr("host gcs: "), HasSubstr("key.pem: cannot be read")));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() + "/run/gcs"));
}

}  // namespace
}  // namespace tocsin
