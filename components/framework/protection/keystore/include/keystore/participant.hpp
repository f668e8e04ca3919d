// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace tocsin::keystore {

/// The first octets of the GUIDs of a participant with an identity: a bit that is set and 47 of the
/// SHA-256 of the subject of its certificate (DDS Security 1.1, table 52). A handshake verifies
/// them.
using GuidStart = std::array<std::uint8_t, 6>;
/// `identity`: its name in the keystore, such as `uxv1`, whose certificate is for `CN=/uxv1`.
[[nodiscard]] GuidStart guid_start_of(const std::string& identity);

/// The name under which a participant is known that calls itself the router of `host` and has
/// proved an identity: `host` when the identity has that name, or that name and a number below
/// 1000, such as `uxv1` of `uxv`; else the host's name and the identity's octets, which nobody else
/// can have.
[[nodiscard]] std::string proven_name(const std::string& host, const GuidStart& identity);

/// The same where the identity must have the host's name, without a number.
[[nodiscard]] std::string exact_name(const std::string& host, const GuidStart& identity);

}  // namespace tocsin::keystore
