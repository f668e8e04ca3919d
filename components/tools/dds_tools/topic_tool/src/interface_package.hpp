// SPDX-License-Identifier: Apache-2.0
// Interfaces as a package that ROS 2 builds (ament_cmake, rosidl_generate_interfaces).
#pragma once

#include <string>
#include <vector>

namespace tocsin::topic_tool {

/// A file of a package.
struct PackageFile {
  std::string path;  ///< below the package's folder: `msg/Goal.msg`
  std::string text;
};

/// package.xml, CMakeLists.txt and a .msg, .srv or .action file for each interface of `package`
/// that a loaded library has; none when no library has any. What is built from them has the names,
/// fields and hashes (RIHS01) that we announce. A bound of the IDL, "[bound 8]" in a field's
/// comment, is one of the file.
[[nodiscard]] std::vector<PackageFile> interface_package(const std::string& package);

/// Makes the folder `folder`/`package`. Throws ConfigError when the package is not known or the
/// folder is there, EnvironmentError when a file cannot be written; then nothing is left of it.
void export_package(const std::string& package, const std::string& folder);

}  // namespace tocsin::topic_tool
