// SPDX-License-Identifier: Apache-2.0
#include <yaml-cpp/yaml.h>

#include <sstream>

#include "deployment/resolved_copy.hpp"
#include "fixture.hpp"
#include "foundation/parameters.hpp"

namespace tocsin::deployment {
namespace {

using ::testing::HasSubstr;

class ResolvedTest : public DeploymentTest {
 protected:
  [[nodiscard]] Deployment through_file(const std::string& yaml) const {
    write_resolved(load(yaml), path("resolved.yaml"));
    return load_resolved(path("resolved.yaml"));
  }
  [[nodiscard]] std::string resolved_text() const {
    std::ostringstream text;
    text << std::ifstream(path("resolved.yaml")).rdbuf();
    return text.str();
  }
};

TEST_F(ResolvedTest, KeepsEveryPart) {
  const Deployment sut = through_file(with(whole, "domain: 40", "domain: 40\nuser: bob"));
  EXPECT_EQ(sut.file, path("resolved.yaml"));
  EXPECT_EQ(sut.user, "bob");
  EXPECT_EQ(sut.run_dir, "/tmp/run");
  EXPECT_EQ(sut.share, "/opt/share");
  EXPECT_EQ(sut.seed, 7);
  EXPECT_EQ(sut.qos, path("qos.yaml"));
  EXPECT_EQ(sut.traffic, path("traffic.yaml"));
  EXPECT_EQ(sut.ros_namespace, "robot_1");
  EXPECT_THAT(sut.stop_when_exits, ::testing::ElementsAre("gcs/mission"));
  EXPECT_EQ(sut.restart.backoff_s, 0.5);
  EXPECT_EQ(sut.restart.limit, 3);
  ASSERT_TRUE(sut.radio);
  EXPECT_EQ(sut.radio->channel, path("channel.yaml"));
}

TEST_F(ResolvedTest, KeepsParametersOfEveryKind) {
  const Deployment sut = through_file(
      with(whole, "gain: 2", "gain: 0.1, on: true, empty: '', list: [1, two], text: 'a: b # c'"));
  const YAML::Node parameters = *sut.hosts[0].containers[0].components[1].parameters;
  EXPECT_EQ(parameters["gain"].as<double>(), 0.1);
  EXPECT_TRUE(parameters["on"].as<bool>());
  EXPECT_EQ(parameters["empty"].as<std::string>(), "");
  EXPECT_EQ(parameters["list"][1].as<std::string>(), "two");
  EXPECT_EQ(parameters["text"].as<std::string>(), "a: b # c");
  EXPECT_EQ(parameters["map"].as<std::string>(), path("maps/a.yaml"));
}

struct Gain {
  double gain = 1;
  std::string map;
  template <class Visitor>
  void visit(Visitor& v) {
    v("gain", gain, {0, 1}, "[1] gain");
    v("map", map, "map");
  }
};

TEST_F(ResolvedTest, PointsToTheLineOfABadParameter) {
  const Deployment sut = through_file(whole);
  const ComponentInstance& pilot = sut.hosts[0].containers[0].components[1];
  try {
    (void)load_parameters<Gain>(*pilot.parameters, pilot.name, sut.sources);
    FAIL() << "no error";
  } catch (const ConfigError& error) {
    const std::string text = error.what();
    EXPECT_THAT(text, HasSubstr("pilot.gain: 2 is outside [0, 1] (" + sut.file + ":"));
    std::istringstream lines(resolved_text());
    std::string line;
    for (int n = std::stoi(text.substr(text.rfind(':') + 1)); n > 0; --n) std::getline(lines, line);
    EXPECT_THAT(line, HasSubstr("gain: 2"));
  }
}

TEST_F(ResolvedTest, RejectsUnknownKeys) {
  const std::string file = write("resolved.yaml", "hosts: {}\nspeed: 1\n");
  try {
    (void)load_resolved(file);
    FAIL() << "no error";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("deployment.speed: unknown key"));
  }
}

TEST_F(ResolvedTest, ReportsAFileThatCannotBeWritten) {
  EXPECT_THAT([&] { write_resolved(load(whole), path("no/such/folder.yaml")); },
              ::testing::Throws<EnvironmentError>(::testing::Property(
                  &EnvironmentError::what, HasSubstr("cannot be written: No such file"))));
}

TEST_F(ResolvedTest, ACopyInMemoryIsReadInPlaceOfTheFileThatErrorsName) {
  const ResolvedCopy copy(load(whole));
  const Deployment sut = load_resolved("/gone/deployment.yaml", copy.path());
  EXPECT_EQ(sut.file, "/gone/deployment.yaml");
  EXPECT_EQ(sut.run_dir, "/tmp/run");
  EXPECT_EQ(sut.hosts.size(), 2U);
  EXPECT_EQ(load_resolved("/gone/deployment.yaml", copy.path()).seed, 7);  // as often as wanted
}

}  // namespace
}  // namespace tocsin::deployment
