// SPDX-License-Identifier: Apache-2.0
#include "equipment.hpp"

#include <fcntl.h>
#include <net/if.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "foundation/file_descriptor.hpp"
#include "foundation/network_interface.hpp"

namespace tocsin::doctor {
namespace {

namespace fs = std::filesystem;

/// Opened like no one who wants to talk to it: a serial line keeps its settings and its modem
/// lines.
int error_of_device(const std::string& path) {
  return FileDescriptor(::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)) ? 0
                                                                                          : errno;
}

/// Whether a folder can be written to, or made.
bool may_write(const fs::path& folder) {
  fs::path place = fs::absolute(folder);
  std::error_code ignored;
  while (!fs::exists(place, ignored) && place.has_parent_path() && place != place.parent_path()) {
    place = place.parent_path();
  }
  return ::access(place.c_str(), W_OK | X_OK) == 0;
}

/// The text of a parameter that the file sets; empty: it does not.
std::string text_of(const deployment::ComponentInstance& component, const char* key) {
  const YAML::Node value = (*component.parameters)[key];
  return value.IsDefined() && value.IsScalar() ? value.Scalar() : "";
}

class Examiner {
 public:
  Examiner(const Equipment& equipment, Advices& advices)
      : equipment_(equipment), advices_(advices) {}

  void look_at(const deployment::Host& host) {
    if (!host.address.empty()) {
      add(equipment_.is_running(host.address), host.name + ": address " + host.address,
          "no interface with carrier has it", "topics of the link wait for it, all else runs");
    }
    if (host.second) {
      add(equipment_.is_running(host.second->address),
          host.name + ": second address " + host.second->address,
          "no interface with carrier has it", "the link goes by the other path alone until then");
    }
    for (const deployment::Container& container : host.containers) {
      for (const auto& component : container.components) look_at(host.name, component);
    }
  }

 private:
  void look_at(const std::string& host, const deployment::ComponentInstance& component) {
    const std::string owner = host + "/" + component.name + ": ";
    const std::string device = text_of(component, "device_port");
    if (!device.empty()) look_at_device(owner, device);
    const std::string interface = text_of(component, "interface_name");
    if (!interface.empty()) {
      add(equipment_.has_interface(interface), owner + "interface " + interface, "is not there",
          "ip link shows their names; parameter interface_name");
    }
    const std::string folder = text_of(component, "store_directory");
    if (!folder.empty()) {
      add(equipment_.may_write(folder), owner + "folder " + folder, "cannot be written to",
          "its user needs it: tocsin for a service, see tocsin@.service");
    }
  }

  void look_at_device(const std::string& owner, const std::string& device) {
    const int error = equipment_.error_of_device(device);
    const bool is_forbidden = error == EACCES || error == EPERM;
    add(error == 0, owner + device, std::system_category().message(error),
        is_forbidden ? "its user belongs into group dialout: adduser NAME dialout"
                     : "is it plugged in? The names /dev/kobuki and /dev/rplidar are udev's: "
                       "package tocsin-vehicle, or bringup/install_udev");
  }

  void add(bool is_good, const std::string& what, const std::string& fault,
           const std::string& remedy) {
    advices_.push_back(is_good ? Advice{Fitness::good, what, ""}
                               : Advice{Fitness::bad, what + ": " + fault, remedy});
  }

  const Equipment& equipment_;
  Advices& advices_;
};

}  // namespace

Equipment own_equipment() {
  return {interface_is_running,
          [](const std::string& name) { return ::if_nametoindex(name.c_str()) != 0; },
          error_of_device, may_write};
}

Advices judge_equipment(const deployment::Deployment& deployment, const Equipment& equipment) {
  Advices advices;
  if (deployment.radio) return advices;
  Examiner examiner(equipment, advices);
  for (const deployment::Host& host : deployment.hosts) examiner.look_at(host);
  return advices;
}

Advices judge_upgrade(const std::vector<std::string>& programs) {
  const std::string replaced = " (deleted)";
  const auto count = std::count_if(programs.begin(), programs.end(), [&](const std::string& name) {
    const auto end = name.rfind(replaced);
    return end != std::string::npos && end + replaced.size() == name.size() &&
           fs::path(name).filename().string().rfind("tocsin-", 0) == 0;
  });
  if (count == 0) return {{Fitness::good, "no process runs a program that was replaced", ""}};
  return {{Fitness::bad, std::to_string(count) + " processes run programs that were replaced since",
           "when the vehicle stands: systemctl restart tocsin@NAME, or launch again"}};
}

std::vector<std::string> running_programs() {
  std::vector<std::string> programs;
  std::error_code failed;
  for (const auto& process : fs::directory_iterator("/proc", failed)) {
    const fs::path program = fs::read_symlink(process.path() / "exe", failed);
    if (!failed) programs.push_back(program);
  }
  return programs;
}

}  // namespace tocsin::doctor
