// SPDX-License-Identifier: Apache-2.0
#include "interface_package.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/replace_file.hpp"
#include "foundation/ros_names.hpp"
#include "idl_support/type_definition.hpp"
#include "interface_text.hpp"

namespace tocsin::topic_tool {
namespace {

namespace fs = std::filesystem;

/// A line with the bound that its comment tells: of a string, or of a list without a size.
std::string bounded(const std::string& line) {
  static const std::regex bound(R"(^(\S+) (\S+)(  # .*\[bound (\d+)\].*)$)");
  std::smatch said;
  if (!std::regex_match(line, said, bound)) return line;
  std::string type = said[1];
  if (type == "string") {
    type += "<=" + said[4].str();
  } else if (type.size() > 2 && type.compare(type.size() - 2, 2, "[]") == 0) {
    type.insert(type.size() - 1, "<=" + said[4].str());
  }
  return fmt::format("{} {}{}", type, said[2].str(), said[3].str());
}

/// The fields of one part of an interface. ROS 2 itself gives an empty part its one field.
std::string fields_of(const TypeDefinition& type) {
  std::istringstream lines(type.text);
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("structure_needs_at_least_one_member") == std::string::npos) {
      text += bounded(line) + "\n";
    }
  }
  return text;
}

class Package {
 public:
  explicit Package(std::string name) : name_(std::move(name)) {
    const Interfaces all = interfaces_in(known_definitions());
    for (const std::string& one : all.all()) {
      if (one.substr(0, one.find('/')) == name_) add(one);
    }
    if (!files_.empty()) {
      files_.push_back({"CMakeLists.txt", cmake_text()});
      files_.push_back({"package.xml", manifest_text()});
    }
  }
  [[nodiscard]] const std::vector<PackageFile>& files() const { return files_; }

 private:
  void add(const std::string& interface) {
    std::string text;
    bool first = true;
    for (const std::string& part : parts_of(interface)) {
      const auto type = find_definition(wire_type(part));
      if (!type) return;  // nothing that such a file can say
      if (!first) text += "---\n";
      first = false;
      text += fields_of(*type);
      for (const std::string& of : type->parts) needs_.insert(of.substr(0, of.find("::")));
    }
    const std::string file = interface.substr(name_.size() + 1);
    const std::string kind = file.substr(0, file.find('/'));
    if (kind == "action") needs_.insert("action_msgs");
    needs_.erase(name_);
    files_.push_back({file + "." + kind, text});
  }
  [[nodiscard]] std::string cmake_text() const {
    std::string text = "cmake_minimum_required(VERSION 3.8)\nproject(" + name_ +
                       ")\n\nfind_package(ament_cmake REQUIRED)\n"
                       "find_package(rosidl_default_generators REQUIRED)\n";
    for (const std::string& one : needs_) text += "find_package(" + one + " REQUIRED)\n";
    text += "rosidl_generate_interfaces(${PROJECT_NAME}\n";
    for (const PackageFile& one : files_) text += "  \"" + one.path + "\"\n";
    if (!needs_.empty()) text += "  DEPENDENCIES";
    for (const std::string& one : needs_) text += " " + one;
    return text + ")\nament_export_dependencies(rosidl_default_runtime)\nament_package()\n";
  }
  [[nodiscard]] std::string manifest_text() const {
    std::string depends;
    for (const std::string& one : needs_) depends += fmt::format("  <depend>{}</depend>\n", one);
    return fmt::format(
        "<?xml version=\"1.0\"?>\n<package format=\"3\">\n  <name>{}</name>\n"
        "  <version>" TOCSIN_VERSION
        "</version>\n"
        "  <description>Interfaces of Tocsin, made by tocsin interface export.</description>\n"
        "  <maintainer email=\"developers@tocsin.invalid\">Tocsin developers</maintainer>\n"
        "  <license>Apache-2.0</license>\n"
        "  <buildtool_depend>ament_cmake</buildtool_depend>\n"
        "  <buildtool_depend>rosidl_default_generators</buildtool_depend>\n{}"
        "  <exec_depend>rosidl_default_runtime</exec_depend>\n"
        "  <member_of_group>rosidl_interface_packages</member_of_group>\n"
        "  <export><build_type>ament_cmake</build_type></export>\n</package>\n",
        name_, depends);
  }

  std::string name_;
  std::vector<PackageFile> files_;
  std::set<std::string> needs_;  ///< packages that its fields are of
};

/// Throws EnvironmentError for the first file that cannot be written.
void write(const fs::path& folder, const std::vector<PackageFile>& files) {
  for (const PackageFile& one : files) {
    std::error_code error;
    fs::create_directories((folder / one.path).parent_path(), error);
    if (!error) error = replace_file((folder / one.path).string(), one.text, Sync::no);
    if (error) throw EnvironmentError((folder / one.path).string() + ": " + error.message());
  }
}

}  // namespace

std::vector<PackageFile> interface_package(const std::string& package) {
  return Package(package).files();
}

void export_package(const std::string& package, const std::string& folder) {
  const std::vector<PackageFile> files = interface_package(package);
  if (files.empty()) {
    throw ConfigError("the package '" + printable(package) +
                      "' is not known here: no installed package has its IDL; see tocsin "
                      "interface packages");
  }
  const fs::path whole = fs::path(folder) / package;
  std::error_code ignored;
  if (fs::exists(whole, ignored)) {
    throw ConfigError(printable(whole.string()) + " is there already: remove it, or name another");
  }
  try {
    write(whole, files);
  } catch (const EnvironmentError&) {
    fs::remove_all(whole, ignored);
    throw;
  }
}

}  // namespace tocsin::topic_tool
