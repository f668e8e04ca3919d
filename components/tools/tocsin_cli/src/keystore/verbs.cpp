// SPDX-License-Identifier: Apache-2.0
#include "verbs.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "foundation/error.hpp"
#include "keystore/enclave.hpp"
#include "keystore/keystore.hpp"
#include "runtime/middleware/link_permissions.hpp"

namespace tocsin::keystore_tool {
namespace {

constexpr std::int64_t day_s = 86'400;

Role role_of_identity(const Options& options) {
  return options.role.value_or(role_by_name(options.name));
}

keystore::Permissions permissions_of(const Options& options) {
  return link_permissions({role_of_identity(options), options.traffic_file});
}

std::string allowed_text(const keystore::Permissions& permissions) {
  return fmt::format("publishes {} topics, hears {}", permissions.publish.size(),
                     permissions.subscribe.size());
}

Answer create(const Options& options, std::int64_t now_s) {
  keystore::create(options.folder, now_s);
  return {fmt::format("made {0}; whoever has {0}/private makes identities: keep it here\n",
                      options.folder)};
}

Answer add(const Options& options, std::int64_t now_s) {
  const auto permissions = permissions_of(options);
  keystore::add(options.folder, {options.name, permissions, options.days}, now_s);
  return {fmt::format("made identity {} ({}: {}) in {}/enclaves/{}\n", options.name,
                      to_string(role_of_identity(options)), allowed_text(permissions),
                      options.folder, options.name)};
}

Answer permit(const Options& options) {
  const auto permissions = permissions_of(options);
  keystore::permit(options.folder, options.name, permissions);
  return {fmt::format("identity {} ({}) {}; it holds when its router starts\n", options.name,
                      to_string(role_of_identity(options)), allowed_text(permissions))};
}

Answer revoke(const Options& options, std::int64_t now_s) {
  keystore::revoke(options.folder, options.name, now_s);
  return {
      fmt::format("identity {} is revoked; give {}/public/crl.pem to every host as crl.pem of its "
                  "enclave, and start its router again\n",
                  options.name, options.folder)};
}

/// Days until it ends, or what is wrong first of all.
std::string state_of(const std::string& folder, std::int64_t now_s) {
  const auto problems = keystore::problems_of(folder, now_s);
  if (!problems.empty()) return problems.front();
  return fmt::format("{} days", (keystore::read_enclave(folder).valid_until_s - now_s) / day_s);
}

Answer list(const Options& options, std::int64_t now_s) {
  std::string text;
  for (const std::string& name : keystore::names_in(options.folder)) {
    const std::string folder = keystore::enclave_folder(options.folder, name);
    text += fmt::format("{:<16} {}\n", name, state_of(folder, now_s));
  }
  return {text.empty() ? "no identities; `tocsin keystore add NAME` makes one\n" : text};
}

Answer check(const Options& options, std::int64_t now_s) {
  Answer answer;
  std::size_t looked_at = 0;
  for (const std::string& name : keystore::names_in(options.folder)) {
    if (!options.name.empty() && name != options.name) continue;
    ++looked_at;
    for (const std::string& problem :
         keystore::problems_of(keystore::enclave_folder(options.folder, name), now_s)) {
      answer.text += problem + "\n";
      answer.code = 1;
    }
  }
  if (!options.name.empty() && looked_at == 0) {
    (void)keystore::enclave_folder(options.folder, options.name);  // says which there are
  }
  answer.text += fmt::format("{} identities looked at, {}\n", looked_at,
                             answer.code == 0 ? "all sound" : "problems above");
  return answer;
}

void declare_identity(CLI::App& verb, Options& options) {
  verb.add_option("NAME", options.name, "of the identity, as `enclave` of a host")->required();
  verb.add_option_function<std::string>(
          "--role", [&options](const std::string& role) { options.role = role_of(role); },
          "which side's topics it may send; else by its name: gcs and station are stations")
      ->check(CLI::IsMember({"uxv", "gcs"}));
  verb.add_option("--traffic", options.traffic_file,
                  "which topics cross the link; else the shipped traffic.yaml")
      ->check(CLI::ExistingFile);
}

}  // namespace

Role role_by_name(const std::string& name) {
  const bool station = name.rfind("gcs", 0) == 0 || name.rfind("station", 0) == 0;
  return station ? Role::gcs : Role::uxv;
}

void declare(CLI::App& app, Options& options) {
  app.require_subcommand(1);
  app.add_option("--keystore", options.folder, "its folder [keystore]");
  app.add_subcommand("create", "make a keystore with an authority of its own");
  auto* const add = app.add_subcommand("add", "make an identity");
  declare_identity(*add, options);
  add->add_option("--days", options.days, "it is valid for so long [3650]")
      ->check(CLI::Range(1, 36'500));
  declare_identity(*app.add_subcommand("permit", "sign its permissions anew, as traffic.yaml says"),
                   options);
  app.add_subcommand("revoke", "no host that has the new crl.pem hears it any more")
      ->add_option("NAME", options.name, "of the identity")
      ->required();
  app.add_subcommand("list", "its identities, and how long they are valid");
  app.add_subcommand("check", "what is wrong with its identities; exit code 1 if anything is")
      ->add_option("NAME", options.name, "only this one");
  for (CLI::App* const verb : app.get_subcommands({})) verb->fallthrough();
}

Answer run_verb(const std::string& verb, const Options& options, std::int64_t now_s) {
  if (verb == "create") return create(options, now_s);
  if (verb == "add") return add(options, now_s);
  if (verb == "permit") return permit(options);
  if (verb == "revoke") return revoke(options, now_s);
  if (verb == "list") return list(options, now_s);
  return check(options, now_s);
}

}  // namespace tocsin::keystore_tool
