// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <openssl/evp.h>
#include <openssl/x509.h>

#include <cstdint>
#include <memory>
#include <string>

namespace tocsin::keystore {

template <class T, void (*Free)(T*)>
struct Freed {
  void operator()(T* one) const { Free(one); }
};
using Key = std::unique_ptr<EVP_PKEY, Freed<EVP_PKEY, EVP_PKEY_free>>;
using Certificate = std::unique_ptr<X509, Freed<X509, X509_free>>;

/// Who signs.
struct Authority {
  Certificate certificate;
  Key key;
};

/// What fails in OpenSSL without a fault of the caller's throws EnvironmentError with its reason.
[[nodiscard]] Key make_key();
/// A certificate authority that signs itself.
[[nodiscard]] Authority make_authority(const std::string& common_name, std::int64_t now_s,
                                       int days);
[[nodiscard]] Certificate make_certificate(const std::string& common_name, EVP_PKEY& key,
                                           const Authority& authority, std::int64_t now_s,
                                           int days);

[[nodiscard]] std::string to_pem(X509& certificate);
[[nodiscard]] std::string to_pem(EVP_PKEY& key);
/// Null when the text is none.
[[nodiscard]] Certificate certificate_in(const std::string& pem);
/// Of a file. Throws ConfigError when it holds none.
[[nodiscard]] Certificate certificate_at(const std::string& path);
[[nodiscard]] Key key_in(const std::string& pem);

/// RFC 2253: `CN=/uxv1`.
[[nodiscard]] std::string subject_of(const X509& certificate);
/// [s] since the Unix epoch.
[[nodiscard]] std::int64_t valid_from(const X509& certificate);
[[nodiscard]] std::int64_t valid_until(const X509& certificate);

/// OpenSSL's last error in words.
[[nodiscard]] std::string openssl_error();

}  // namespace tocsin::keystore
