// SPDX-License-Identifier: Apache-2.0
#include "foundation/state_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

namespace tocsin {
namespace {

constexpr std::size_t slot_bytes = 512;
constexpr std::size_t file_bytes = 2 * slot_bytes;

struct Slot {
  std::uint64_t sequence = 0;
  std::string text;
};

/// FNV-1a.
std::uint64_t checksum_of(std::uint64_t sequence, const std::string& text) {
  std::uint64_t hash = 14695981039346656037ULL ^ sequence;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return hash;
}

std::string to_bytes(const Slot& slot) {
  char head[60];
  const int length = std::snprintf(
      head, sizeof head, "%016llx %016llx %08zx\n", static_cast<unsigned long long>(slot.sequence),
      static_cast<unsigned long long>(checksum_of(slot.sequence, slot.text)), slot.text.size());
  std::string bytes(head, static_cast<std::size_t>(length));
  bytes += slot.text;
  bytes.resize(slot_bytes, ' ');
  return bytes;
}

std::optional<Slot> slot_of(const std::string& bytes) {
  unsigned long long sequence = 0;
  unsigned long long checksum = 0;
  std::size_t length = 0;
  int head = 0;
  const int read =
      std::sscanf(bytes.c_str(), "%16llx %16llx %8zx%n", &sequence, &checksum, &length, &head);
  const std::size_t begin = static_cast<std::size_t>(head) + 1;
  if (read != 3 || begin > bytes.size() || length > bytes.size() - begin) return std::nullopt;
  Slot slot{sequence, bytes.substr(begin, length)};
  if (checksum_of(slot.sequence, slot.text) != checksum) return std::nullopt;
  return slot;
}

std::optional<Slot> newest(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::optional<Slot> newest;
  for (int i = 0; i < 2; ++i) {
    std::string bytes(slot_bytes, '\0');
    if (!file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) break;
    const auto slot = slot_of(bytes);
    if (slot && (!newest || slot->sequence > newest->sequence)) newest = slot;
  }
  return newest;
}

bool write_at(int descriptor, const std::string& bytes, std::size_t at) {
  return ::pwrite(descriptor, bytes.data(), bytes.size(), static_cast<off_t>(at)) ==
         static_cast<ssize_t>(bytes.size());
}

/// Takes the room of the whole file.
bool fill(int descriptor) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return false;
  if (status.st_size >= static_cast<off_t>(file_bytes)) return true;
  return write_at(descriptor, std::string(file_bytes, ' '), 0);
}

}  // namespace

std::optional<std::string> StateFile::load() const {
  auto slot = newest(path_);
  return slot ? std::optional(std::move(slot->text)) : std::nullopt;
}

bool StateFile::open() {
  if (file_) return true;
  const auto last = newest(path_);
  FileDescriptor file(::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
  if (!file || !fill(file.get())) return false;
  file_ = std::move(file);
  sequence_ = last ? last->sequence : 0;
  return true;
}

bool StateFile::save(const std::string& text) {
  if (path_.empty()) return true;
  if (text.size() > longest || !open()) return false;
  const std::uint64_t next = sequence_ + 1;
  if (!write_at(file_.get(), to_bytes({next, text}), next % 2 * slot_bytes)) return false;
  sequence_ = next;
  return true;
}

}  // namespace tocsin
