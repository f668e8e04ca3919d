// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin {

/// A file that is gone with the test.
class ConfigFile {
 public:
  explicit ConfigFile(const std::string& text) : path_(folder_.write("config.yaml", text)) {}
  /// Writes a file beside it.
  void write(const std::string& name, const std::string& text) const {
    (void)folder_.write(name, text);
  }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  const TemporaryFolder folder_;
  std::string path_;
};

template <class Call>
std::string error_of(const Call& call) {
  try {
    call();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace tocsin
