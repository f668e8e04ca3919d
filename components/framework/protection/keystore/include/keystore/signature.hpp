// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tocsin::keystore {

using Bytes = std::vector<std::uint8_t>;

/// Signs short messages with the key of an identity (ECDSA with SHA-256 for the keys that
/// `tocsin keystore` makes, FIPS 186-5). One thread at a time.
class Signer {
 public:
  /// Throws ConfigError when key or certificate of the enclave cannot be read.
  explicit Signer(const std::string& enclave);
  ~Signer();
  Signer(Signer&&) noexcept;

  /// Empty when OpenSSL refuses.
  [[nodiscard]] Bytes sign(const Bytes& message) const;
  /// Of this identity, DER: what a SignatureCheck must have seen.
  [[nodiscard]] const Bytes& certificate() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Checks signatures of identities of one keystore. One thread at a time.
class SignatureCheck {
 public:
  /// Certificates that are remembered; of more the one that was learned first is forgotten.
  static constexpr std::size_t most_certificates = 64;

  /// Reads the authority and the list of revocations of an enclave. Throws ConfigError when the
  /// authority cannot be read.
  explicit SignatureCheck(const std::string& enclave);
  ~SignatureCheck();
  SignatureCheck(SignatureCheck&&) noexcept;

  /// Learns a certificate (DER). False: it is none of the authority, not valid at `now_s`
  /// [s since the Unix epoch], or revoked.
  bool learn(const Bytes& certificate, std::int64_t now_s);
  /// Whether a certificate with these first bytes of its hash (signer_id) is known.
  [[nodiscard]] bool knows(std::uint64_t signer_id) const;
  /// The subject (RFC 2253: `CN=/gcs`) of the known certificate that has signed the message;
  /// nothing when none has.
  [[nodiscard]] std::optional<std::string> signer_of(const Bytes& message, const Bytes& signature,
                                                     std::uint64_t signer_id) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The first eight bytes of a certificate's SHA-256, big endian.
[[nodiscard]] std::uint64_t signer_id(const Bytes& certificate);

}  // namespace tocsin::keystore
