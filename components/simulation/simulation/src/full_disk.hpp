// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace tocsin::simulation {

/// A full disk under the folder of a run: as long as it lives, files that this process has open for
/// appending there take nothing, and the kernel answers ENOSPC. What is written in place goes on,
/// as it needs no room. Files opened afterwards are not seen.
class FullDisk {
 public:
  explicit FullDisk(const std::string& folder);
  /// There is room again. The number of a file that was closed meanwhile stays whose it is now.
  ~FullDisk();
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  struct File {
    int descriptor;  ///< refers to /dev/full
    int real;        ///< the file that it referred to
  };
  std::vector<File> files_;
};

}  // namespace tocsin::simulation
