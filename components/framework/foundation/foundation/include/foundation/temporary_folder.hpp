// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "foundation/file_descriptor.hpp"

namespace tocsin {

/// A folder in the temporary directory ($TMPDIR, else /tmp) that is removed with everything in it:
/// by the destructor, and however else the process ends (signal, crash, kill -9) by a waiting
/// shell.
class TemporaryFolder {
 public:
  /// Throws EnvironmentError when none can be made.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] std::string path() const { return path_; }
  [[nodiscard]] std::string path(const std::string& name) const { return path_ / name; }
  /// Makes a file, with its folders; returns its path.
  std::string write(const std::string& name, const std::string& text) const;
  /// Makes a file that can be executed.
  std::string write_program(const std::string& name, const std::string& text) const;
  /// The text of a file; empty when it is absent.
  [[nodiscard]] std::string read(const std::string& name) const;

 private:
  std::filesystem::path path_;
  FileDescriptor lifeline_;  ///< end of a pipe; when it closes, the shell removes the folder
};

}  // namespace tocsin
