// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "keystore/permissions.hpp"

/// Identities for DDS Security 1.1 (PKI-DH, Access-Permissions, AES-GCM-GMAC), in the layout of a
/// SROS2 keystore:
///
///     public/      ca.cert.pem and its two names, crl.pem
///     private/     ca.key.pem and its two names: stays on the computer that makes identities
///     enclaves/    governance.xml and .p7s; a folder for each identity
///
/// Every function throws ConfigError for what the caller gave, and while another process changes
/// the keystore, EnvironmentError when a file cannot be written. A keystore and an identity are
/// there whole or not at all.
namespace tocsin::keystore {

/// Makes a keystore with an authority of its own (EC P-256, 10 years) in a folder that is absent or
/// empty.
void create(const std::string& folder, std::int64_t now_s);

/// Makes an identity `/name`, valid for `days`, or makes that of a revoked name anew. The key never
/// leaves its folder. `name`: letters, digits, `_` and `-`.
struct NewIdentity {
  std::string name;
  Permissions permissions;
  int days = 3650;
};
void add(const std::string& folder, const NewIdentity& identity, std::int64_t now_s);

/// Signs new permissions for an identity that is there.
void permit(const std::string& folder, const std::string& name, const Permissions& permissions);

/// From now on nobody who has the new list of revocations (`crl.pem` of its enclave) hears this
/// identity.
void revoke(const std::string& folder, const std::string& name, std::int64_t now_s);

/// Names of all identities, sorted.
[[nodiscard]] std::vector<std::string> names_in(const std::string& folder);
/// The folder of an identity's files. Throws ConfigError with the choice when there is none.
[[nodiscard]] std::string enclave_folder(const std::string& folder, const std::string& name);

}  // namespace tocsin::keystore
