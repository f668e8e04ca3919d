// SPDX-License-Identifier: Apache-2.0
#include "terminal/line.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>

#include "foundation/printable.hpp"

namespace tocsin::terminal {
namespace {

const char* start_of(Style style) {
  constexpr std::array sequences{"", "\x1b[1m", "\x1b[32m", "\x1b[33m", "\x1b[31m", "\x1b[2m"};
  return sequences[static_cast<std::size_t>(style)];
}

std::size_t width_of(const Line& line) {
  return std::accumulate(
      line.begin(), line.end(), std::size_t{0},
      [](std::size_t sum, const Span& span) { return sum + terminal::width_of(span.text); });
}

/// The last element of the highest rank; the end when all have rank 0.
template <class Iterator, class Rank>
Iterator least(Iterator first, Iterator last, Rank rank) {
  Iterator found = last;
  int highest = 0;
  for (; first != last; ++first) {
    if (rank(*first) == 0 || rank(*first) < highest) continue;
    highest = rank(*first);
    found = first;
  }
  return found;
}

Line cut_at(Line line, std::size_t width) {
  Line shown;
  std::size_t left = width;
  for (Span& span : line) {
    const std::size_t wanted = terminal::width_of(span.text);
    // Where text follows that finds no room, its mark needs a column of this span.
    const bool last = &span == &line.back();
    if (wanted < left || (wanted == left && last)) {
      left -= wanted;
      shown.push_back(std::move(span));
      continue;
    }
    span.text = cut(wanted == left ? span.text + ">" : span.text, left);
    shown.push_back(std::move(span));
    break;
  }
  return shown;
}

}  // namespace

Line fit(Line line, std::size_t width) {
  for (Span& span : line) span.text = printable(span.text);
  while (width_of(line) > width) {
    const auto gone = least(line.begin(), line.end(), [](const Span& one) { return one.rank; });
    if (gone == line.end()) return cut_at(std::move(line), width);
    line.erase(gone);
  }
  return line;
}

std::string to_text(const Line& line, std::size_t width, bool colour) {
  std::string text;
  for (const Span& span : fit(line, width)) {
    const bool styled = colour && span.style != Style::plain;
    text += styled ? start_of(span.style) + span.text + "\x1b[0m" : span.text;
  }
  return text;
}

void Table::add(std::vector<Cell> cells) {
  assert(cells.size() == columns_.size());
  for (Cell& cell : cells) cell.text = printable(cell.text);
  rows_.push_back(std::move(cells));
}

std::vector<std::size_t> Table::widths() const {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    std::size_t widest = std::max(columns_[i].least, terminal::width_of(columns_[i].head));
    for (const auto& row : rows_) widest = std::max(widest, terminal::width_of(row[i].text));
    all.push_back(widest);
  }
  return all;
}

/// The columns that are shown, in their order. Those of rank 0 always are.
std::vector<std::size_t> Table::chosen(const std::vector<std::size_t>& widths,
                                       std::size_t width) const {
  std::vector<std::size_t> shown(columns_.size());
  std::iota(shown.begin(), shown.end(), std::size_t{0});
  const auto total = [&] {
    std::size_t sum = shown.size() - 1;  // a blank between two columns
    for (const std::size_t column : shown) sum += widths[column];
    return sum;
  };
  while (total() > width) {
    const auto gone = least(shown.begin(), shown.end(),
                            [this](std::size_t column) { return columns_[column].rank; });
    if (gone == shown.end()) break;
    shown.erase(gone);
  }
  return shown;
}

std::vector<Line> Table::lines(std::size_t width) const {
  std::vector<std::size_t> sizes = widths();
  const std::vector<std::size_t> shown = chosen(sizes, width);
  std::size_t others = 0;
  for (const std::size_t column : shown) others += column == elastic_ ? 0 : sizes[column] + 1;
  constexpr std::size_t shortest = 8;  // of the elastic column; narrower, lines are cut
  const std::size_t left = std::max(shortest, width - std::min(width, others));
  sizes[elastic_] = std::min(sizes[elastic_], left);
  const auto line_of = [&](const auto& cell_of) {
    Line line;
    for (const std::size_t column : shown) {
      const Cell cell = cell_of(column);
      const std::string blank = column == shown.front() ? "" : " ";
      line.push_back(
          {blank + padded(cell.text, sizes[column], columns_[column].align), cell.style});
    }
    return line;
  };
  std::vector<Line> all;
  all.push_back(line_of([&](std::size_t column) {
    return Cell{columns_[column].head, Style::bold};
  }));
  for (const auto& row : rows_) {
    all.push_back(line_of([&row](std::size_t column) { return row[column]; }));
  }
  return all;
}

}  // namespace tocsin::terminal
