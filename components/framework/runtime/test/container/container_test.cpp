// SPDX-License-Identifier: Apache-2.0
// The programs tocsin-run, tocsin-container and tocsin-component as processes on real DDS, from a
// folder laid out like an installation, with the component of README.md.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>
#include <string>

#include "container/staged_process.hpp"
#include "deployment/deployment.hpp"
#include "deployment/resolved_copy.hpp"
#include "deployment/running_host.hpp"
#include "fast_dds/bus_fixture.hpp"
#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "runtime/middleware/container_states.hpp"
#include "runtime/middleware/host_bus.hpp"
#include "runtime/middleware/ros_services.hpp"
#include "runtime/middleware/service_caller.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

const std::string bin = STAGE "/bin/";
const std::string config = TOCSIN_REPOSITORY "/config/";

struct Outcome {
  int code;
  std::string text;  ///< both outputs
};

Outcome run(const std::string& command) {
  FILE* const pipe = popen((bin + command + " 2>&1").c_str(), "r");
  std::string text;
  std::array<char, 256> part{};
  while (fgets(part.data(), part.size(), pipe) != nullptr) text += part.data();
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text};
}

/// One container `drive` with lamps, as tocsin launch would write it.
deployment::Deployment deployment_with(int domain, const std::string& run_dir, int lamps = 1) {
  deployment::Deployment deployment;
  deployment.file = run_dir + "/deployment.yaml";
  deployment.run_dir = run_dir;
  deployment.share = STAGE "/share/tocsin";
  deployment.qos = config + "qos.yaml";
  deployment.traffic = config + "traffic.yaml";
  deployment::Host& host = deployment.hosts.emplace_back();
  host.name = "gcs";
  host.role = Role::gcs;
  host.address = "127.0.0.1";
  host.local_domain = domain;
  deployment.link_domain = domain + 2;
  deployment::Container& container = host.containers.emplace_back();
  container.name = "drive";
  for (int i = 1; i <= lamps; ++i) {
    deployment::ComponentInstance& lamp = container.components.emplace_back();
    lamp.component = lamp.name = "link_lamp";
    if (i < lamps) lamp.name += std::to_string(i);
    lamp.parameters = std::make_shared<const YAML::Node>(YAML::NodeType::Map);
  }
  return deployment;
}

/// Whether a container of the run is found among the processes.
bool is_running(const std::string& run_dir) {
  const auto found = deployment::running_hosts().hosts;
  return std::any_of(found.begin(), found.end(),
                     [&](const auto& one) { return one.deployment.run_dir == run_dir; });
}

class ContainerTest : public ::testing::Test {
 protected:
  static int domain() {
    static int next = 0;
    return next += 3;  // the host's and, two further, the link's
  }
  [[nodiscard]] std::vector<std::string> lamp_command() const {
    return {bin + "tocsin-run",
            "link_lamp",
            "--host",
            "gcs",
            "--domain",
            std::to_string(domain_),
            "--run-dir",
            folder_.path(),
            "--qos",
            config + "qos.yaml",
            "--traffic",
            config + "traffic.yaml"};
  }
  [[nodiscard]] std::unique_ptr<Bus> make_bus() const {
    BusOptions options;
    options.name = "container_test";
    options.role = Role::gcs;
    options.qos_file = config + "qos.yaml";
    options.traffic_file = config + "traffic.yaml";
    options.host_domain = domain_;
    return make_fast_dds_bus(options);
  }
  /// The state of the component in the process, once it is `wanted`; else the last one.
  static std::string wait_for(ContainerStates& client, pid_t process, const std::string& name,
                              const std::string& wanted) {
    std::string state = "unknown";
    (void)client.wait(patience, [&](const ContainerStates::Known& known) {
      for (const auto& [key, one] : known) {
        if (key.second != process) continue;
        for (const auto& component : one.components()) {
          if (component.name() == name) state = component.state();
        }
      }
      return state == wanted;
    });
    return state;
  }
  static bool is_deactivated(Bus& bus, const std::string& node) {
    using Service = lifecycle_service::ChangeState;
    Service::Request request;
    request.transition().label("deactivate");
    return call_service<Service>(bus, node, request, patience)->success();
  }
  const int domain_ = domain();
  const TemporaryFolder folder_;
};

TEST_F(ContainerTest, RunsOneComponentUntilItIsToldToEnd) {
  Process sut(lamp_command());
  const auto bus = make_bus();
  ContainerStates client(*bus);
  EXPECT_EQ(wait_for(client, sut.pid(), "link_lamp", "active"), "active");
  EXPECT_EQ(sut.end(SIGTERM), 0);
}

/// The lines of a program's output that are no warning: root is warned, where these tests run as
/// root.
int errors_in(const std::string& text) {
  std::istringstream lines(text);
  int errors = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.find(" WARN: ") == std::string::npos) ++errors;
  }
  return errors;
}

TEST_F(ContainerTest, AnUnknownComponentOrParameterIsOneLineAndExitCode2) {
  for (const char* wrong : {"no_such_lamp", "link_lamp --set poor_below=101",
                            "link_lamp --set no_such_key=1", "link_lamp --set nothing"}) {
    const Outcome outcome =
        run(std::string("tocsin-run ") + wrong + " --qos " + config + "qos.yaml --traffic " +
            config + "traffic.yaml --domain " + std::to_string(domain_));
    EXPECT_EQ(outcome.code, 2) << wrong;
    EXPECT_EQ(errors_in(outcome.text), 1) << outcome.text;
  }
}

TEST_F(ContainerTest, AContainerOfAResolvedFileRunsAndDoesWhatItIsAsked) {
  const auto deployment = deployment_with(domain_, folder_.path());
  write_resolved(deployment, deployment.file);
  Process sut({bin + "tocsin-container", deployment.file, "gcs", "drive"});
  const auto bus = make_bus();
  ContainerStates client(*bus);
  ASSERT_EQ(wait_for(client, sut.pid(), "link_lamp", "active"), "active");
  const std::string at = " --timeout 8 --run-dir " + folder_.path();
  EXPECT_THAT(run("tocsin-component list" + at).text, HasSubstr("/link_lamp  link_lamp  active"));
  const Outcome loaded = run("tocsin-component load drive link_lamp --name second" + at);
  EXPECT_EQ(loaded.text,
            "Loaded component 2 into '/drive_container' container node as '/second'\n");
  EXPECT_EQ(wait_for(client, sut.pid(), "second", "active"), "active");
  const Outcome twice = run("tocsin-component load drive link_lamp --name second" + at);
  EXPECT_EQ(twice.code, 2);
  EXPECT_THAT(twice.text, HasSubstr("second: two nodes of one name; the name is taken"));
  EXPECT_TRUE(is_deactivated(*bus, "second"));
  EXPECT_EQ(run("tocsin-component unload drive second" + at).text,
            "Unloaded component 2 from '/drive_container' container node\n");
  EXPECT_EQ(sut.end(SIGINT), 0);
}

TEST_F(ContainerTest, NamesThatListPrintsAreAccepted) {
  const auto deployment = deployment_with(domain_, folder_.path());
  write_resolved(deployment, deployment.file);
  Process sut({bin + "tocsin-container", deployment.file, "gcs", "drive"});
  const std::string at = " --timeout 8 --run-dir " + folder_.path();
  const std::string listed = run("tocsin-component list --host /gcs" + at).text;
  EXPECT_THAT(listed, HasSubstr("/gcs/drive  process"));
  EXPECT_THAT(listed, HasSubstr("  1  /link_lamp  link_lamp  active"));
  EXPECT_EQ(run("tocsin-component load /gcs/drive link_lamp --name /second" + at).text,
            "Loaded component 2 into '/drive_container' container node as '/second'\n");
  EXPECT_EQ(run("tocsin-component unload gcs/drive /second" + at).text,
            "Unloaded component 2 from '/drive_container' container node\n");
  const std::string soon = " --timeout 1.5 --run-dir " + folder_.path();
  const Outcome container = run("tocsin-component load /uxv/drive link_lamp" + soon);
  EXPECT_EQ(container.code, 1);
  EXPECT_THAT(container.text, HasSubstr("/uxv/drive: no such container; allowed: [gcs/drive]"));
  const Outcome component = run("tocsin-component unload drive /link_lmap" + soon);
  EXPECT_EQ(component.code, 1);
  EXPECT_THAT(component.text,
              HasSubstr("no such component; allowed: [link_lamp]; did you mean 'link_lamp'?"));
  EXPECT_EQ(sut.end(SIGINT), 0);
}

// The time is printed; the limit is for a machine that is busy with other things.
TEST_F(ContainerTest, FifteenComponentsAreActiveAndHeardSoonAfterExec) {
  const auto deployment = deployment_with(domain_, folder_.path(), 15);
  write_resolved(deployment, deployment.file);
  const auto bus = make_bus();
  ContainerStates client(*bus);
  const auto begin = std::chrono::steady_clock::now();
  Process sut({bin + "tocsin-container", deployment.file, "gcs", "drive"});
  EXPECT_EQ(wait_for(client, sut.pid(), "link_lamp", "active"), "active");
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
  std::printf("15 components: first sample %.0f ms after exec\n", taken.count());
  EXPECT_LT(taken.count(), 2000);
}

TEST_F(ContainerTest, AHostOrContainerThatTheFileDoesNotHaveIsExitCode2) {
  const auto deployment = deployment_with(domain_, folder_.path());
  write_resolved(deployment, deployment.file);
  const Outcome host = run("tocsin-container " + deployment.file + " moon drive");
  EXPECT_EQ(host.code, 2);
  EXPECT_THAT(host.text, HasSubstr("has no host 'moon'"));
  const Outcome container = run("tocsin-container " + deployment.file + " gcs brake");
  EXPECT_EQ(container.code, 2);
  EXPECT_THAT(container.text, HasSubstr("gcs has no container brake"));
  EXPECT_EQ(run("tocsin-container").code, 2);
}

TEST_F(ContainerTest, KilledInTheMiddleOfEverythingItsSuccessorAnswersAtOnce) {
  const auto bus = make_bus();
  Samples lamps;
  const auto lamp = bus->subscribe(
      {{"link_lamp/red", "state", Scope::host}, &type_info<std_msgs::msg::Bool>()}, lamps);
  const auto quality = bus->advertise(
      {topic::TransmissionState::info, &type_info<topic::TransmissionState::Message>()});
  const auto poor = std::make_shared<const topic::TransmissionState::Message>();
  for (int life = 0; life < 3; ++life) {
    Process sut(lamp_command());
    const std::size_t before = lamps.all().size();
    EXPECT_TRUE(eventually([&] {
      (void)quality->write(poor);  // a flood, so that the kill meets the process at work
      return lamps.all().size() > before + 50;
    })) << life;
    (void)sut.end(SIGKILL);
  }
}

TEST_F(ContainerTest, TheBusOfARunIsThatOfItsHost) {
  const auto deployment = deployment_with(domain_, folder_.path());
  write_resolved(deployment, deployment.file);
  Process sut({bin + "tocsin-container", deployment.file, "gcs", "drive"});
  HostChoice choice;
  choice.run_dir = folder_.path();
  ASSERT_TRUE(eventually([&] { return is_running(deployment.run_dir); }));
  const auto bus = open_host_bus(choice, "test");
  ContainerStates client(*bus);
  EXPECT_EQ(wait_for(client, sut.pid(), "link_lamp", "active"), "active");
  choice.host = "moon";
  EXPECT_THROW((void)open_host_bus(choice, ""), ConfigError);
  choice.run_dir = "/nowhere";
  EXPECT_THROW((void)open_host_bus(choice, ""), EnvironmentError);
}

TEST_F(ContainerTest, StartsAndIsFoundThoughItsRunFolderIsGone) {
  const auto deployment = deployment_with(domain_, folder_.path("run"));
  const deployment::ResolvedCopy copy(deployment);
  Process sut({bin + "tocsin-container", deployment.file, "gcs", "drive", copy.path()});
  ASSERT_TRUE(eventually([&] { return is_running(deployment.run_dir); }));
  HostChoice choice;
  choice.run_dir = folder_.path("run");
  const auto bus = open_host_bus(choice, "test");
  ContainerStates client(*bus);
  EXPECT_EQ(wait_for(client, sut.pid(), "link_lamp", "active"), "active");
}

TEST(DefaultDomain, IsThatOfTheEnvironmentWithinItsRange) {
  unsetenv("ROS_DOMAIN_ID");
  EXPECT_EQ(default_domain(), 0);
  setenv("ROS_DOMAIN_ID", "231", 1);
  EXPECT_EQ(default_domain(), 231);
  for (const char* wrong : {"232", "-1", "x", "1x"}) {
    setenv("ROS_DOMAIN_ID", wrong, 1);
    EXPECT_THROW((void)default_domain(), ConfigError) << wrong;
  }
  unsetenv("ROS_DOMAIN_ID");
}

}  // namespace
}  // namespace tocsin
