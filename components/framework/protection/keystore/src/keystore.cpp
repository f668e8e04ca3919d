// SPDX-License-Identifier: Apache-2.0
#include "keystore/keystore.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "certificates.hpp"
#include "documents.hpp"
#include "files.hpp"
#include "foundation/error.hpp"
#include "foundation/folder_lock.hpp"
#include "foundation/joined.hpp"
#include "foundation/printable.hpp"
#include "foundation/replace_file.hpp"
#include "foundation/spelling.hpp"
#include "keystore/enclave.hpp"
#include "revocations.hpp"
#include "signed_text.hpp"

namespace tocsin::keystore {
namespace {

namespace fs = std::filesystem;
using namespace enclave_file;

constexpr const char* ca_certificate = "/public/ca.cert.pem";
constexpr const char* ca_key = "/private/ca.key.pem";
constexpr const char* crl = "/public/crl.pem";
constexpr const char* enclaves = "/enclaves/";

void write(const std::string& path, const std::string& text) {
  if (const auto error = replace_file(path, text)) {
    throw EnvironmentError(path + ": cannot be written: " + error.message());
  }
}

/// Readable by its owner only from its first byte on.
void write_secret(const std::string& path, const std::string& text) {
  const mode_t before = umask(077);
  const auto error = replace_file(path, text);
  umask(before);
  if (error) throw EnvironmentError(path + ": cannot be written: " + error.message());
}

void make_folder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw EnvironmentError(path + ": cannot be made: " + error.message());
}

/// A folder that comes to its name whole or not at all, also when its maker is killed.
class NewFolder {
 public:
  /// What a killed maker has left is removed.
  explicit NewFolder(const std::string& path)
      : name_(fs::path(path + "/").parent_path()), now_(name_.string() + ".new") {
    remove(now_);
    make_folder(now_);
  }
  ~NewFolder() { remove(now_); }
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

  [[nodiscard]] std::string path() const { return now_; }
  /// Takes the place of what has the name now.
  void keep() {
    remove(name_);
    std::error_code error;
    fs::rename(now_, name_, error);
    if (error) throw EnvironmentError(name_.string() + ": cannot be made: " + error.message());
  }

 private:
  static void remove(const fs::path& path) {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  const fs::path name_;
  const fs::path now_;
};

void link(const std::string& target, const std::string& path) {
  std::error_code error;
  fs::remove(path, error);
  fs::create_symlink(target, path, error);
  if (error) throw EnvironmentError(path + ": cannot be made: " + error.message());
}

Certificate authority_certificate(const std::string& folder) {
  Certificate found = certificate_in(content_of(folder + ca_certificate).value_or(""));
  if (!found) {
    throw ConfigError(printable(folder) +
                      ": is no keystore (no certificate in public/ca.cert.pem)" +
                      "; `tocsin keystore create` makes one");
  }
  return found;
}

Authority authority_of(const std::string& folder) {
  Authority authority{authority_certificate(folder), nullptr};
  authority.key = key_in(content_of(folder + ca_key).value_or(""));
  if (!authority.key ||
      X509_check_private_key(authority.certificate.get(), authority.key.get()) != 1) {
    throw ConfigError(folder + ca_key +
                      ": is not the key of public/ca.cert.pem; identities are made where it is");
  }
  return authority;
}

void check_name(const std::string& name) {
  const auto allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
  if (name.empty() || !std::all_of(name.begin(), name.end(), allowed)) {
    throw ConfigError("identity '" + printable(name) +
                      "': allowed are letters, digits, '_' and '-'");
  }
}

Revocations revocations_of(const std::string& folder) {
  auto found = Revocations::in(content_of(folder + crl).value_or(""));
  if (!found) throw ConfigError(folder + crl + ": is no list of revocations");
  return std::move(*found);
}

bool is_revoked(const std::string& folder, const std::string& name) {
  const Certificate own =
      certificate_in(content_of(folder + enclaves + name + "/" + certificate).value_or(""));
  return own && revocations_of(folder).have(*own);
}

void sign_permissions(const std::string& own, const Permissions& allowed,
                      const Authority& authority) {
  const Certificate identity = certificate_at(own + certificate);
  const std::string xml = permissions_xml(
      {subject_of(*identity), valid_from(*identity), valid_until(*identity), allowed});
  write(own + "permissions.xml", xml);
  write(own + permissions, sign(xml, authority));
}

void link_shared_files(const std::string& own) {
  link("../../public/identity_ca.cert.pem", own + identity_ca);
  link("../../public/permissions_ca.cert.pem", own + permissions_ca);
  link("../../public/crl.pem", own + enclave_file::revocations);
  link("../governance.p7s", own + governance);
}

}  // namespace

void create(const std::string& folder, std::int64_t now_s) {
  constexpr int days = 3650;
  std::error_code absent;
  if (!fs::is_empty(folder, absent) && !absent) {
    throw ConfigError(printable(folder) + ": is not empty; a keystore is made in a new folder");
  }
  NewFolder made(folder);
  for (const char* part : {"/public", "/private", "/enclaves"}) make_folder(made.path() + part);
  fs::permissions(made.path() + "/private", fs::perms::owner_all);
  const Authority authority = make_authority("tocsin CA", now_s, days);
  write_secret(made.path() + ca_key, to_pem(*authority.key));
  write(made.path() + ca_certificate, to_pem(*authority.certificate));
  for (const char* purpose : {"identity_ca", "permissions_ca"}) {
    link("ca.cert.pem", made.path() + "/public/" + purpose + ".cert.pem");
    link("ca.key.pem", made.path() + "/private/" + purpose + ".key.pem");
  }
  write(made.path() + crl, Revocations().signed_pem(authority, now_s));
  write(made.path() + enclaves + "governance.xml", governance_xml());
  write(made.path() + enclaves + governance, sign(governance_xml(), authority));
  made.keep();
}

void add(const std::string& folder, const NewIdentity& identity, std::int64_t now_s) {
  check_name(identity.name);
  const Authority authority = authority_of(folder);
  const FolderLock lock(folder + enclaves);
  const std::string own = folder + enclaves + identity.name + "/";
  if (fs::exists(own + certificate) && !is_revoked(folder, identity.name)) {
    throw ConfigError("identity '" + identity.name + "' is there already, in " + printable(own) +
                      "; `permit` gives it other permissions, `revoke` ends it");
  }
  NewFolder made(own);
  const Key secret = make_key();
  const Certificate issued =
      make_certificate("/" + identity.name, *secret, authority, now_s, identity.days);
  const std::string path = made.path() + "/";
  write_secret(path + key, to_pem(*secret));
  write(path + certificate, to_pem(*issued));
  link_shared_files(path);
  sign_permissions(path, identity.permissions, authority);
  made.keep();
}

void permit(const std::string& folder, const std::string& name, const Permissions& allowed) {
  const std::string own = enclave_folder(folder, name);
  const Authority authority = authority_of(folder);
  const FolderLock lock(folder + enclaves);
  sign_permissions(own + "/", allowed, authority);
}

void revoke(const std::string& folder, const std::string& name, std::int64_t now_s) {
  const std::string own = enclave_folder(folder, name);
  const Authority authority = authority_of(folder);
  const FolderLock lock(folder + enclaves);
  Revocations list = revocations_of(folder);
  const Certificate revoked = certificate_at(own + "/" + certificate);
  if (list.have(*revoked)) throw ConfigError("identity '" + name + "' is revoked already");
  list.add(*revoked, now_s);
  write(folder + crl, list.signed_pem(authority, now_s));
}

std::vector<std::string> names_in(const std::string& folder) {
  (void)authority_certificate(folder);
  std::vector<std::string> names;
  std::error_code absent;
  for (const auto& entry : fs::directory_iterator(folder + enclaves, absent)) {
    const bool whole = entry.path().extension() != ".new";
    if (whole && fs::exists(entry.path() / certificate)) names.push_back(entry.path().filename());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string enclave_folder(const std::string& folder, const std::string& name) {
  const auto names = names_in(folder);
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw ConfigError("no identity '" + printable(name) + "' in " + printable(folder) +
                      "; there are: [" + joined(names) + "]" + suggestion(names, name));
  }
  return folder + enclaves + name;
}

}  // namespace tocsin::keystore
