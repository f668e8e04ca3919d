// SPDX-License-Identifier: Apache-2.0
#include "joint_report.hpp"

#include <fmt/format.h>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "quality_trace.hpp"

namespace tocsin::tools {
namespace {

std::vector<decision::JointIndexInput> readings(const std::string& path) {
  std::vector<decision::JointIndexInput> all;
  for (const auto& measured : read_measurements(path)) all.push_back(joint_input(measured));
  return all;
}

std::string list(const char* name, const std::vector<double>& values) {
  return fmt::format("{}: [{}]\n", name,
                     joined_of(values, [](double x) { return fmt::format("{:.4g}", x); }));
}

}  // namespace

decision::JointFit fit_joint_files(const std::string& good, const std::vector<std::string>& bad) {
  std::vector<std::vector<decision::JointIndexInput>> kinds;
  for (const std::string& path : bad) kinds.push_back(readings(path));
  try {
    return decision::fit_joint(readings(good), kinds);
  } catch (const ConfigError& error) {
    throw ConfigError(good + " (good), " + joined(bad) + " (bad): " + error.what());
  }
}

std::string joint_text(const decision::JointFit& fit, const std::string& origin) {
  const decision::JointIndexParams& p = fit.params;
  std::string text = fmt::format(
      "# {}\n# good and bad lie {:.2f} standard deviations apart; {:.0f} % of the correlations are "
      "chance\nquality_index: joint\n",
      origin, decision::JointIndex(p).distance(), 100 * fit.shrinkage);
  text += list("joint_center", p.joint_center) + list("joint_scale", p.joint_scale) +
          list("joint_fall", p.joint_fall) + list("joint_correlation", p.joint_correlation);
  return text +
         fmt::format("good_mean: {:.2f}\ngood_sd: {:.2f}\nbad_mean: {:.2f}\nbad_sd: {:.2f}\n",
                     fit.good.mean, fit.good.sd, fit.bad.mean, fit.bad.sd);
}

}  // namespace tocsin::tools
