// SPDX-License-Identifier: Apache-2.0
// The component of README.md, compiled as it stands there, runs; and the public headers stay small.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "foundation/error.hpp"
#include "runtime/component_entry.hpp"
#include "runtime/sim_bus.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

const ComponentEntry& readme_component() {
  void* const library = dlopen(README_LIBRARY, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw std::runtime_error(dlerror());
  using EntryFunction = const ComponentEntry* (*)();
  return *reinterpret_cast<EntryFunction>(dlsym(library, "tocsin_component"))();
}

/// As in README.md.
struct LampRed {
  using Message = std_msgs::msg::Bool;
  static constexpr TopicInfo info{"link_lamp/red", "state", Scope::host};
};

tocsin_msgs::msg::TransmissionState quality(float qni) {
  tocsin_msgs::msg::TransmissionState state;
  state.qni(qni);
  return state;
}

TEST(Readme, ItsComponentTurnsTheLampRedOnlyBelowItsLimit) {
  SimBus bus;
  Context context{bus, "link_lamp", Role::uxv};
  SimReader<LampRed> lamp(bus);
  const auto sut = readme_component().create(context, YAML::Load("{poor_below: 40}"), "test");
  bus.add(*sut);
  bus.publish<topic::TransmissionState>(quality(40));
  bus.publish<topic::TransmissionState>(quality(39));
  bus.run_for(Duration::zero());
  const auto taken = lamp.take();
  ASSERT_EQ(taken.size(), 2U);
  EXPECT_FALSE(taken[0].data());
  EXPECT_TRUE(taken[1].data());
}

TEST(Readme, ItsComponentRefusesAWrongParameter) {
  SimBus bus;
  Context context{bus, "link_lamp", Role::uxv};
  EXPECT_THROW(readme_component().create(context, YAML::Load("{poor_below: 101}"), "test"),
               ConfigError);
}

TEST(Readme, WhatAComponentAuthorReadsIsUnderNineHundredLines) {
  const std::filesystem::path folder =
      std::filesystem::path(TOCSIN_SOURCE_DIR) / "include" / "runtime";
  int lines = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() != ".hpp") continue;
    std::ifstream text(file.path());
    for (std::string line; std::getline(text, line);) ++lines;
  }
  RecordProperty("lines", lines);
  EXPECT_GT(lines, 300);
  EXPECT_LT(lines, 900);
}

}  // namespace
}  // namespace tocsin
