// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "certificates.hpp"

namespace tocsin::keystore {

/// A list of revoked certificates (RFC 5280), signed by the authority.
class Revocations {
 public:
  Revocations();
  /// Nothing when the text is none.
  [[nodiscard]] static std::optional<Revocations> in(const std::string& pem);
  void add(const X509& certificate, std::int64_t now_s);
  [[nodiscard]] bool have(const X509& certificate) const;
  /// Whether the authority has signed it.
  [[nodiscard]] bool is_signed_by(X509& authority) const;
  /// Signs it anew, valid for ten years.
  [[nodiscard]] std::string signed_pem(const Authority& authority, std::int64_t now_s);

 private:
  using List = std::unique_ptr<X509_CRL, Freed<X509_CRL, X509_CRL_free>>;
  explicit Revocations(List list) : list_(std::move(list)) {}
  List list_;
};

}  // namespace tocsin::keystore
