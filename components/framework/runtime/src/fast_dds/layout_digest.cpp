// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/layout_digest.hpp"

#include <fmt/format.h>

#include <array>
#include <cstring>
#include <vector>

namespace tocsin {
namespace {

constexpr std::size_t header = 4;
constexpr std::size_t most_bytes = 1U << 16U;

/// FNV-1a over all that is shown, texts by their place only.
class Digest : public FieldVisitor {
 public:
  void number(const char* name, double value) override {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    add('n', name, bits);
  }
  void integer(const char* name, std::int64_t value) override {
    add('i', name, static_cast<std::uint64_t>(value));
  }
  void text(const char* name, const std::string& value) override { add('t', name, value.size()); }
  void bytes(const char* name, const std::uint8_t*, std::size_t size) override {
    add('b', name, size);
  }
  void begin_struct(const char* name) override { add('(', name, 0); }
  void end_struct() override { add(')', "", 0); }
  void begin_list(const char* name, std::size_t size) override { add('[', name, size); }
  void end_list() override { add(']', "", 0); }
  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  void add(char kind, const char* name, std::uint64_t value) {
    take(static_cast<std::uint8_t>(kind));
    for (; *name != '\0'; ++name) take(static_cast<std::uint8_t>(*name));
    for (unsigned shift = 0; shift < 64; shift += 8) take(value >> shift & 0xFFU);
  }
  void take(std::uint64_t byte) { hash_ = (hash_ ^ byte) * 1099511628211ULL; }
  std::uint64_t hash_ = 1469598103934665603ULL;
};

using Bytes = std::vector<std::uint8_t>;

/// Little endian; each aligned word is 1, which is a length, a true or a number.
Bytes ones(std::size_t size) {
  Bytes bytes(size, 0);
  bytes[1] = 1;
  for (std::size_t at = header; at < size; at += 4) bytes[at] = 1;
  return bytes;
}

/// The fewest bytes that the type takes for a message; 0 when it takes none of these.
std::size_t taken_by(const TypeInfo& type, void* message) {
  const Bytes bytes = ones(most_bytes);
  if (!type.deserialize(bytes.data(), bytes.size(), message)) return 0;
  std::size_t low = header - 1;
  std::size_t high = most_bytes;
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (type.deserialize(bytes.data(), middle, message) ? high : low) = middle;
  }
  return high;
}

/// Puts different bytes into every word in which the type takes them: those are numbers, whose
/// value tells their width. No byte is so large that a number could become NaN.
Bytes probe(const TypeInfo& type, void* message, std::size_t size) {
  Bytes bytes = ones((size + 3) / 4 * 4);
  std::uint8_t next = 0x11;
  for (std::size_t at = header; at < bytes.size(); at += 4) {
    const std::array<std::uint8_t, 4> large{0x7E, 0x7D, 0x7C, 0x7B};
    std::memcpy(&bytes[at], large.data(), 4);
    const bool number = type.deserialize(bytes.data(), size, message);
    for (std::size_t i = 0; i < 4; ++i) {
      bytes[at + i] = number ? next : static_cast<std::uint8_t>(i == 0 ? 1 : 0);
      next = static_cast<std::uint8_t>(next % 0x6D + 1);
    }
  }
  return bytes;
}

}  // namespace

std::string layout_digest(const TypeInfo& type) {
  const std::shared_ptr<void> message = type.create();
  const std::size_t size = taken_by(type, message.get());
  if (size == 0) return "";
  const Bytes bytes = probe(type, message.get(), size);
  if (!type.deserialize(bytes.data(), bytes.size(), message.get())) return "";
  Digest digest;
  type.visit(message.get(), digest);
  digest.integer("bytes", static_cast<std::int64_t>(size));
  return fmt::format("{:016x}", digest.value());
}

}  // namespace tocsin
