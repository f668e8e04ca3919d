// SPDX-License-Identifier: Apache-2.0
#include "keystore/enclave.hpp"

#include <sys/stat.h>

#include <functional>

#include "documents.hpp"
#include "files.hpp"
#include "foundation/error.hpp"
#include "revocations.hpp"
#include "signed_text.hpp"

namespace tocsin::keystore {
namespace {

/// Looks through one enclave, and notes what is wrong.
class Examination {
 public:
  Examination(std::string folder, std::int64_t now_s) : folder_(std::move(folder)), now_s_(now_s) {}

  std::vector<std::string> run() {
    const Certificate identity_ca = certificate(enclave_file::identity_ca);
    const Certificate permissions_ca = certificate(enclave_file::permissions_ca);
    const Certificate own = certificate(enclave_file::certificate);
    if (own) examine_key(*own);
    if (own && identity_ca) examine_identity(*own, *identity_ca);
    if (permissions_ca) examine_documents(*permissions_ca, own.get());
    return std::move(problems_);
  }

 private:
  [[nodiscard]] std::string path(const char* file) const { return folder_ + "/" + file; }
  void note(const char* file, const std::string& what) {
    problems_.push_back(path(file) + ": " + what);
  }
  std::optional<std::string> content(const char* file) {
    auto text = content_of(path(file));
    if (!text) note(file, "cannot be read");
    return text;
  }
  Certificate certificate(const char* file) {
    const auto text = content(file);
    if (!text) return nullptr;
    Certificate found = certificate_in(*text);
    if (!found) note(file, "is no certificate in PEM");
    if (found) examine_dates(file, valid_from(*found), valid_until(*found));
    return found;
  }
  void examine_dates(const char* file, std::int64_t from_s, std::int64_t until_s) {
    if (now_s_ < from_s) note(file, "is not valid before " + date_text(from_s));
    if (now_s_ > until_s) note(file, "has expired at " + date_text(until_s));
  }
  void examine_key(X509& own) {
    const auto text = content(enclave_file::key);
    if (!text) return;
    const Key key = key_in(*text);
    if (!key) return note(enclave_file::key, "is no private key in PEM");
    if (X509_check_private_key(&own, key.get()) != 1) {
      note(enclave_file::key, "is not the key of cert.pem");
    }
    struct stat facts {};
    if (stat(path(enclave_file::key).c_str(), &facts) == 0 && (facts.st_mode & 077U) != 0) {
      note(enclave_file::key, "can be read by others than its owner; allowed is mode 600");
    }
  }
  void examine_identity(X509& own, X509& authority) {
    if (X509_verify(&own, X509_get0_pubkey(&authority)) != 1) {
      note(enclave_file::certificate, "is not signed by identity_ca.cert.pem");
    }
    const auto text = content_of(path(enclave_file::revocations));
    if (!text) return;  // there need be none
    const auto list = Revocations::in(*text);
    if (!list || !list->is_signed_by(authority)) {
      return note(enclave_file::revocations, "is no list that identity_ca.cert.pem has signed");
    }
    if (list->have(own)) note(enclave_file::certificate, "is revoked");
  }
  void examine_documents(X509& authority, const X509* own) {
    (void)document(enclave_file::governance, authority);
    const auto text = document(enclave_file::permissions, authority);
    if (!text) return;
    const auto grant = grant_in(*text);
    if (!grant) return note(enclave_file::permissions, "has no grant with subject and validity");
    examine_dates(enclave_file::permissions, grant->from_s, grant->until_s);
    if (own != nullptr && grant->subject != subject_of(*own)) {
      note(enclave_file::permissions, "is for " + grant->subject + ", not for " + subject_of(*own));
    }
  }
  std::optional<std::string> document(const char* file, X509& authority) {
    const auto text = content(file);
    if (!text) return std::nullopt;
    auto plain = verified(*text, authority, now_s_);
    if (!plain) note(file, "is not signed by permissions_ca.cert.pem");
    return plain;
  }

  const std::string folder_;
  const std::int64_t now_s_;
  std::vector<std::string> problems_;
};

/// The text of a document whoever signed it; Examination asks who.
std::optional<Grant> grant_of(const std::string& document) {
  const std::size_t begin = document.find("<dds");  // a declaration before it is optional
  const std::size_t end = document.find("</dds>");
  if (begin == std::string::npos || end == std::string::npos || end < begin) return std::nullopt;
  return grant_in(document.substr(begin, end + std::string("</dds>").size() - begin));
}

}  // namespace

Enclave read_enclave(const std::string& folder) {
  const Certificate own = certificate_at(folder + "/" + enclave_file::certificate);
  const auto document = content_of(folder + "/" + enclave_file::permissions);
  const auto grant = document ? grant_of(*document) : std::nullopt;
  return {subject_of(*own), valid_until(*own),
          grant ? std::optional(grant->permissions) : std::nullopt};
}

std::vector<std::string> problems_of(const std::string& folder, std::int64_t now_s) {
  return Examination(folder, now_s).run();
}

}  // namespace tocsin::keystore
