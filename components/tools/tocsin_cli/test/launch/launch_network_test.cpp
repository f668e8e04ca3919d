// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include "launch_fixture.hpp"

namespace tocsin::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Makes the user own the folder and its files.
void give(const std::filesystem::path& folder, unsigned user) {
  EXPECT_EQ(::chown(folder.c_str(), user, user), 0);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    EXPECT_EQ(::chown(entry.path().c_str(), user, user), 0);
  }
}

class LaunchNetworkTest : public LaunchTest {
 protected:
  LaunchNetworkTest() { folder_.write_program("bin/link_emulator", toy_emulator); }

  void SetUp() override {
    if (::access("/dev/net/tun", R_OK | W_OK) != 0) GTEST_SKIP() << "no /dev/net/tun";
    if (std::system("unshare --net --mount true 2>/dev/null") != 0 &&
        std::system("unshare --user --map-root-user --net --mount true 2>/dev/null") != 0) {
      GTEST_SKIP() << "no right to make namespaces";
    }
  }

  /// A deployment with a radio; each host runs one shell script.
  [[nodiscard]] std::string with_radio(const std::string& uxv, const std::string& gcs) const {
    folder_.write("c.yaml", "{}");
    const std::string command = "programs: [{name: p, command: [sh, -c, \"";
    return "radio: {channel: c.yaml, walls: c.yaml}\nhosts:\n"
           "  uxv: {role: uxv, address: 10.77.0.1, " +
           command + uxv + "\"]}]}\n" + "  gcs: {role: gcs, address: 10.77.0.2, " + command + gcs +
           "\"]}]}\n";
  }
};

const std::string show_network =
    "readlink /proc/self/ns/net; ip -4 -o addr show | tr -s ' ' | cut -d' ' -f2,4; "
    "cat /proc/sys/net/ipv4/ping_group_range";

TEST_F(LaunchNetworkTest, GivesEachHostANetworkOfItsOwn) {
  launch_file(with_radio(show_network, show_network));
  ASSERT_TRUE(eventually([&] {
    return printed("[uxv/p] wlan0 10.77.0.1/24") && printed("[gcs/p] wlan0 10.77.0.2/24");
  })) << output();
  EXPECT_THAT(output(), HasSubstr("[uxv/p] lo 127.0.0.1/8"));
  const std::string uxv = folder_.read("run/log/uxv.p.log");
  const std::string gcs = folder_.read("run/log/gcs.p.log");
  EXPECT_NE(uxv.substr(0, uxv.find('\n')), gcs.substr(0, gcs.find('\n')));
  EXPECT_THAT(uxv, Not(HasSubstr(std::filesystem::read_symlink("/proc/self/ns/net").string())));
}

TEST_F(LaunchNetworkTest, OpensIcmpEchoToProcessesWithoutPrivileges) {
  launch_file(with_radio("sleep 1000", show_network));
  ASSERT_TRUE(eventually([&] { return printed("[gcs/p] wlan0"); })) << output();
  EXPECT_TRUE(eventually([&] { return printed("[gcs/p] 0\t"); })) << output();
}

TEST_F(LaunchNetworkTest, StopsTheRadioLast) {
  launch_file(with_radio("sleep 1000", "sleep 1000"));
  const int radio = wait_for_pid("radio");
  const int last = wait_for_pid("gcs/p");
  send(SIGTERM);
  EXPECT_EQ(exit_code(), 128 + SIGTERM);
  EXPECT_FALSE(lives(radio));
  EXPECT_FALSE(lives(last));
}

TEST_F(LaunchNetworkTest, WorksWithoutPrivilegesInAUserNamespace) {
  const std::string yaml = with_radio(show_network, "id -u; sleep 1000");
  if (::getuid() != 0) {
    launch_file(yaml);
  } else {
    // As nobody; one capability stays, to open a TUN that only root may.
    give(folder_.path(""), 65534);
    launch_file(yaml, {"setpriv", "--reuid=65534", "--regid=65534", "--clear-groups",
                       "--inh-caps=-all,+dac_override", "--ambient-caps=+dac_override",
                       "--bounding-set=-all,+dac_override"});
  }
  EXPECT_TRUE(eventually([&] { return printed("[uxv/p] wlan0 10.77.0.1/24"); })) << output();
  EXPECT_TRUE(eventually([&] { return printed("[gcs/p] 0"); })) << output();
}

TEST_F(LaunchNetworkTest, ReportsARadioThatDoesNotComeUp) {
  folder_.write_program("bin/link_emulator", "echo no carrier; exec sleep 1000");
  launch_file(with_radio("echo started", "true"));
  EXPECT_EQ(exit_code(), 1);
  EXPECT_THAT(output(),
              HasSubstr("radio: wlan0 did not come up within 10 s, stopping: no carrier"));
  EXPECT_THAT(output(), Not(HasSubstr("started")));
}

TEST_F(LaunchNetworkTest, ReturnsTheCodeOfARadioThatRefusesItsFiles) {
  folder_.write_program("bin/link_emulator", "echo c.yaml: bad; exit 2");
  launch_file(with_radio("echo started", "true"));
  EXPECT_EQ(exit_code(), 2);
  EXPECT_THAT(output(), HasSubstr("radio ended with exit code 2, stopping: c.yaml: bad"));
}

TEST_F(LaunchNetworkTest, SaysInOneLineWhatItNeedsWhenThereIsNoTun) {
  launch_file(
      with_radio("echo started", "true"),
      {"unshare", "--mount", "sh", "-c", "mount -t tmpfs none /dev/net && exec \"$@\"", "sh"});
  EXPECT_EQ(exit_code(), 1);
  EXPECT_EQ(output(),
            "tocsin launch: radio: needs /dev/net/tun to carry packets over the emulated link: "
            "No such file or directory\n");
}

}  // namespace
}  // namespace tocsin::cli
