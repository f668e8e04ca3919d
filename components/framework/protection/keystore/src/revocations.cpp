// SPDX-License-Identifier: Apache-2.0
#include "revocations.hpp"

#include <openssl/pem.h>

#include "bio.hpp"
#include "foundation/error.hpp"

namespace tocsin::keystore {
namespace {

using Time = std::unique_ptr<ASN1_TIME, Freed<ASN1_TIME, ASN1_TIME_free>>;
using Revoked = std::unique_ptr<X509_REVOKED, Freed<X509_REVOKED, X509_REVOKED_free>>;
constexpr std::int64_t ten_years_s = 3650LL * 86'400;

}  // namespace

Revocations::Revocations() : list_(X509_CRL_new()) {
  X509_CRL_set_version(list_.get(), X509_CRL_VERSION_2);
}

std::optional<Revocations> Revocations::in(const std::string& pem) {
  List list(PEM_read_bio_X509_CRL(memory_of(pem).get(), nullptr, nullptr, nullptr));
  if (!list) return std::nullopt;
  return Revocations(std::move(list));
}

void Revocations::add(const X509& certificate, std::int64_t now_s) {
  Revoked one(X509_REVOKED_new());
  const Time now(ASN1_TIME_set(nullptr, now_s));
  X509_REVOKED_set_serialNumber(one.get(),
                                const_cast<ASN1_INTEGER*>(X509_get0_serialNumber(&certificate)));
  X509_REVOKED_set_revocationDate(one.get(), now.get());
  X509_CRL_add0_revoked(list_.get(), one.release());
  X509_CRL_sort(list_.get());
}

bool Revocations::have(const X509& certificate) const {
  X509_REVOKED* found = nullptr;
  return X509_CRL_get0_by_cert(list_.get(), &found, const_cast<X509*>(&certificate)) == 1;
}

bool Revocations::is_signed_by(X509& authority) const {
  return X509_CRL_verify(list_.get(), X509_get0_pubkey(&authority)) == 1;
}

std::string Revocations::signed_pem(const Authority& authority, std::int64_t now_s) {
  const Time begin(ASN1_TIME_set(nullptr, now_s - 86'400));  // clocks differ
  const Time end(ASN1_TIME_set(nullptr, now_s + ten_years_s));
  X509_CRL_set_issuer_name(list_.get(), X509_get_subject_name(authority.certificate.get()));
  X509_CRL_set1_lastUpdate(list_.get(), begin.get());
  X509_CRL_set1_nextUpdate(list_.get(), end.get());
  const Bio out = memory();
  if (X509_CRL_sign(list_.get(), authority.key.get(), EVP_sha256()) == 0 ||
      PEM_write_bio_X509_CRL(out.get(), list_.get()) != 1) {
    throw EnvironmentError("list of revocations: " + openssl_error());
  }
  return text_of(*out);
}

}  // namespace tocsin::keystore
