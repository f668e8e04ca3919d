// SPDX-License-Identifier: Apache-2.0
#include "measured.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <fstream>

#include "foundation/file_descriptor.hpp"

namespace tocsin::bench {
namespace {

double cpu_s() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace

Measured measured(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  const double cpu_before = cpu_s();
  work();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  return {wall.count(), cpu_s() - cpu_before};
}

void print_row(const std::string& name, const Measured& took, std::uint64_t bytes,
               std::uint64_t messages) {
  const double mb = static_cast<double>(bytes) * 1e-6;
  std::string row =
      fmt::format("| {} | {:.0f} | {:.0f} |", name, mb / took.wall_s, mb / took.cpu_s);
  if (messages > 0) {
    const auto count = static_cast<double>(messages) * 1e-3;
    row += fmt::format(" {:.0f} | {:.0f} |", count / took.wall_s, count / took.cpu_s);
  }
  fmt::print("{}\n", row);
  std::fflush(stdout);
}

std::uint64_t peak_resident_kib() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmHWM:", 0) == 0) return std::stoull(line.substr(6));
  }
  return 0;
}

void reset_peak() { std::ofstream("/proc/self/clear_refs") << 5; }

void drop_cache(const std::string& path) {
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file) return;
  (void)::fdatasync(file.get());
  (void)::posix_fadvise(file.get(), 0, 0, POSIX_FADV_DONTNEED);
}

}  // namespace tocsin::bench
