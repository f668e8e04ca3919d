// SPDX-License-Identifier: Apache-2.0
#include "keystore/signature.hpp"

#include <openssl/sha.h>

#include <algorithm>
#include <array>
#include <deque>

#include "certificates.hpp"
#include "files.hpp"
#include "foundation/error.hpp"
#include "keystore/enclave.hpp"
#include "revocations.hpp"

namespace tocsin::keystore {
namespace {

using DigestContext = std::unique_ptr<EVP_MD_CTX, Freed<EVP_MD_CTX, EVP_MD_CTX_free>>;

Bytes der_of(const X509& certificate) {
  Bytes bytes(static_cast<std::size_t>(std::max(0, i2d_X509(&certificate, nullptr))));
  unsigned char* at = bytes.data();
  if (!bytes.empty()) i2d_X509(&certificate, &at);
  return bytes;
}

Certificate certificate_of(const Bytes& der) {
  const unsigned char* at = der.data();
  return Certificate(d2i_X509(nullptr, &at, static_cast<long>(der.size())));
}

Key key_at(const std::string& path) {
  Key key = key_in(content_of(path).value_or(""));
  if (!key) throw ConfigError(path + ": is no private key in PEM");
  return key;
}

}  // namespace

std::uint64_t signer_id(const Bytes& certificate) {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> hash{};
  SHA256(certificate.data(), certificate.size(), hash.data());
  std::uint64_t id = 0;
  for (std::size_t i = 0; i < sizeof id; ++i) id = id << 8U | hash[i];
  return id;
}

struct Signer::State {
  Key key;
  Bytes certificate;
};

Signer::Signer(const std::string& enclave)
    : state_(std::make_unique<State>(
          State{key_at(enclave + "/" + enclave_file::key),
                der_of(*certificate_at(enclave + "/" + enclave_file::certificate))})) {}
Signer::~Signer() = default;
Signer::Signer(Signer&&) noexcept = default;

Bytes Signer::sign(const Bytes& message) const {
  const DigestContext digest(EVP_MD_CTX_new());
  std::size_t size = 0;
  if (EVP_DigestSignInit(digest.get(), nullptr, EVP_sha256(), nullptr, state_->key.get()) != 1 ||
      EVP_DigestSign(digest.get(), nullptr, &size, message.data(), message.size()) != 1) {
    return {};
  }
  Bytes signature(size);
  if (EVP_DigestSign(digest.get(), signature.data(), &size, message.data(), message.size()) != 1) {
    return {};
  }
  signature.resize(size);
  return signature;
}

const Bytes& Signer::certificate() const { return state_->certificate; }

struct SignatureCheck::State {
  struct Known {
    std::uint64_t id;
    Certificate certificate;
    std::string subject;
  };
  [[nodiscard]] const Known* find(std::uint64_t id) const {
    const auto found =
        std::find_if(known.begin(), known.end(), [id](const Known& one) { return one.id == id; });
    return found == known.end() ? nullptr : &*found;
  }
  Certificate authority;
  std::optional<Revocations> revoked;
  std::deque<Known> known;
};

SignatureCheck::SignatureCheck(const std::string& enclave) : state_(std::make_unique<State>()) {
  state_->authority = certificate_at(enclave + "/" + enclave_file::identity_ca);
  if (const auto list = content_of(enclave + "/" + enclave_file::revocations)) {
    state_->revoked = Revocations::in(*list);
  }
}
SignatureCheck::~SignatureCheck() = default;
SignatureCheck::SignatureCheck(SignatureCheck&&) noexcept = default;

bool SignatureCheck::learn(const Bytes& certificate, std::int64_t now_s) {
  const std::uint64_t id = signer_id(certificate);
  if (knows(id)) return true;
  Certificate one = certificate_of(certificate);
  if (!one || X509_verify(one.get(), X509_get0_pubkey(state_->authority.get())) != 1) return false;
  if (now_s < valid_from(*one) || now_s > valid_until(*one)) return false;
  if (state_->revoked && state_->revoked->have(*one)) return false;
  if (state_->known.size() == most_certificates) state_->known.pop_front();
  std::string subject = subject_of(*one);
  state_->known.push_back({id, std::move(one), std::move(subject)});
  return true;
}

bool SignatureCheck::knows(std::uint64_t id) const { return state_->find(id) != nullptr; }

std::optional<std::string> SignatureCheck::signer_of(const Bytes& message, const Bytes& signature,
                                                     std::uint64_t id) const {
  const State::Known* const signer = state_->find(id);
  if (signer == nullptr) return std::nullopt;
  const DigestContext digest(EVP_MD_CTX_new());
  EVP_PKEY* const key = X509_get0_pubkey(signer->certificate.get());
  const bool is_his =
      EVP_DigestVerifyInit(digest.get(), nullptr, EVP_sha256(), nullptr, key) == 1 &&
      EVP_DigestVerify(digest.get(), signature.data(), signature.size(), message.data(),
                       message.size()) == 1;
  return is_his ? std::optional(signer->subject) : std::nullopt;
}

}  // namespace tocsin::keystore
