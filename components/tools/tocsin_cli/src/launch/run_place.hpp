// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "deployment/run_folder.hpp"

namespace tocsin::cli {

/// Where a launch that nobody told a folder keeps its files.
struct RunPlace {
  std::string unnamed = "runs/";  ///< before the folder's name
  std::string spare;              ///< the same in memory; empty: there is none
};

/// With $RUNTIME_DIRECTORY, the folder in memory that systemd gives a service (systemd.exec(5),
/// RuntimeDirectory=), as the spare place.
[[nodiscard]] RunPlace run_place();

struct ChosenRunFolder {
  deployment::RunFolder folder;
  std::string warning;  ///< empty: it is where it should be
};

/// The folder of a run. One that nobody named is made in the spare place when its own disk takes
/// nothing (full, read-only): a vehicle that is switched on drives and is on the link without a
/// disk. Throws as RunFolder does when there is no other place, or none is wanted.
[[nodiscard]] ChosenRunFolder choose_run_folder(const std::string& wanted, const RunPlace& place);

}  // namespace tocsin::cli
