// SPDX-License-Identifier: Apache-2.0
#include "page/document.hpp"

#include <fstream>
#include <sstream>

#include "foundation/error.hpp"

namespace tocsin::experiment {
namespace {

std::string place_of(const std::string& name) { return "<!-- figure " + name + " -->"; }

/// The <svg> element without the XML head.
std::string drawing(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  const std::string all = text.str();
  const std::size_t begin = all.find("<svg");
  if (begin == std::string::npos) throw EnvironmentError(path + ": gnuplot has not drawn it");
  return all.substr(begin);
}

}  // namespace

void Document::figure(Figure figure, const std::string& caption) {
  add("<figure>" + place_of(figure.name()) + "<figcaption>" + caption + "</figcaption></figure>\n");
  figures_.push_back(std::move(figure));
}

std::string Document::body(const std::string& folder) const {
  std::string text = body_;
  for (const Figure& figure : figures_) {
    const std::string place = place_of(figure.name());
    const std::string path = folder + "/" + figure.name() + ".svg";
    text.replace(text.find(place), place.size(), drawing(path));
  }
  return text;
}

}  // namespace tocsin::experiment
