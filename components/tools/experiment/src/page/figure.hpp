// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "page/inference.hpp"

namespace tocsin::experiment {

/// A diagram made with gnuplot: data, how to draw it, and its axes.
class Figure {
 public:
  /// `name` is that of its file; `title` stands above it.
  Figure(std::string name, std::string title) : name_(std::move(name)), title_(std::move(title)) {}

  Figure& axes(const std::string& x, const std::string& y);
  /// More lines of gnuplot before the plot: ranges, scales.
  Figure& with(const std::string& command);
  /// A line through (i, y[i]) with `x_step` between; gaps where y is NaN. Empty title: no legend.
  Figure& line(const std::string& title, const std::vector<double>& y, double x_step);
  /// A shaded band in the colour of the next line.
  Figure& band(const std::vector<double>& low, const std::vector<double>& high, double x_step);
  /// One box of quartiles with whiskers from the 5th to the 95th percentile, at place `x`.
  Figure& box(const std::string& label, const std::vector<double>& values);
  /// A mean with its interval, at the next place on the x axis; NaN bounds: a point.
  Figure& interval(const std::string& label, double mean, double low, double high);
  /// Names on the x axis, for marks().
  Figure& categories(const std::vector<std::string>& labels);
  /// A mean with its interval at each category, `shift` to its right (of a distance of 1 between
  /// categories); those with a NaN mean are left out.
  Figure& marks(const std::string& title, const std::vector<Estimate>& means, double shift);
  /// Points (x[i], y[i]).
  Figure& points(const std::string& title, const std::vector<double>& x,
                 const std::vector<double>& y);

  /// The line on which y equals x.
  Figure& diagonal();

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::string& title() const { return title_; }
  /// The whole gnuplot program that writes `<name>.svg` and `.png`.
  [[nodiscard]] std::string script() const;

 private:
  [[nodiscard]] std::string block(const std::string& rows);
  [[nodiscard]] std::string labels() const;
  std::string name_;
  std::string title_;
  std::string commands_;
  std::string data_;
  std::vector<std::string> plots_;
  std::vector<std::string> labels_;
  int blocks_ = 0;
  std::size_t colours_ = 0;
};

/// Draws all figures into `folder` as name.svg and name.png. Throws EnvironmentError when gnuplot
/// is not there or fails.
void draw(const std::vector<Figure>& figures, const std::string& folder);

}  // namespace tocsin::experiment
