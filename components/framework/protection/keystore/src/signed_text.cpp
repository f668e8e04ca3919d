// SPDX-License-Identifier: Apache-2.0
#include "signed_text.hpp"

#include <openssl/pkcs7.h>
#include <openssl/x509_vfy.h>

#include "bio.hpp"
#include "foundation/error.hpp"

namespace tocsin::keystore {
namespace {

using Pkcs7 = std::unique_ptr<PKCS7, Freed<PKCS7, PKCS7_free>>;
using Store = std::unique_ptr<X509_STORE, Freed<X509_STORE, X509_STORE_free>>;

constexpr int flags = PKCS7_DETACHED | PKCS7_TEXT;

Store store_of(X509& authority, std::int64_t now_s) {
  Store store(X509_STORE_new());
  X509_STORE_add_cert(store.get(), &authority);
  X509_VERIFY_PARAM_set_time(X509_STORE_get0_param(store.get()), now_s);
  return store;
}

/// Lines end as MIME wants them, or the signature is one of another text.
std::string without_carriage_returns(const std::string& text) {
  std::string plain;
  for (const char c : text) {
    if (c != '\r') plain += c;
  }
  return plain;
}

}  // namespace

std::string sign(const std::string& text, const Authority& authority) {
  const Bio in = memory_of(text);
  const Pkcs7 signature(
      PKCS7_sign(authority.certificate.get(), authority.key.get(), nullptr, in.get(), flags));
  const Bio out = memory();
  BIO_reset(in.get());
  if (!signature || SMIME_write_PKCS7(out.get(), signature.get(), in.get(), flags) != 1) {
    throw EnvironmentError("signature: " + openssl_error());
  }
  return text_of(*out);
}

std::optional<std::string> verified(const std::string& document, X509& authority,
                                    std::int64_t now_s) {
  BIO* content = nullptr;
  const Pkcs7 signature(SMIME_read_PKCS7(memory_of(document).get(), &content));
  // Of text in memory PKCS7_verify makes a stream of its own, which OpenSSL 3.0 does not free when
  // the signature is of no known kind; behind a buffer it does not see that it is in memory.
  const Bio in(content == nullptr ? nullptr : BIO_push(BIO_new(BIO_f_buffer()), content));
  const Bio out = memory();
  const Store store = store_of(authority, now_s);
  const bool good = signature && PKCS7_verify(signature.get(), nullptr, store.get(), in.get(),
                                              out.get(), PKCS7_TEXT) == 1;
  if (!good) return std::nullopt;
  return without_carriage_returns(text_of(*out));
}

}  // namespace tocsin::keystore
