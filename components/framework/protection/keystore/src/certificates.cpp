// SPDX-License-Identifier: Apache-2.0
#include "certificates.hpp"

#include <openssl/bio.h>
#include <openssl/bn.h>
#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/x509v3.h>

#include <array>
#include <ctime>

#include "bio.hpp"
#include "files.hpp"
#include "foundation/error.hpp"

namespace tocsin::keystore {
namespace {

void must(int result, const char* what) {
  if (result <= 0) throw EnvironmentError(std::string(what) + ": " + openssl_error());
}

void set_random_serial(X509& certificate) {
  constexpr int bits = 120;  // RFC 5280 section 4.1.2.2 allows 20 octets
  const std::unique_ptr<BIGNUM, Freed<BIGNUM, BN_free>> number(BN_new());
  must(BN_rand(number.get(), bits, BN_RAND_TOP_ONE, BN_RAND_BOTTOM_ANY), "serial number");
  must(BN_to_ASN1_INTEGER(number.get(), X509_get_serialNumber(&certificate)) != nullptr ? 1 : 0,
       "serial number");
}

void add_extension(X509& certificate, int kind, const char* value) {
  using Extension = std::unique_ptr<X509_EXTENSION, Freed<X509_EXTENSION, X509_EXTENSION_free>>;
  const Extension extension(X509V3_EXT_conf_nid(nullptr, nullptr, kind, value));
  must(extension ? 1 : 0, "extension");
  must(X509_add_ext(&certificate, extension.get(), -1), "extension");
}

Certificate unsigned_certificate(const std::string& common_name, EVP_PKEY& key, std::int64_t now_s,
                                 int days) {
  constexpr std::int64_t day_s = 86'400;
  Certificate certificate(X509_new());
  must(X509_set_version(certificate.get(), X509_VERSION_3), "version");
  set_random_serial(*certificate);
  X509_NAME* const name = X509_get_subject_name(certificate.get());
  must(X509_NAME_add_entry_by_txt(name, "CN", MBSTRING_UTF8,
                                  reinterpret_cast<const unsigned char*>(common_name.c_str()), -1,
                                  -1, 0),
       "common name");
  // The clocks of a vehicle and its station differ.
  ASN1_TIME_set(X509_getm_notBefore(certificate.get()), now_s - day_s);
  ASN1_TIME_set(X509_getm_notAfter(certificate.get()), now_s + days * day_s);
  must(X509_set_pubkey(certificate.get(), &key), "public key");
  return certificate;
}

std::int64_t seconds_of(const ASN1_TIME* time) {
  std::tm broken{};
  ASN1_TIME_to_tm(time, &broken);
  return timegm(&broken);
}

}  // namespace

Key make_key() {
  Key key(EVP_EC_gen("P-256"));
  must(key ? 1 : 0, "key");
  return key;
}

Authority make_authority(const std::string& common_name, std::int64_t now_s, int days) {
  Authority authority{nullptr, make_key()};
  authority.certificate = unsigned_certificate(common_name, *authority.key, now_s, days);
  X509& certificate = *authority.certificate;
  must(X509_set_issuer_name(&certificate, X509_get_subject_name(&certificate)), "issuer");
  add_extension(certificate, NID_basic_constraints, "critical,CA:TRUE");
  // Without digitalSignature OpenSSL 3 does not let it sign documents.
  add_extension(certificate, NID_key_usage, "critical,digitalSignature,keyCertSign,cRLSign");
  must(X509_sign(&certificate, authority.key.get(), EVP_sha256()), "signature");
  return authority;
}

Certificate make_certificate(const std::string& common_name, EVP_PKEY& key,
                             const Authority& authority, std::int64_t now_s, int days) {
  Certificate certificate = unsigned_certificate(common_name, key, now_s, days);
  must(X509_set_issuer_name(certificate.get(), X509_get_subject_name(authority.certificate.get())),
       "issuer");
  add_extension(*certificate, NID_basic_constraints, "critical,CA:FALSE");
  must(X509_sign(certificate.get(), authority.key.get(), EVP_sha256()), "signature");
  return certificate;
}

std::string to_pem(X509& certificate) {
  const Bio out = memory();
  must(PEM_write_bio_X509(out.get(), &certificate), "certificate");
  return text_of(*out);
}

std::string to_pem(EVP_PKEY& key) {
  const Bio out = memory();
  must(PEM_write_bio_PrivateKey(out.get(), &key, nullptr, nullptr, 0, nullptr, nullptr), "key");
  return text_of(*out);
}

Certificate certificate_in(const std::string& pem) {
  return Certificate(PEM_read_bio_X509(memory_of(pem).get(), nullptr, nullptr, nullptr));
}

Certificate certificate_at(const std::string& path) {
  Certificate found = certificate_in(content_of(path).value_or(""));
  if (!found) throw ConfigError(path + ": is no certificate in PEM");
  return found;
}

Key key_in(const std::string& pem) {
  return Key(PEM_read_bio_PrivateKey(memory_of(pem).get(), nullptr, nullptr, nullptr));
}

std::string subject_of(const X509& certificate) {
  const Bio out = memory();
  X509_NAME_print_ex(out.get(), X509_get_subject_name(&certificate), 0, XN_FLAG_RFC2253);
  return text_of(*out);
}

std::int64_t valid_from(const X509& certificate) {
  return seconds_of(X509_get0_notBefore(&certificate));
}

std::int64_t valid_until(const X509& certificate) {
  return seconds_of(X509_get0_notAfter(&certificate));
}

std::string openssl_error() {
  std::array<char, 256> text{"no reason given"};
  if (const auto code = ERR_peek_last_error()) ERR_error_string_n(code, text.data(), text.size());
  ERR_clear_error();
  return text.data();
}

}  // namespace tocsin::keystore
