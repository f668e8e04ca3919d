// SPDX-License-Identifier: Apache-2.0
#include "keystore/participant.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>
#include <openssl/x509.h>

#include <algorithm>
#include <memory>

#include "certificates.hpp"

namespace tocsin::keystore {
namespace {

using Name = std::unique_ptr<X509_NAME, Freed<X509_NAME, X509_NAME_free>>;
using Digest = std::array<unsigned char, EVP_MAX_MD_SIZE>;

/// Of the name as `make_certificate` writes it.
Digest digest_of_subject(const std::string& common_name) {
  const Name name(X509_NAME_new());
  Digest digest{};
  (void)X509_NAME_add_entry_by_txt(name.get(), "CN", MBSTRING_UTF8,
                                   reinterpret_cast<const unsigned char*>(common_name.c_str()), -1,
                                   -1, 0);
  (void)X509_NAME_digest(name.get(), EVP_sha256(), digest.data(), nullptr);
  return digest;
}

}  // namespace

GuidStart guid_start_of(const std::string& identity) {
  const Digest digest = digest_of_subject("/" + identity);
  GuidStart start{};
  unsigned before = 1;  // the bit that is set, then each octet's last one
  std::transform(digest.begin(), digest.begin() + start.size(), start.begin(),
                 [&before](unsigned char octet) {
                   const unsigned shifted = before << 7U | octet >> 1U;
                   before = octet & 1U;
                   return static_cast<std::uint8_t>(shifted);
                 });
  return start;
}

std::string proven_name(const std::string& host, const GuidStart& identity) {
  constexpr int numbers = 1000;
  std::string name = exact_name(host, identity);
  for (int number = 0; name != host && number < numbers; ++number) {
    if (guid_start_of(host + std::to_string(number)) == identity) name = host;
  }
  return name;
}

std::string exact_name(const std::string& host, const GuidStart& identity) {
  if (guid_start_of(host) == identity) return host;
  std::string octets;
  for (const std::uint8_t octet : identity) octets += fmt::format("{:02x}", octet);
  return host + "_of_" + octets;
}

}  // namespace tocsin::keystore
