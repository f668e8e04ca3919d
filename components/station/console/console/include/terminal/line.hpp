// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "terminal/text.hpp"

namespace tocsin::terminal {

/// How a piece of text looks; without colours all look alike.
enum class Style { plain, bold, good, warning, bad, old };

/// A piece of a line. Text of others may stand in it as it came.
struct Span {
  std::string text;
  Style style = Style::plain;
  int rank = 0;  ///< where there is no room, the highest rank goes first; 0 is cut, but never goes
};

/// One line of a screen, of any length.
using Line = std::vector<Span>;

/// The spans of `line` that fit in `width` columns: those of the highest rank are left out until
/// the others fit, from the right among equals; what is left is cut at the end. All text is
/// printable.
[[nodiscard]] Line fit(Line line, std::size_t width);

/// `fit(line, width)` as text; with colours as ANSI sequences, which take no columns.
[[nodiscard]] std::string to_text(const Line& line, std::size_t width, bool colour);

/// One cell of a table.
struct Cell {
  std::string text;
  Style style = Style::plain;
};

struct Column {
  std::string head;
  Align align = Align::left;
  int rank = 0;           ///< as of a Span: a column of rank 0 stays
  std::size_t least = 0;  ///< at least so wide, so that it does not move with its content
};

/// A table that gives up columns, and then letters of its elastic column, to fit a width.
class Table {
 public:
  /// `elastic` is the index of a column of rank 0.
  explicit Table(std::vector<Column> columns, std::size_t elastic = 0)
      : columns_(std::move(columns)), elastic_(elastic) {}
  /// `cells` has one for each column.
  void add(std::vector<Cell> cells);
  [[nodiscard]] std::size_t rows() const { return rows_.size(); }
  /// The head and one line for each row, each at most `width` columns wide.
  [[nodiscard]] std::vector<Line> lines(std::size_t width) const;

 private:
  [[nodiscard]] std::vector<std::size_t> widths() const;
  [[nodiscard]] std::vector<std::size_t> chosen(const std::vector<std::size_t>& widths,
                                                std::size_t width) const;

  std::vector<Column> columns_;
  std::size_t elastic_;
  std::vector<std::vector<Cell>> rows_;
};

}  // namespace tocsin::terminal
