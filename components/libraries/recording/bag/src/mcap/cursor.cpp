// SPDX-License-Identifier: Apache-2.0
#include "cursor.hpp"

#include <endian.h>

#include <cstring>
#include <utility>

namespace tocsin::mcap {

Span Cursor::take(std::uint64_t size) {
  if (!good_ || size > left()) {
    good_ = false;
    return {};
  }
  const Span taken{bytes_.data + at_, static_cast<std::size_t>(size)};
  at_ += taken.size;
  return taken;
}

std::uint64_t Cursor::number(std::size_t size) {
  const Span bytes = take(size);
  std::uint64_t value = 0;
  if (bytes.size > 0) std::memcpy(&value, bytes.data, bytes.size);
  return le64toh(value);
}

std::string Cursor::text() {
  const Span bytes = take(number(4));
  return bytes.size == 0 ? std::string()
                         : std::string(reinterpret_cast<const char*>(bytes.data), bytes.size);
}

}  // namespace tocsin::mcap
