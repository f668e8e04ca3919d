// SPDX-License-Identifier: Apache-2.0
// Another user of the computer on the host's domain, with all that a program of ours has.
#include <gtest/gtest.h>

#include "container/staged_process.hpp"
#include "fast_dds/bus_fixture.hpp"
#include "fast_dds/other_user.hpp"
#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "runtime/middleware/container_states.hpp"
#include "runtime/middleware/ros_services.hpp"
#include "runtime/middleware/service_caller.hpp"
#include "transport/udp_sockets.hpp"

namespace tocsin {
namespace {

constexpr int domain = 210;
const std::string bin = STAGE "/bin/";
const std::string config = TOCSIN_REPOSITORY "/config/";

/// What somebody reaches of the container `drive`; each with all that stands before it.
enum Reached : int { nothing, its_state, a_load, a_stop };

template <class Service>
bool is_done(Bus& bus, const std::string& node, const typename Service::Request& request,
             Duration time) {
  try {
    return call_service<Service>(bus, node, request, time)->success();
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
  ContainerStates client(*bus);
  const auto known =
      client.wait(time, [](const ContainerStates::Known& all) { return !all.empty(); });
  composition_service::LoadNode::Request load;
  load.plugin_name("link_lamp");
  load.node_name("planted");
  const bool loaded =
      is_done<composition_service::LoadNode>(*bus, container_node("drive"), load, time);
  lifecycle_service::ChangeState::Request stop;
  stop.transition().label("deactivate");
  if (is_done<lifecycle_service::ChangeState>(*bus, "drive", stop, time)) return a_stop;
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
