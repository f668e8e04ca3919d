// SPDX-License-Identifier: Apache-2.0
#include "interface_package.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "command_line/run_to_end.hpp"
#include "foundation/error.hpp"
#include "foundation/ros_names.hpp"
#include "foundation/temporary_folder.hpp"
#include "idl_support/type_definition.hpp"
#include "idl_support/type_registry.hpp"
#include "ros_idl/geometry_msgs.hpp"
#include "tocsin_idl/link_calls.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin::topic_tool {
namespace {

using ::testing::HasSubstr;

/// Keeps the libraries linked whose registrations are looked at.
void load() {
  (void)type_info<tocsin_msgs::msg::Goal>();
  (void)type_info<geometry_msgs::msg::Pose>();
}

std::string text_of(const std::vector<PackageFile>& files, const std::string& path) {
  for (const PackageFile& one : files) {
    if (one.path == path) return one.text;
  }
  return "no " + path;
}

std::string read(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(InterfacePackage, NamesAllItsFilesAndWhatTheyNeed) {
  load();
  const auto files = interface_package("tocsin_msgs");
  const std::string cmake = text_of(files, "CMakeLists.txt");
  EXPECT_THAT(cmake, HasSubstr("project(tocsin_msgs)"));
  EXPECT_THAT(cmake, HasSubstr("find_package(builtin_interfaces REQUIRED)"));
  for (const PackageFile& one : files) {
    const bool is_interface = one.path.find('/') != std::string::npos;
    EXPECT_EQ(cmake.find('"' + one.path + '"') != std::string::npos, is_interface) << one.path;
  }
  const std::string manifest = text_of(files, "package.xml");
  EXPECT_THAT(manifest, HasSubstr("<name>tocsin_msgs</name>"));
  EXPECT_THAT(manifest, HasSubstr("<depend>builtin_interfaces</depend>"));
  EXPECT_EQ(manifest.find("<depend>tocsin_msgs"), std::string::npos);
}

TEST(InterfacePackage, TakesBoundsFromTheComments) {
  register_definition({"bounded::msg::dds_::Few_",
                       "string name  # [bound 8] of it\nuint8[] data  # [bound 3]\n"
                       "uint8[4] fixed  # [bound 3]\n",
                       {}});
  EXPECT_EQ(text_of(interface_package("bounded"), "msg/Few.msg"),
            "string<=8 name  # [bound 8] of it\nuint8[<=3] data  # [bound 3]\n"
            "uint8[4] fixed  # [bound 3]\n");
}

/// Each struct of an IDL file: {name: ["name comment" of each field]}.
std::map<std::string, std::vector<std::string>> structs_in(const std::string& file) {
  static const std::regex begin(R"(^@final struct (\w+) \{)");
  static const std::regex field(R"(^  .*?(\w+)(?:\[\d+\])?;\s*(?:// ?(.*?))?\s*$)");
  std::map<std::string, std::vector<std::string>> found;
  std::istringstream lines(read(file));
  std::string name;
  for (std::string line; std::getline(lines, line);) {
    std::smatch said;
    if (std::regex_search(line, said, begin)) name = said[1];
    if (!name.empty() && std::regex_match(line, said, field)) {
      found[name].push_back(said[1].str() + " " + said[2].str());
    }
  }
  return found;
}

/// What ROS 2's own parser says of the exported package; null where it is not installed.
nlohmann::json as_ros_reads(const std::string& folder) {
  std::vector<std::string> command{TOCSIN_REPOSITORY
                                   "/components/tools/dds_tools/topic_tool/test/read_package.py"};
  for (const char* const package : {"tocsin_msgs", "builtin_interfaces", "geometry_msgs"}) {
    export_package(package, folder);
    command.push_back(folder + "/" + package);
  }
  const Ended ended = run_to_end(command);
  if (ended.code == 3) return nullptr;
  EXPECT_EQ(ended.code, 0) << ended.output;
  return nlohmann::json::parse(ended.output);
}

/// Requests and responses are of services.
std::string full_name(const std::string& name) {
  static const std::regex half(".*_(Request|Response)");
  return std::regex_match(name, half) ? "tocsin_msgs/srv/" + name : "tocsin_msgs/msg/" + name;
}

TEST(InterfacePackage, IsToTheParserOfRos2WhatTheIdlAndTheAnnouncedHashesSay) {
  load();
  const TemporaryFolder folder;
  const nlohmann::json said = as_ros_reads(folder.path());
  if (said.is_null()) GTEST_SKIP() << "python3-rosidl is not installed";
  std::size_t structs = 0;
  for (const char* const file : {"tocsin_msgs", "link_calls"}) {
    for (const auto& [name, fields] :
         structs_in(std::string(TOCSIN_REPOSITORY "/idl/tocsin_idl/idl/") + file + ".idl")) {
      const std::string type = full_name(name);
      ASSERT_TRUE(said.contains(type)) << type;
      std::vector<std::string> read;
      for (const auto& field : said[type]["fields"]) {
        read.push_back(field[1].get<std::string>() + " " + field[2].get<std::string>());
      }
      EXPECT_EQ(read, fields) << type;
      const TypeInfo* const announced = find_type(wire_type(type));
      ASSERT_NE(announced, nullptr) << type;
      EXPECT_EQ(said[type]["hash"], announced->ros_hash) << type;
      ++structs;
    }
  }
  EXPECT_GT(structs, 30U);
  EXPECT_EQ(said.size(), structs);
}

TEST(InterfacePackage, RefusesInOneLineWhatIsUnknownOrThere) {
  load();
  const TemporaryFolder folder;
  EXPECT_THROW(export_package("no_msgs", folder.path()), ConfigError);
  export_package("tocsin_msgs", folder.path());
  const std::string before = read(folder.path("tocsin_msgs/package.xml"));
  EXPECT_THROW(export_package("tocsin_msgs", folder.path()), ConfigError);
  EXPECT_EQ(read(folder.path("tocsin_msgs/package.xml")), before);
}

TEST(InterfacePackage, LeavesNothingWhereItCannotBeWritten) {
  load();
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "");
  EXPECT_THROW(export_package("tocsin_msgs", file), EnvironmentError);
  EXPECT_TRUE(std::filesystem::is_regular_file(file));
}

}  // namespace
}  // namespace tocsin::topic_tool
