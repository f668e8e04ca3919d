// SPDX-License-Identifier: Apache-2.0
#include "navigation/pgm.hpp"

#include <algorithm>
#include <cctype>
#include <optional>

#include "foundation/error.hpp"

namespace tocsin::navigation {
namespace {

constexpr int max_side = 100'000;
constexpr std::int64_t max_pixels = 25'000'000;

class PgmReader {
 public:
  PgmReader(const std::string& bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  GrayImage read() {
    const std::string magic = bytes_.substr(0, 2);
    if (magic != "P5" && magic != "P2") fail("is not a PGM image (P5 or P2)");
    at_ = 2;
    GrayImage image;
    image.width = header("width", max_side);
    image.height = header("height", max_side);
    image.max = header("maximum", 255);
    const std::int64_t count = std::int64_t{image.width} * image.height;
    if (count > max_pixels) fail("has " + std::to_string(count) + " pixels, more than 25 million");
    image.pixels = magic == "P5" ? binary(static_cast<std::size_t>(count))
                                 : text(static_cast<std::size_t>(count), image.max);
    check(image);
    return image;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw ConfigError(file_ + ": " + what); }

  void skip_space_and_comments() {
    while (at_ < bytes_.size()) {
      if (bytes_[at_] == '#') {
        at_ = std::min(bytes_.find('\n', at_), bytes_.size());
      } else if (std::isspace(static_cast<unsigned char>(bytes_[at_])) != 0) {
        ++at_;
      } else {
        return;
      }
    }
  }

  std::optional<int> number() {
    skip_space_and_comments();
    const std::size_t start = at_;
    int value = 0;
    while (at_ < bytes_.size() && bytes_[at_] >= '0' && bytes_[at_] <= '9' && value <= max_side) {
      value = value * 10 + (bytes_[at_++] - '0');
    }
    if (at_ == start) return std::nullopt;
    return value;
  }

  int header(const char* name, int max) {
    const auto value = number();
    if (!value || *value < 1 || *value > max) {
      fail(std::string("bad PGM header: ") + name + " is not in [1, " + std::to_string(max) + "]");
    }
    return *value;
  }

  std::vector<std::uint8_t> binary(std::size_t count) {
    ++at_;  // exactly one white space ends the header
    const std::size_t have = at_ < bytes_.size() ? bytes_.size() - at_ : 0;
    if (have < count) fail_truncated(have, count);
    const auto first = bytes_.begin() + static_cast<std::ptrdiff_t>(at_);
    return {first, first + static_cast<std::ptrdiff_t>(count)};
  }

  std::vector<std::uint8_t> text(std::size_t count, int max) {
    std::vector<std::uint8_t> pixels;
    while (pixels.size() < count) {
      const auto value = number();
      if (!value) fail_truncated(pixels.size(), count);
      if (*value > max) fail("pixel " + std::to_string(*value) + " is above the maximum");
      pixels.push_back(static_cast<std::uint8_t>(*value));
    }
    return pixels;
  }

  [[noreturn]] void fail_truncated(std::size_t have, std::size_t want) const {
    fail("is truncated: " + std::to_string(have) + " pixels of " + std::to_string(want));
  }

  void check(const GrayImage& image) const {
    const auto brightest = *std::max_element(image.pixels.begin(), image.pixels.end());
    if (brightest > image.max) fail("pixel " + std::to_string(brightest) + " is above the maximum");
  }

  const std::string& bytes_;
  const std::string& file_;
  std::size_t at_ = 0;
};

}  // namespace

GrayImage parse_pgm(const std::string& bytes, const std::string& file) {
  return PgmReader(bytes, file).read();
}

}  // namespace tocsin::navigation
