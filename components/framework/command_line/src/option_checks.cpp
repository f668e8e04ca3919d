// SPDX-License-Identifier: Apache-2.0
#include "command_line/option_checks.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "foundation/printable.hpp"
#include "foundation/spelling.hpp"

namespace tocsin {
namespace {

constexpr std::size_t longest_shown = 60;  // [byte] of a value

template <class IsAllowed>
CLI::Validator check(const IsAllowed& is_allowed, const char* allowed, const char* name) {
  return CLI::Validator(
      [is_allowed, allowed](const std::string& text) {
        if (is_allowed(text)) return std::string();
        return "'" + printable(text, longest_shown) + "' is not " + allowed;
      },
      name);
}

/// NaN unless all of `text` is a number.
double number_in(const std::string& text) {
  double number = 0;
  return CLI::detail::lexical_cast(text, number) ? number
                                                 : std::numeric_limits<double>::quiet_NaN();
}

/// The options of `app` and of the verb that was chosen.
std::vector<std::string> options_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* const option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  for (const CLI::App* const verb : app.get_subcommands()) {
    for (std::string& name : options_of(*verb)) names.push_back(std::move(name));
  }
  return names;
}

std::vector<std::string> verbs_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* const verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(verb->get_name());
  }
  return names;
}

bool is_option(const std::string& word) { return word.size() > 2 && word.rfind("--", 0) == 0; }

/// `--name` of `--name=value`.
std::string option_name(const std::string& word) { return word.substr(0, word.find('=')); }

}  // namespace

CLI::Validator at_least_zero() {
  return check([](const std::string& text) { return number_in(text) >= 0; },
               "a number from 0 upwards", "NONNEGATIVE");
}

CLI::Validator above_zero() {
  return check([](const std::string& text) { return number_in(text) > 0; }, "a number above 0",
               "POSITIVE");
}

CLI::Validator is_seed() {
  const auto is_allowed = [](const std::string& text) {
    int seed = 0;
    return CLI::detail::lexical_cast(text, seed) && seed >= 0;
  };
  return check(is_allowed, "a whole number from 0 to 2147483647", "SEED");
}

std::string usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<std::string> rest = app.remaining(true);
  for (const std::string& word : rest) {
    if (!is_option(word)) continue;
    const std::string like = suggestion(options_of(app), option_name(word));
    return printable(option_name(word), longest_shown) + ": there is no such option" +
           (like.empty() ? "; --help lists them" : like);
  }
  const auto verbs = verbs_of(app);
  if (rest.empty() || verbs.empty() || !app.get_subcommands().empty()) return error.what();
  return "'" + printable(rest.front(), longest_shown) + "' is not a verb" +
         did_you_mean(verbs, rest.front(), "the verbs are");
}

}  // namespace tocsin
