// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "deployment/deployment.hpp"
#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::deployment {

/// A folder of its own with the files that a deployment names.
class DeploymentTest : public ::testing::Test {
 protected:
  DeploymentTest() {
    std::filesystem::create_directories(folder_ / "bringup");
    for (const char* name : {"qos.yaml", "traffic.yaml", "channel.yaml", "walls.yaml"}) {
      write(name, "{}");
    }
    overrides_.run_dir = "/tmp/run";
    overrides_.share = "/opt/share";
    overrides_.seed = 7;
  }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }

  [[nodiscard]] Deployment load(const std::string& yaml) const {
    return load_deployment(write("bringup/m.yaml", yaml), overrides_);
  }
  [[nodiscard]] std::string error_of(const std::string& yaml) const {
    try {
      (void)load(yaml);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  }

  const TemporaryFolder temporary_;
  const std::filesystem::path folder_ = temporary_.path();
  Overrides overrides_;
};

/// A whole deployment; tests change parts of it.
inline const std::string whole = R"(qos: ../qos.yaml
traffic: ../traffic.yaml
domain: 40
namespace: robot_1
parameters: []
stop_when_exits: gcs/mission
restart: {backoff_s: 0.5, max_backoff_s: 4, limit: 3}
radio:
  channel: ../channel.yaml
  walls: ../walls.yaml
hosts:
  uxv:
    role: uxv
    address: 10.77.0.1
    peers: [10.77.0.2]
    programs:
      - {name: base, command: [simulator, --link, "${run_dir}/kobuki", --seed, "${seed}", ../map.yaml]}
    containers:
      - name: drive
        components:
          - driver
          - {component: navigator, name: pilot, parameters: {map: ../maps/a.yaml, gain: 2}}
  gcs:
    role: gcs
    address: 10.77.0.2
    peers: [10.77.0.1]
    containers:
      - {name: mission, terminal: true, components: [mission_control]}
)";

/// `text` with the first `from` replaced by `to`; the test fails when it is not there.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// A mistake in `whole`, and a part of what is said of it.
struct Mistake {
  const char* from;
  const char* to;
  std::string error;
};
template <class Load>
void expect_errors(const Load& error_of, const std::vector<Mistake>& mistakes) {
  for (const auto& [from, to, error] : mistakes) {
    EXPECT_THAT(error_of(with(whole, from, to)), ::testing::HasSubstr(error)) << to;
  }
}

}  // namespace tocsin::deployment
