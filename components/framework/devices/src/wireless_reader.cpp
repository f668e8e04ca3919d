// SPDX-License-Identifier: Apache-2.0
#include "wireless_reader.hpp"

#include <net/if.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <utility>

#include "foundation/file_descriptor.hpp"

namespace tocsin::network {
namespace {

/// Age of the file's content. Files of the proc file system are always new.
double age_s(const std::string& path) {
  struct stat info {};
  timespec now{};
  if (stat(path.c_str(), &info) != 0 || clock_gettime(CLOCK_REALTIME, &now) != 0) return 0;
  return static_cast<double>(now.tv_sec - info.st_mtim.tv_sec);
}

/// Why an interface has no link at all, whatever else tells of it; empty when it may have one.
std::string why_dead(const std::string& interface) {
  if (if_nametoindex(interface.c_str()) == 0) return "there is no interface " + interface;
  ifreq request{};
  interface.copy(request.ifr_name, IFNAMSIZ - 1);
  const FileDescriptor any(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  const bool told = ioctl(any.get(), SIOCGIFFLAGS, &request) == 0;
  return told && (request.ifr_flags & IFF_UP) == 0 ? interface + " is down" : "";
}

}  // namespace

WirelessReader::WirelessReader(std::string interface, std::string proc_path)
    : interface_(std::move(interface)), path_(std::move(proc_path)) {}

WirelessReading WirelessReader::read() {
  if (std::string dead = why_dead(interface_); !dead.empty()) return absent(std::move(dead));
  WirelessReading reading = nl80211_.read(interface_);
  if (reading.source != WirelessSource::absent) return reading;
  WirelessReading second = read_file();
  if (second.source == WirelessSource::absent) second.note = reading.note + "; " + second.note;
  return second;
}

WirelessReading WirelessReader::read_file() const {
  constexpr double stale_s = 5.0;  // who writes this file (link_emulator) does so each second
  std::ifstream file(path_);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) return absent(path_ + " cannot be read");
  if (age_s(path_) > stale_s) return absent(path_ + " is no longer updated");
  return parse_proc_wireless(text.str(), interface_);
}

}  // namespace tocsin::network
