// SPDX-License-Identifier: Apache-2.0
#include "decision/policy_model.hpp"

#include <sstream>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/spelling.hpp"

namespace tocsin::decision {
namespace {

Density law(const char* which, const std::string& name, const std::vector<double>& values,
            Normal normal) {
  const auto family = family_from(name);
  std::ostringstream text;
  text << "policy." << which;
  if (!family) {
    text << "_family: '" << name << "' is not one of:";
    std::vector<std::string> known;
    for (const Family one : all_families()) known.emplace_back(to_string(one));
    text << ' ' << joined(known, " ") << suggestion(known, name);
    throw ConfigError(text.str());
  }
  if (values.empty() && *family == Family::normal) {
    return Density(*family, {normal.mean, normal.sd, 0});
  }
  if (values.size() != parameter_names(*family).size()) {
    text << "_parameters: " << values.size() << " numbers, " << name << " has";
    for (const char* parameter : parameter_names(*family)) text << ' ' << parameter;
    throw ConfigError(text.str());
  }
  Density::Parameters parameters{};
  std::copy(values.begin(), values.end(), parameters.begin());
  return Density(*family, parameters);
}

bool both_normal(const Density& a, const Density& b) {
  return a.family() == Family::normal && b.family() == Family::normal;
}

Normal normal_of(const Density& law) { return {law.parameters()[0], law.parameters()[1]}; }

Llr ratio(const Density& good, const Density& bad, double clip) {
  if (both_normal(good, bad)) return NormalLlr(normal_of(good), normal_of(bad), clip);
  return DensityLlr(good, bad, clip);
}

}  // namespace

Density good_law_of(const PolicyParams& p) {
  return law("good", p.good_family, p.good_parameters, {p.good_mean, p.good_sd});
}

Density bad_law_of(const PolicyParams& p) {
  return law("bad", p.bad_family, p.bad_parameters, {p.bad_mean, p.bad_sd});
}

Llr llr_of(const PolicyParams& p) { return ratio(good_law_of(p), bad_law_of(p), p.llr_clip); }

StepLaw step_law_of(const PolicyParams& p, const Density& truth) {
  const Density good = good_law_of(p);
  const Density bad = bad_law_of(p);
  if (!both_normal(good, bad) || !both_normal(good, truth)) return step_law(llr_of(p), truth);
  const NormalLlr llr(normal_of(good), normal_of(bad), p.llr_clip);
  return step_law(llr, p.llr_clip, normal_of(truth));
}

StepLaw reverse_step_law_of(const PolicyParams& p, const Density& truth) {
  const Density good = good_law_of(p);
  const Density bad = bad_law_of(p);
  if (!both_normal(good, bad) || !both_normal(good, truth)) {
    return reverse_step_law(llr_of(p), truth);
  }
  const NormalLlr llr(normal_of(good), normal_of(bad), p.llr_clip);
  return reverse_step_law(llr, p.llr_clip, normal_of(truth));
}

double false_alarm_samples_of(const PolicyParams& p) {
  if (p.false_alarm_samples > 0) return p.false_alarm_samples;
  return mean_run_length(step_law_of(p, good_law_of(p)), p.alpha, p.llr_clip == 0);
}

double alpha_of(const PolicyParams& p) {
  if (!(p.false_alarm_samples > 0)) return p.alpha;
  return alpha_for_run_length(step_law_of(p, good_law_of(p)), p.false_alarm_samples,
                              p.llr_clip == 0);
}

double reverse_alpha_of(const PolicyParams& p) {
  if (!(p.false_resume_samples > 0)) return p.reverse_alpha;
  return alpha_for_run_length(reverse_step_law_of(p, bad_law_of(p)), p.false_resume_samples,
                              p.llr_clip == 0);
}

}  // namespace tocsin::decision
