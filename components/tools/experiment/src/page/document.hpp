// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "page/figure.hpp"
#include "page/html.hpp"

namespace tocsin::experiment {

/// The report while it is written: HTML with places for figures, and the figures.
class Document {
 public:
  void add(const std::string& html) { body_ += html; }
  void heading(int level, const std::string& text) { add(html::heading(level, text)); }
  /// `text` is HTML already.
  void paragraph(const std::string& text) { add(html::paragraph(text)); }
  void table(const std::vector<std::vector<std::string>>& rows) { add(html::table(rows)); }
  void figure(Figure figure, const std::string& caption);

  [[nodiscard]] const std::vector<Figure>& figures() const { return figures_; }
  /// The body with empty places for figures.
  [[nodiscard]] const std::string& text() const { return body_; }
  /// The body with the drawn figures of `folder` put in. Throws EnvironmentError when one is not
  /// there.
  [[nodiscard]] std::string body(const std::string& folder) const;

 private:
  std::string body_;
  std::vector<Figure> figures_;
};

}  // namespace tocsin::experiment
