// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "keystore/permissions.hpp"

namespace tocsin::keystore {

/// The files of one identity, as SROS2 names them.
namespace enclave_file {
inline constexpr const char* identity_ca = "identity_ca.cert.pem";
inline constexpr const char* permissions_ca = "permissions_ca.cert.pem";
inline constexpr const char* certificate = "cert.pem";
inline constexpr const char* key = "key.pem";
inline constexpr const char* governance = "governance.p7s";
inline constexpr const char* permissions = "permissions.p7s";
inline constexpr const char* revocations = "crl.pem";
}  // namespace enclave_file

/// What an enclave's files say.
struct Enclave {
  std::string subject;                     ///< of its certificate, RFC 2253: `CN=/uxv1`
  std::int64_t valid_until_s = 0;          ///< [s] since the Unix epoch
  std::optional<Permissions> permissions;  ///< nothing when the document cannot be read
};

/// Reads an enclave's folder. Throws ConfigError when its certificate cannot be read.
[[nodiscard]] Enclave read_enclave(const std::string& folder);

/// Why a participant with this identity cannot speak on a link, one line each that names the file;
/// empty: all is well. Fast DDS 2.9.1 gives no reason when it refuses an identity. Files are read,
/// signatures and dates verified at `now_s` [s since the Unix epoch].
[[nodiscard]] std::vector<std::string> problems_of(const std::string& folder, std::int64_t now_s);

}  // namespace tocsin::keystore
