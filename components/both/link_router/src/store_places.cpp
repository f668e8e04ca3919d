// SPDX-License-Identifier: Apache-2.0
#include "store_places.hpp"

#include <string>

namespace tocsin {
namespace {

std::string store_folder(const Context& context, const std::string& directory) {
  if (!directory.empty() || context.run_dir.empty()) return directory;
  return context.run_dir + "/" + to_string(context.role) + "/store";
}

sample_log::LogLimits limits(int bytes, double age_s) {
  return {static_cast<std::uint64_t>(bytes), seconds(age_s)};
}

}  // namespace

BackfillLink::Params backfill_params(const Context& context,
                                     const LinkRouterComponent::Params& params) {
  using sample_log::LogUse;
  const std::string folder = store_folder(context, params.store_directory);
  const std::string history = folder.empty() ? "" : folder + "/history";
  return {{folder, limits(params.store_bytes, params.store_age_s), LogUse::queue},
          {history, limits(params.history_bytes, params.history_age_s), LogUse::history},
          params.link};
}

}  // namespace tocsin
