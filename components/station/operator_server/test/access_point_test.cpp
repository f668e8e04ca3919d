// SPDX-License-Identifier: Apache-2.0
#include "access_point.hpp"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <memory>
#include <tuple>

#include "deployment/deployment.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::foxglove {
namespace {

class AccessPointTest : public ::testing::Test {
 protected:
  /// The point of a run whose radio has this channel file; empty: the run has no radio.
  [[nodiscard]] std::optional<geometry::Point> point_of(const std::string& channel) const {
    deployment::Deployment run;
    run.qos = TOCSIN_REPOSITORY "/config/qos.yaml";
    run.traffic = TOCSIN_REPOSITORY "/config/traffic.yaml";
    const auto none = std::make_shared<const YAML::Node>(YAML::NodeType::Map);
    for (const auto& [name, role, address] :
         {std::tuple("uxv", Role::uxv, "10.77.0.1"), std::tuple("gcs", Role::gcs, "10.77.0.2")}) {
      deployment::Host host;
      host.name = name;
      host.role = role;
      host.address = address;
      host.containers = {{"page", false, {{"part", "part", none}}}};
      run.hosts.push_back(host);
    }
    run.run_dir = folder_.path();
    if (!channel.empty()) {
      run.radio = deployment::Radio{folder_.write("radio.yaml", channel),
                                    folder_.write("walls.yaml", "walls: []\n")};
    }
    deployment::write_resolved(run, folder_.path("deployment.yaml"));
    EXPECT_NO_THROW((void)deployment::load_resolved(folder_.path("deployment.yaml")));
    return access_point_of(folder_.path());
  }
  const TemporaryFolder folder_;
};

TEST_F(AccessPointTest, IsThatOfTheRunsRadio) {
  const auto point = point_of("radio_channel: {access_point_x_m: 1.8, access_point_y_m: -2}\n");
  ASSERT_TRUE(point);
  EXPECT_EQ(point->x_m, 1.8);
  EXPECT_EQ(point->y_m, -2);
}

TEST_F(AccessPointTest, IsUnknownWhereTheRunHasNoneOrItsFilesCannotBeRead) {
  EXPECT_FALSE(point_of(""));
  EXPECT_FALSE(point_of("radio_channel: {mode: bernoulli, loss: 0.1}\n"));
  EXPECT_FALSE(point_of("radio_channel: {access_point_x_m: here}\n"));
  EXPECT_FALSE(access_point_of("/no/such/run"));
  EXPECT_FALSE(access_point_of(""));
}

}  // namespace
}  // namespace tocsin::foxglove
