// SPDX-License-Identifier: Apache-2.0
#include <yaml-cpp/yaml.h>

#include "fixture.hpp"

namespace tocsin::deployment {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

class ParameterSetTest : public DeploymentTest {
 protected:
  /// The component `name` of the first host's first container.
  [[nodiscard]] ComponentInstance instance(const std::string& name) const {
    const Deployment deployment = load(with(whole, "parameters: []", "parameters: " + files_));
    for (const ComponentInstance& found : deployment.hosts[0].containers[0].components) {
      if (found.name == name) return found;
    }
    throw std::runtime_error(name);
  }
  [[nodiscard]] std::string value(const std::string& name, const std::string& key) const {
    const YAML::Node found = (*instance(name).parameters)[key];
    return found.IsDefined() ? YAML::Dump(found) : "absent";
  }
  [[nodiscard]] std::string error() const {
    return error_of(with(whole, "parameters: []", "parameters: " + files_));
  }

  std::string files_ = "[../a.yaml, ../b.yaml]";
};

TEST_F(ParameterSetTest, LaterFilesOverrideEarlierOnesKeyByKey) {
  write("a.yaml", "driver: {port: one, rate: 50}");
  write("b.yaml", "driver: {port: two}");
  EXPECT_EQ(value("driver", "port"), "two");
  EXPECT_EQ(value("driver", "rate"), "50");
}

TEST_F(ParameterSetTest, TheInstancesOwnParametersOverrideFiles) {
  write("a.yaml", "pilot: {gain: 1, speed: 3}");
  write("b.yaml", "{}");
  EXPECT_EQ(value("pilot", "gain"), "2");
  EXPECT_EQ(value("pilot", "speed"), "3");
}

TEST_F(ParameterSetTest, SettingsOverrideEverything) {
  files_ = "[]";
  overrides_.set = {"pilot.gain=5", "driver.weights=[1, 2]", "driver.path=a=b.c"};
  EXPECT_EQ(value("pilot", "gain"), "5");
  EXPECT_EQ(value("driver", "weights"), "[1, 2]");
  EXPECT_EQ(value("driver", "path"), "a=b.c");
}

TEST_F(ParameterSetTest, ASettingKnowsVariablesAndLeavesItsPathsAsTheyAre) {
  files_ = "[]";
  overrides_.set = {"driver.path=/maps/${seed}", "pilot.file=./x"};
  EXPECT_EQ(value("driver", "path"), "/maps/7");
  EXPECT_EQ(value("pilot", "file"), "./x");
  overrides_.set = {"driver.path=${sed}"};
  EXPECT_THAT(error(), HasSubstr("unknown variable 'sed'"));
}

TEST_F(ParameterSetTest, ASettingMayNameOneHost) {
  files_ = "[]";
  overrides_.set = {"uxv/driver.rate=5"};
  EXPECT_EQ(value("driver", "rate"), "5");
  overrides_.set = {"gcs/driver.rate=5"};
  EXPECT_THAT(error(), HasSubstr("gcs/driver: no such component"));
}

TEST_F(ParameterSetTest, ASettingTakesAComponentAsItIsPrinted) {
  files_ = "[]";
  for (const std::string name : {"/driver", "/uxv/driver", "uxv/drive/driver", "drive/driver"}) {
    overrides_.set = {name + ".rate=5"};
    EXPECT_EQ(value("driver", "rate"), "5") << name;
  }
}

TEST_F(ParameterSetTest, RejectsComponentsThatTheDeploymentHasNot) {
  write("a.yaml", "\ndrivr: {port: x}");
  write("b.yaml", "{}");
  EXPECT_THAT(error(), HasSubstr("drivr: no such component in "));
  EXPECT_THAT(error(),
              HasSubstr("allowed: [driver, pilot, mission_control]; did you mean 'driver'? ("));
  EXPECT_THAT(error(), EndsWith("a.yaml:2)"));
}

TEST_F(ParameterSetTest, RejectsUnknownComponentsInSettings) {
  files_ = "[]";
  overrides_.set = {"drivr.port=x"};
  EXPECT_THAT(error(), HasSubstr("drivr: no such component"));
  EXPECT_THAT(error(), HasSubstr("--set drivr.port=x"));
}

TEST_F(ParameterSetTest, RejectsSettingsOfTheWrongForm) {
  files_ = "[]";
  for (const char* bad : {"driver", "driver=1", ".port=1", "driver.=1", "a=b.c"}) {
    overrides_.set = {bad};
    EXPECT_THAT(error(), HasSubstr("must be name.key=value")) << bad;
  }
  overrides_.set = {"driver.port=[1"};
  EXPECT_THAT(error(), HasSubstr("not valid YAML"));
}

TEST_F(ParameterSetTest, RejectsFilesOfTheWrongForm) {
  write("b.yaml", "{}");
  write("a.yaml", "driver: 3");
  EXPECT_THAT(error(), HasSubstr("driver: must be a map"));
  write("a.yaml", "[driver]");
  EXPECT_THAT(error(), HasSubstr("parameters: must be a map"));
  write("a.yaml", "driver: {a: 1, a: 2}");
  EXPECT_THAT(error(), HasSubstr("key 'a' is given twice"));
  write("a.yaml", "driver:");
  EXPECT_EQ(error(), "no error");
}

TEST_F(ParameterSetTest, ResolvesPathsFromTheFolderOfTheFileThatNamesThem) {
  files_ = "[../a.yaml]";
  write("a.yaml", "driver: {map: ./maps/b.yaml, list: [../c, plain]}");
  EXPECT_EQ(value("driver", "map"), path("maps/b.yaml"));
  EXPECT_EQ(value("driver", "list"), "[" + folder_.parent_path().string() + "/c, plain]");
  EXPECT_EQ(value("pilot", "map"), path("maps/a.yaml"));
}

TEST_F(ParameterSetTest, ReplacesVariablesInValues) {
  files_ = "[../a.yaml]";
  write("a.yaml", "driver: {port: '${run_dir}/kobuki', seed: '${seed}', maps: ['${share}/a']}");
  EXPECT_EQ(value("driver", "port"), "/tmp/run/kobuki");
  EXPECT_EQ(value("driver", "seed"), "7");
  EXPECT_EQ(value("driver", "maps"), "[/opt/share/a]");
  write("a.yaml", "driver: {port: '${nothing}'}");
  EXPECT_THAT(error(), HasSubstr("unknown variable 'nothing'"));
}

TEST_F(ParameterSetTest, KnowsWhereEachValueCameFrom) {
  files_ = "[../a.yaml]";
  write("a.yaml", "pilot:\n  speed: 3");
  overrides_.set = {"pilot.limit=1"};
  const Deployment deployment = load(with(whole, "parameters: []", "parameters: " + files_));
  std::map<std::string, std::string> places;
  for (const auto& entry : *deployment.hosts[0].containers[0].components[1].parameters) {
    places[entry.first.Scalar()] = deployment.sources.place(entry.first);
    EXPECT_EQ(deployment.sources.place(entry.second), places[entry.first.Scalar()]);
  }
  EXPECT_EQ(places.at("speed"), path("a.yaml") + ":2");
  EXPECT_THAT(places.at("gain"), EndsWith("bringup/m.yaml:22"));
  EXPECT_EQ(places.at("limit"), "--set pilot.limit=1");
}

TEST_F(ParameterSetTest, ANetworkMonitorProbesTheFirstPeerOfItsHostUnlessATargetIsSet) {
  const auto target_in = [this](const std::string& yaml) {
    return (*load(yaml).hosts[0].containers[0].components[0].parameters)["target"]
        .as<std::string>();
  };
  const std::string probing = with(whole, "          - driver\n", "          - network_monitor\n");
  EXPECT_EQ(target_in(probing), "10.77.0.2");
  const std::string alone = with(probing, "    peers: [10.77.0.2]\n", "");
  EXPECT_THAT(error_of(alone), HasSubstr("hosts.uxv: network_monitor has no target, and the host "
                                         "has no peer to probe ("));
  overrides_.set = {"network_monitor.target=10.77.0.9"};
  EXPECT_EQ(target_in(probing), "10.77.0.9");
  EXPECT_EQ(target_in(alone), "10.77.0.9");
}

}  // namespace
}  // namespace tocsin::deployment
