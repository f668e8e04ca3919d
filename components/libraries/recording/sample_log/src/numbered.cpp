// SPDX-License-Identifier: Apache-2.0
#include "numbered.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace tocsin::sample_log {

std::string numbered(const std::string& name, std::uint64_t number, const std::string& extension) {
  return fmt::format("{}.{:08}{}", name, number, extension);
}

std::optional<std::uint64_t> number_in(const std::string& file, const std::string& name,
                                       const std::string& extension) {
  const std::size_t around = name.size() + 1 + extension.size();
  if (file.size() <= around) return std::nullopt;
  const std::string digits = file.substr(name.size() + 1, file.size() - around);
  std::uint64_t number = 0;
  const auto end = digits.data() + digits.size();
  const auto read = std::from_chars(digits.data(), end, number);
  const bool whole = read.ec == std::errc() && read.ptr == end;
  return whole && numbered(name, number, extension) == file ? std::optional(number) : std::nullopt;
}

}  // namespace tocsin::sample_log
