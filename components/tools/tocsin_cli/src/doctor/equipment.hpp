// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "advice.hpp"
#include "deployment/deployment.hpp"

namespace tocsin::doctor {

/// What this computer has.
struct Equipment {
  std::function<bool(const std::string& address)> is_running;   ///< an interface with it
  std::function<bool(const std::string& name)> has_interface;   ///< of the network
  std::function<int(const std::string& path)> error_of_device;  ///< errno of opening it; 0: none
  std::function<bool(const std::filesystem::path& folder)> may_write;
};

/// The equipment of the computer that this program runs on.
[[nodiscard]] Equipment own_equipment();

/// What the hosts of a file with a real radio need of this computer and whether it is there: their
/// addresses, the devices (`device_port`), the wireless interfaces (`interface_name`), and folders
/// that are named (`store_directory`).
[[nodiscard]] Advices judge_equipment(const deployment::Deployment& deployment,
                                      const Equipment& equipment);

/// Processes of the stack that run programs which an upgrade has replaced, by the kernel's names of
/// their programs (`/proc/PID/exe`).
[[nodiscard]] Advices judge_upgrade(const std::vector<std::string>& programs);

/// Those names, of all processes that this user may look into.
[[nodiscard]] std::vector<std::string> running_programs();

}  // namespace tocsin::doctor
