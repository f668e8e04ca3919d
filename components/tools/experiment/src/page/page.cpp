// SPDX-License-Identifier: Apache-2.0
#include "page/page.hpp"

#include <cstdio>
#include <system_error>

#include "foundation/error.hpp"
#include "page/sections.hpp"
#include "results/result_store.hpp"

namespace tocsin::experiment {

int write_page(const std::string& folder) {
  const Results results = load_results(folder);
  Document document;
  add_overview(results, document);
  add_verdicts(results, document);
  add_recommendation(results, document);
  add_costs(results, document);
  add_fit(results, document);
  add_regimes(results, document);
  add_thesis(results, document);
  add_channels(results, document);
  add_distributions(results, document);
  add_comparisons(results, document);
  add_sensitivity(results, document);
  add_reality(results, document);
  add_definitions(results, document);
  add_settings(results, document);
  const std::string figures = folder + "/figures";
  draw(document.figures(), figures);
  const std::string path = folder + "/report.html";
  try {
    write_whole(path, html::page("Tocsin: policies compared", document.body(figures)));
  } catch (const std::system_error& error) {
    throw EnvironmentError(path + ": " + error.code().message());
  }
  std::printf("%s, %zu figures in %s\n", path.c_str(), document.figures().size(), figures.c_str());
  return 0;
}

}  // namespace tocsin::experiment
