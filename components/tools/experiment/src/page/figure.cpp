// SPDX-License-Identifier: Apache-2.0
#include "page/figure.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "foundation/error.hpp"
#include "report/gnuplot.hpp"
#include "report/statistics.hpp"

namespace tocsin::experiment {
namespace {

std::string number(double value) {
  if (!std::isfinite(value)) return "NaN";
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string row(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += number(value) + " ";
  return text + "\n";
}

/// gnuplot refuses to draw nothing.
bool any_finite(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

}  // namespace

Figure& Figure::axes(const std::string& x, const std::string& y) {
  if (!x.empty()) commands_ += "set xlabel " + report::gnuplot_text(x) + " noenhanced\n";
  commands_ += "set ylabel " + report::gnuplot_text(y) + " noenhanced\n";
  return *this;
}

Figure& Figure::with(const std::string& command) {
  commands_ += command + "\n";
  return *this;
}

std::string Figure::block(const std::string& rows) {
  const std::string name = "$data" + std::to_string(blocks_++);
  data_ += name + " << EOD\n" + rows + "EOD\n";
  return name;
}

Figure& Figure::line(const std::string& title, const std::vector<double>& y, double x_step) {
  if (!any_finite(y)) return *this;
  std::string rows;
  for (std::size_t i = 0; i < y.size(); ++i) rows += row({static_cast<double>(i) * x_step, y[i]});
  plots_.push_back(block(rows) + " using 1:2 with lines lw 2 lc " +
                   report::gnuplot_colour(colours_) +
                   (title.empty() ? " notitle" : " title " + report::gnuplot_text(title)));
  ++colours_;
  return *this;
}

Figure& Figure::band(const std::vector<double>& low, const std::vector<double>& high,
                     double x_step) {
  if (!any_finite(low) || !any_finite(high)) return *this;
  std::string rows;
  for (std::size_t i = 0; i < low.size() && i < high.size(); ++i) {
    rows += row({static_cast<double>(i) * x_step, low[i], high[i]});
  }
  plots_.push_back(block(rows) +
                   " using 1:2:3 with filledcurves fs transparent solid 0.18 "
                   "noborder lc " +
                   report::gnuplot_colour(colours_) + " notitle");
  return *this;
}

Figure& Figure::box(const std::string& label, const std::vector<double>& values) {
  std::vector<double> finite;
  for (const double value : values) {
    if (std::isfinite(value)) finite.push_back(value);
  }
  labels_.push_back(label);
  const auto place = static_cast<double>(labels_.size());
  if (finite.empty()) return *this;
  const auto at = [&](double share) { return report::percentile(finite, share); };
  const std::string name = block(row({place, at(0.25), at(0.05), at(0.95), at(0.75), at(0.5)}));
  plots_.push_back(name + " using 1:2:3:4:5:(0.5) with candlesticks lw 1.5 lc " +
                   report::gnuplot_colour(colours_) + " fs solid 0.25 notitle whiskerbars 0.5");
  plots_.push_back(name + " using 1:6:6:6:6:(0.5) with candlesticks lw 3 lc " +
                   report::gnuplot_colour(colours_) + " notitle");
  ++colours_;
  return *this;
}

Figure& Figure::interval(const std::string& label, double mean, double low, double high) {
  labels_.push_back(label);
  const auto place = static_cast<double>(labels_.size());
  if (!std::isfinite(mean)) return *this;
  const bool known = std::isfinite(low) && std::isfinite(high);
  const std::string name = block(row({place, mean, known ? low : mean, known ? high : mean}));
  plots_.push_back(name +
                   " using 1:2:3:4 with yerrorbars pt 7 ps 0.8 lw 2 lc rgb '#0072b2' "
                   "notitle");
  return *this;
}

Figure& Figure::categories(const std::vector<std::string>& labels) {
  labels_ = labels;
  return *this;
}

Figure& Figure::marks(const std::string& title, const std::vector<Estimate>& means, double shift) {
  std::string rows;
  for (std::size_t i = 0; i < means.size(); ++i) {
    const Estimate& one = means[i];
    if (!std::isfinite(one.mean)) continue;
    const bool known = std::isfinite(one.low);
    rows += row({static_cast<double>(i) + 1 + shift, one.mean, known ? one.low : one.mean,
                 known ? one.high : one.mean});
  }
  if (rows.empty()) return *this;
  plots_.push_back(block(rows) + " using 1:2:3:4 with yerrorbars pt 7 ps 0.8 lw 2 lc " +
                   report::gnuplot_colour(colours_) + " title " + report::gnuplot_text(title));
  ++colours_;
  return *this;
}

Figure& Figure::diagonal() {
  plots_.emplace_back("x with lines lw 1 dt 2 lc rgb '#999999' notitle");
  return *this;
}

Figure& Figure::points(const std::string& title, const std::vector<double>& x,
                       const std::vector<double>& y) {
  if (!any_finite(x) || !any_finite(y)) return *this;
  std::string rows;
  for (std::size_t i = 0; i < x.size() && i < y.size(); ++i) rows += row({x[i], y[i]});
  plots_.push_back(block(rows) + " using 1:2 with points pt 7 ps 0.8 lc " +
                   report::gnuplot_colour(colours_) +
                   (title.empty() ? " notitle" : " title " + report::gnuplot_text(title)));
  ++colours_;
  return *this;
}

std::string Figure::labels() const {
  if (labels_.empty()) return "";
  std::string text =
      "set xrange [0.3:" + number(static_cast<double>(labels_.size()) + 0.7) + "]\nset xtics (";
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    text += (i > 0 ? ", " : "") + report::gnuplot_text(labels_[i]) + " " + std::to_string(i + 1);
  }
  return text + ") noenhanced" + (labels_.size() > 5 ? " rotate by -30" : "") + "\nset rmargin 9\n";
}

std::string Figure::script() const {
  std::string plot = "plot ";
  for (std::size_t i = 0; i < plots_.size(); ++i) plot += (i > 0 ? ", \\\n  " : "") + plots_[i];
  if (plots_.empty()) plot += "[0:1] [0:1] 2 notitle";
  const std::string body = "set title " + report::gnuplot_text(title_) +
                           " noenhanced\nset grid lc rgb '#dddddd'\n"
                           "set key outside top center horizontal noenhanced\nset border 3\n"
                           "set tics nomirror\n" +
                           labels() + commands_ + plot + "\n";
  return "reset session\n" + data_ + "set terminal svg size 760,420 dynamic font 'sans,13' name " +
         report::gnuplot_text(name_) + "\nset output " + report::gnuplot_text(name_ + ".svg") +
         "\n" + body + "set terminal pngcairo size 1140,630 font 'sans,14'\nset output " +
         report::gnuplot_text(name_ + ".png") + "\n" + body + "unset output\n";
}

void draw(const std::vector<Figure>& figures, const std::string& folder) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::create_directories(folder, error);
  std::string script;
  for (const Figure& figure : figures) script += figure.script();
  const std::string path = folder + "/figures.gnuplot";
  std::ofstream file(path);
  file << script;
  file.close();
  if (!file) throw EnvironmentError(path + ": cannot be written (disk full?)");
  report::run_gnuplot(script, folder);
}

}  // namespace tocsin::experiment
