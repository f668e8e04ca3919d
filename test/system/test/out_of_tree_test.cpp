// SPDX-License-Identifier: Apache-2.0
// A user's own workspace over ours: a message type and two components in one package, built by
// colcon after `source install/setup.bash`, run by their names.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <memory>
#include <string>

#include "foundation/temporary_folder.hpp"
#include "operator_process.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* package_xml = R"(<?xml version="1.0"?>
<package format="3">
  <name>NAME</name>
  <version>0.0.1</version>
  <description>Of a user.</description>
  <maintainer email="user@example.org">A user</maintainer>
  <license>Proprietary</license>
  DEPENDS
  <export><build_type>cmake</build_type></export>
</package>
)";

constexpr const char* topic_header = R"(#pragma once
#include <lamp_idl/lamp_msgs.hpp>

#include "idl_support/topic_info.hpp"

struct Lamp {
  using Message = lamp_idl::msg::Lamp;
  static constexpr tocsin::TopicInfo info{"lamp", "state", tocsin::Scope::host};
};
)";

// Not free of what our own warnings would find.
constexpr const char* lamp_switch_source = R"(
#include "lamp_topic.hpp"
#include "runtime/component_entry.hpp"
#include "runtime/port.hpp"

class LampSwitch final : public tocsin::Component {
 public:
  struct Params {
    int brightness = 1;
    template <class Visitor>
    void visit(Visitor& v) {
      v("brightness", brightness, {0, 100}, "[%] of the lamp");
    }
  };
  LampSwitch(tocsin::Context& context, const Params& params) : Component(context), params_(params) {}
  void tick(tocsin::Time now) override {
    int unused = 3.5;
    Lamp::Message lamp;
    lamp.x(params_.brightness);
    lamp.z(7);
    (void)lamp_.write(lamp);
  }

 private:
  tocsin::Output<Lamp> lamp_{*this};
  Params params_;
};
TOCSIN_COMPONENT(LampSwitch)
)";

constexpr const char* lamp_source = R"(
#include "lamp_topic.hpp"
#include "runtime/component_entry.hpp"
#include "runtime/logger.hpp"
#include "runtime/port.hpp"

class LampItself final : public tocsin::Component {
 public:
  struct Params {
    template <class Visitor>
    void visit(Visitor&) {}
  };
  LampItself(tocsin::Context& context, const Params&) : Component(context) {}
  void tick(tocsin::Time) override {
    while (const auto lamp = lamp_.take()) log().info("the lamp has {} and {}", lamp->x(), lamp->z());
  }

 private:
  tocsin::Input<Lamp> lamp_{*this};
};
TOCSIN_COMPONENT(LampItself)
)";

std::string with(std::string text, const std::string& word, const std::string& other) {
  return text.replace(text.find(word), word.size(), other);
}

class OutOfTreeTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    workspace_ = new TemporaryFolder;
    workspace_->write("src/lamp_idl/package.xml", with(with(package_xml, "NAME", "lamp_idl"),
                                                       "DEPENDS", "<depend>tocsin_cmake</depend>"));
    workspace_->write("src/lamp_idl/CMakeLists.txt",
                      "cmake_minimum_required(VERSION 3.25)\nproject(lamp_idl LANGUAGES CXX)\n"
                      "find_package(tocsin_cmake REQUIRED)\nfind_package(idl_support REQUIRED)\n"
                      "tocsin_idl_library(lamp_idl IDL idl/lamp_msgs.idl)\n");
    workspace_->write("src/lamp_idl/idl/lamp_msgs.idl",
                      "module lamp_idl { module msg { @final struct Lamp { long x, z; }; }; };\n");
    workspace_->write("src/lamps/package.xml",
                      with(with(package_xml, "NAME", "lamps"), "DEPENDS",
                           "<depend>runtime</depend><depend>lamp_idl</depend>"));
    workspace_->write("src/lamps/CMakeLists.txt",
                      "cmake_minimum_required(VERSION 3.25)\nproject(lamps LANGUAGES CXX)\n"
                      "find_package(tocsin_cmake REQUIRED)\nfind_package(runtime REQUIRED)\n"
                      "find_package(lamp_idl REQUIRED)\n"
                      "foreach(name lamp_switch lamp)\n"
                      "  tocsin_component(${name} COMPONENT src/${name}.cpp LINK "
                      "lamp_idl::lamp_idl)\nendforeach()\n");
    workspace_->write("src/lamps/src/lamp_topic.hpp", topic_header);
    workspace_->write("src/lamps/src/lamp_switch.cpp", lamp_switch_source);
    workspace_->write("src/lamps/src/lamp.cpp", lamp_source);
    built_ = shell("cd " + workspace_->path() + " && source " + Stack::setup() +
                   " && colcon build --cmake-args -DCMAKE_CXX_FLAGS='-Wall -Wextra -Wconversion'");
  }
  static void TearDownTestSuite() { delete workspace_; }

  /// A command in a shell that has sourced nothing; its exit code. Prints into `shell.out`.
  static int shell(const std::string& command) {
    return process(command, "shell.out")->exit_code(seconds(200));
  }
  static std::unique_ptr<OperatorProcess> process(const std::string& command,
                                                  const std::string& output) {
    return std::make_unique<OperatorProcess>(
        std::vector<std::string>{"/usr/bin/env", "-u", "COLCON_PREFIX_PATH", "-u",
                                 "CMAKE_PREFIX_PATH", "bash", "-c", command},
        workspace_->path(output));
  }
  static std::string both() {
    return "source " + Stack::setup() + " && source " + workspace_->path("install/setup.bash") +
           " && ";
  }
  static TemporaryFolder* workspace_;
  static int built_;
};

TemporaryFolder* OutOfTreeTest::workspace_ = nullptr;
int OutOfTreeTest::built_ = -1;

TEST_F(OutOfTreeTest, WarningsOfUsersAreNoErrors) {
  ASSERT_EQ(built_, 0) << workspace_->read("shell.out");
  EXPECT_THAT(workspace_->read("log/latest_build/lamps/stderr.log"), HasSubstr("warning"));
}

TEST_F(OutOfTreeTest, TheirComponentsAreListedWithTheirPackageOnceTheirWorkspaceIsSourced) {
  ASSERT_EQ(built_, 0);
  workspace_->write("shell.out", "");
  ASSERT_EQ(shell(both() + "tocsin component types"), 0);
  const std::string sourced = workspace_->read("shell.out");
  EXPECT_THAT(sourced, HasSubstr("lamp_switch              lamps\n"));
  EXPECT_THAT(sourced, HasSubstr("navigator                navigator\n"));
  workspace_->write("shell.out", "");
  ASSERT_EQ(shell("source " + Stack::setup() + " && tocsin component types"), 0);
  EXPECT_THAT(workspace_->read("shell.out"), Not(HasSubstr("lamp")));
}

TEST_F(OutOfTreeTest, TheirComponentsRunByNameAndHearEachOther) {
  ASSERT_EQ(built_, 0);
  const auto lamp = process(both() + "tocsin run lamp --domain 73", "lamp.out");
  const auto lamp_switch =
      process(both() + "tocsin run lamp_switch --domain 73 --set brightness=40", "switch.out");
  EXPECT_TRUE(Stack::eventually(
      seconds(30),
      [] {
        return workspace_->read("lamp.out").find("the lamp has 40 and 7") != std::string::npos;
      }))
      << workspace_->read("lamp.out") << workspace_->read("switch.out");
}

}  // namespace
}  // namespace tocsin
