// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace tocsin::cli {

/// A folder in /tmp that is removed with everything in it.
class ToyFolder {
 public:
  ToyFolder() {
    std::string name = "/tmp/tocsin_test_XXXXXX";
    path_ = ::mkdtemp(name.data());
  }
  ~ToyFolder() { std::filesystem::remove_all(path_); }
  ToyFolder(const ToyFolder&) = delete;
  ToyFolder& operator=(const ToyFolder&) = delete;

  [[nodiscard]] std::string path(const std::string& name) const { return path_ / name; }
  /// Makes a file, with its folders; returns its path.
  std::string write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name) << text;
    return path(name);
  }
  /// Makes a file that can be executed.
  std::string write_program(const std::string& name, const std::string& text) const {
    const std::string file = write(name, "#!/bin/sh\n" + text);
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    return file;
  }
  /// Makes the user own the folder and its files.
  void give_to(unsigned user) const {
    EXPECT_EQ(::chown(path_.c_str(), user, user), 0);
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path_)) {
      EXPECT_EQ(::chown(entry.path().c_str(), user, user), 0);
    }
  }
  /// The text of a file; empty when it is absent.
  [[nodiscard]] std::string read(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(path_ / name).rdbuf();
    return text.str();
  }

 private:
  std::filesystem::path path_;
};

}  // namespace tocsin::cli
