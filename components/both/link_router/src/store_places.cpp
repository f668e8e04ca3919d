// SPDX-License-Identifier: Apache-2.0
#include "store_places.hpp"

namespace tocsin {
namespace {

std::string store_folder(const Context& context, const std::string& directory) {
  if (!directory.empty() || context.run_dir.empty()) return directory;
  return context.run_dir + "/" + to_string(context.role) + "/store";
}

}  // namespace

StorePlace store_place(const Context& context, const LinkRouterComponent::Params& params) {
  return {store_folder(context, params.store_directory),
          {static_cast<std::uint64_t>(params.store_bytes), seconds(params.store_age_s)}};
}

StorePlace history_place(const Context& context, const LinkRouterComponent::Params& params) {
  const std::string folder = store_folder(context, params.store_directory);
  return {folder.empty() ? "" : folder + "/history",
          {static_cast<std::uint64_t>(params.history_bytes), seconds(params.history_age_s)},
          sample_log::LogUse::history};
}

}  // namespace tocsin
