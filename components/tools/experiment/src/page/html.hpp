// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "page/inference.hpp"

namespace tocsin::experiment::html {

/// `text` with the characters that mean something in HTML replaced.
[[nodiscard]] std::string escape(const std::string& text);

[[nodiscard]] std::string heading(int level, const std::string& text);
/// `text` is HTML already.
[[nodiscard]] std::string paragraph(const std::string& text);
/// First row: heads. Cells are HTML already.
[[nodiscard]] std::string table(const std::vector<std::vector<std::string>>& rows);
/// Opens on a click.
[[nodiscard]] std::string details(const std::string& summary, const std::string& inner);
[[nodiscard]] std::string preformatted(const std::string& text);

/// Three significant digits, "-" for NaN.
[[nodiscard]] std::string number(double value);
/// "12.3 [11.8, 12.9]"; without the interval for one run.
[[nodiscard]] std::string number(const Estimate& estimate);

/// A whole page.
[[nodiscard]] std::string page(const std::string& title, const std::string& body);

}  // namespace tocsin::experiment::html
