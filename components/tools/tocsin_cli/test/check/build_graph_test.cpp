// SPDX-License-Identifier: Apache-2.0
#include "build_graph.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin::check {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

deployment::ComponentInstance instance(const std::string& component, const std::string& name) {
  return {component, name, nullptr};
}

TEST(BuildGraph, EachComponentThatCannotBeBuiltIsAnErrorOfItsOwn) {
  deployment::Deployment deployment;
  for (const char* name : {"uxv", "gcs"}) {
    deployment::Host& host = deployment.hosts.emplace_back();
    host.name = name;
    deployment::Container& container = host.containers.emplace_back();
    container.name = "drive";
    container.components = {instance("no_such_component", "pilot"),
                            instance("no_such_component", "copilot")};
  }
  const BuiltGraph sut = build_graph(deployment);
  EXPECT_TRUE(sut.graph.empty());
  ASSERT_EQ(sut.findings.size(), 4U) << "the first does not hide the others";
  for (const Finding& one : sut.findings) {
    EXPECT_EQ(one.severity, Severity::error);
    EXPECT_THAT(one.text, HasSubstr("no_such_component"));
  }
  EXPECT_THAT(sut.findings[0].text, StartsWith("uxv/drive/pilot: "));
  EXPECT_THAT(sut.findings[3].text, StartsWith("gcs/drive/copilot: "));
}

}  // namespace
}  // namespace tocsin::check
