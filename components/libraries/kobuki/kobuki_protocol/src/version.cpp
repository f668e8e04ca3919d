// SPDX-License-Identifier: Apache-2.0
#include "kobuki_protocol/version.hpp"

#include <tuple>

namespace tocsin::kobuki {
namespace {

Version make(unsigned major, unsigned minor, unsigned patch, std::uint16_t code) {
  return {static_cast<std::uint8_t>(major), static_cast<std::uint8_t>(minor),
          static_cast<std::uint8_t>(patch), code};
}

auto key(const Version& v) { return std::make_tuple(v.major, v.minor, v.patch); }

}  // namespace

bool operator<(const Version& a, const Version& b) { return key(a) < key(b); }
bool operator==(const Version& a, const Version& b) { return key(a) == key(b); }

std::string to_text(const Version& version) {
  return std::to_string(version.major) + "." + std::to_string(version.minor) + "." +
         std::to_string(version.patch);
}

Version hardware_from_old_code(std::uint16_t code) {
  if (code >= 10000) return make(code / 10000U, code / 100U % 100U, code % 100U, code);
  return make(code / 100U, code / 10U % 10U, code % 10U, code);
}

Version firmware_from_old_code(std::uint16_t code) {
  if (code == 123) return make(1, 0, 0, code);  // the factory firmware 1.0.0 says 123
  return hardware_from_old_code(code);
}

FirmwareSupport judge_firmware(const Version& firmware) {
  const Version stable{1, 1, 4, {}};
  const Version newest{1, 2, 0, {}};
  if (firmware.major != 1) return FirmwareSupport::refused;
  if (firmware == stable || firmware == newest) return FirmwareSupport::recommended;
  return newest < firmware ? FirmwareSupport::software_behind : FirmwareSupport::replace;
}

bool has_gains(const Version& firmware) { return !(firmware < Version{1, 2, 0, {}}); }

std::uint64_t feature_bits(const Version& firmware) {
  return Version{1, 0, 0, {}} < firmware ? 3 : 0;
}

}  // namespace tocsin::kobuki
