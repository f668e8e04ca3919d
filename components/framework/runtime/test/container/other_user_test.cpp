// SPDX-License-Identifier: Apache-2.0
// Another user of the computer on the host's domain, with all that a program of ours has.
#include <gtest/gtest.h>

#include "container/staged_process.hpp"
#include "fast_dds/bus_fixture.hpp"
#include "fast_dds/other_user.hpp"
#include "fast_dds/udp_sockets.hpp"
#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "runtime/middleware/container_client.hpp"

namespace tocsin {
namespace {

constexpr int domain = 210;
const std::string bin = STAGE "/bin/";
const std::string config = TOCSIN_REPOSITORY "/config/";

/// What somebody reaches of the container `drive`; each with all that stands before it.
enum Reached : int { nothing, its_state, a_load, a_stop };

bool is_obeyed(ContainerClient& client, const std::string& verb, const std::string& name,
               Duration time) {
  ContainerClient::Command command;
  command.container("drive");
  command.verb(verb);
  command.library("link_lamp");
  command.name(name);
  try {
    return client.ask(command, time).done();
  } catch (const EnvironmentError&) {  // no answer
    return false;
  }
}

int reach(Duration time) {
  BusOptions options;
  options.name = "somebody";
  options.role = Role::gcs;
  options.qos_file = config + "qos.yaml";
  options.traffic_file = config + "traffic.yaml";
  options.host_domain = domain;
  const auto bus = make_fast_dds_bus(options);
  ContainerClient client(*bus);
  const auto known =
      client.wait(time, [](const ContainerClient::Known& all) { return !all.empty(); });
  const bool loaded = is_obeyed(client, "load", "planted", time);
  if (is_obeyed(client, "deactivate", "drive", time)) return a_stop;
  if (loaded) return a_load;
  return known.empty() ? nothing : its_state;
}

TEST(OtherUser, NeitherSeesAContainerNorLoadsIntoItNorStopsAComponentWhileTheSameUserDoes) {
  if (!can_become_stranger()) GTEST_SKIP() << "only root can become another user";
  if (!UdpSockets().answers()) GTEST_SKIP() << "this kernel does not tell whose sockets are";
  const TemporaryFolder folder;
  Process container({bin + "tocsin-run", "link_lamp", "--host", "gcs", "--name", "drive",
                     "--domain", std::to_string(domain), "--run-dir", folder.path(), "--qos",
                     config + "qos.yaml", "--traffic", config + "traffic.yaml"});
  EXPECT_EQ(ProcessOf(::geteuid(), [] { return reach(std::chrono::seconds(30)); }).result(),
            a_stop);
  EXPECT_EQ(ProcessOf(stranger, [] { return reach(std::chrono::seconds(3)); }).result(), nothing);
}

TEST(OtherUser, IsWhomAComponentThatRootRunsBecomes) {
  if (!can_become_stranger()) GTEST_SKIP() << "only root can become another user";
  const TemporaryFolder folder;
  ASSERT_EQ(::chown(folder.path().c_str(), stranger, stranger), 0);
  Process container({bin + "tocsin-run", "link_lamp", "--user", std::to_string(stranger), "--host",
                     "gcs", "--name", "drive", "--domain", std::to_string(domain), "--run-dir",
                     folder.path(), "--qos", config + "qos.yaml", "--traffic",
                     config + "traffic.yaml"});
  EXPECT_EQ(ProcessOf(stranger, [] { return reach(std::chrono::seconds(30)); }).result(), a_stop);
}

}  // namespace
}  // namespace tocsin
