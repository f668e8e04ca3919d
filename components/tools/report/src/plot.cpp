// SPDX-License-Identifier: Apache-2.0
#include "report/plot.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <string>

#include "report/gnuplot.hpp"
#include "report/summary.hpp"

namespace tocsin::report {
namespace {

namespace fs = std::filesystem;

void write_series(const Recording& recording, const fs::path& folder) {
  std::ofstream qni(folder / "qni.dat");
  for (const Decision& decision : recording.decisions) {
    qni << decision.time_s - recording.begin_s << " " << decision.qni << "\n";
  }
  std::ofstream per(folder / "per.dat");
  for (const Quality& quality : recording.qualities) {
    per << quality.time_s - recording.begin_s << " " << quality.per_percent << "\n";
  }
}

/// A block for each side, in the order of the map: time, capacity [kbit/s], backlog [ms].
void write_routers(const Recording& recording, const fs::path& folder) {
  std::ofstream link(folder / "link.dat");
  for (const auto& [role, states] : recording.routers) {
    for (const RouterState& state : states) {
      link << state.time_s - recording.begin_s << " " << state.capacity_bytes_per_s * 8e-3 << " "
           << state.backlog_s * 1e3 << "\n";
    }
    link << "\n\n";
  }
}

/// A block of two columns for each class, in the order of the map.
void write_traffic(const Recording& recording, const fs::path& folder) {
  std::ofstream traffic(folder / "traffic.dat");
  for (const auto& [link_class, arrivals] : recording.arrivals) {
    const double bin_s = rate_bin_s(recording.begin_s, recording.end_s);
    double middle_s = bin_s / 2;
    for (const double rate : byte_rates(arrivals, recording.begin_s, recording.end_s)) {
      traffic << middle_s << " " << rate * 8e-3 << "\n";
      middle_s += bin_s;
    }
    traffic << "\n\n";
  }
}

std::string pause_boxes(const Recording& recording) {
  std::string text;
  for (const Interval& pause : pauses_of(recording)) {
    text += "set object rectangle from " + std::to_string(pause.begin_s - recording.begin_s) +
            ", graph 0 to " + std::to_string(pause.end_s - recording.begin_s) +
            ", graph 1 behind fillcolor rgb '#dddddd' fillstyle solid noborder\n";
  }
  return text;
}

/// One curve of link.dat, by the column of its values.
std::string link_line(std::size_t index, int column, const char* axes, std::size_t colour,
                      const std::string& title) {
  return "'link.dat' index " + std::to_string(index) + " using 1:" + std::to_string(column) +
         " axes " + axes + " with lines linewidth 1.5 linecolor " + gnuplot_colour(colour) +
         " title " + gnuplot_text(title);
}

bool has_capacity(const std::vector<RouterState>& states) {
  return std::any_of(states.begin(), states.end(), [](const RouterState& state) {
    return std::isfinite(state.capacity_bytes_per_s);
  });
}

/// [kbit/s] of all sides, sorted.
std::vector<double> capacities(const Recording& recording) {
  std::vector<double> all;
  for (const auto& [role, states] : recording.routers) {
    for (const RouterState& state : states) {
      if (std::isfinite(state.capacity_bytes_per_s))
        all.push_back(state.capacity_bytes_per_s * 8e-3);
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// The scale of the capacity, which a few high estimates, as of a run's first packets, do not
/// flatten: twice the 95th percentile where the highest is more. The label tells what is cut.
std::string capacity_axis(const Recording& recording) {
  const std::vector<double> sorted = capacities(recording);
  std::string label = "capacity [kbit/s]";
  std::string top = "*";
  if (!sorted.empty()) {
    const double shown = 2 * sorted[(sorted.size() - 1) * 95 / 100];
    if (shown > 0 && sorted.back() > shown) {
      top = std::to_string(shown);
      label += ", to " + std::to_string(std::llround(sorted.back()));
    }
  }
  return "set ylabel " + gnuplot_text(label) + "\nset yrange [0:" + top + "]\n";
}

/// The capacity of the sides that measured it, as pictures let the vehicle do, and the backlog of
/// both; empty without routers.
std::string link_panel(const Recording& recording) {
  if (recording.routers.empty()) return "";
  std::string curves;
  std::size_t index = 0;
  for (const auto& [role, states] : recording.routers) {
    const std::string title = std::string(to_string(role)) + " capacity";
    if (has_capacity(states))
      curves += link_line(index, 2, "x1y1", index == 0 ? 0 : 3, title) + ", ";
    ++index;
  }
  index = 0;
  for (const auto& [role, states] : recording.routers) {
    curves += (index > 0 ? ", " : "") +
              link_line(index, 3, "x1y2", 1 + index, std::string(to_string(role)) + " backlog");
    ++index;
  }
  return capacity_axis(recording) +
         "set y2label 'backlog [ms]'\nset y2range [0:*]\nset y2tics\nset ytics nomirror\nplot " +
         curves + "\nunset y2tics\nunset y2label\nset ytics mirror\n";
}

std::string traffic_lines(const Recording& recording) {
  std::string text = "plot ";
  std::size_t index = 0;
  for (const auto& [link_class, arrivals] : recording.arrivals) {
    if (index > 0) text += ", ";
    text += "'traffic.dat' index " + std::to_string(index) +
            " with lines linewidth 1.5 linecolor " + gnuplot_colour(index) + " title " +
            gnuplot_text(to_string(link_class));
    ++index;
  }
  return index > 0 ? text + "\n" : "";
}

int panel_count(const Recording& recording) { return recording.routers.empty() ? 2 : 3; }

std::string script(const Recording& recording) {
  const std::string policy =
      recording.decisions.empty() ? "" : ", policy " + recording.decisions.back().policy;
  std::string panels =
      "set multiplot layout " + std::to_string(panel_count(recording)) + ",1 title " +
      gnuplot_text("Mission " + recording.mission.name + policy + " (grey: paused)") +
      " noenhanced\n" + pause_boxes(recording) +
      "set xrange [0:" + std::to_string(recording.end_s - recording.begin_s) +
      "]\nset grid\nset lmargin 10\nset rmargin 28\nset key outside right\n"
      "set yrange [0:100]\nset ylabel 'QNI, PER [%]'\n"
      "plot 'qni.dat' with lines linewidth 1.5 linecolor " +
      gnuplot_colour(0) + " title 'QNI', 'per.dat' with lines linewidth 1.5 linecolor " +
      gnuplot_colour(1) + " title 'PER'\n" + link_panel(recording) +
      "set ylabel 'received [kbit/s]'\nset xlabel 'time [s]'\n"
      "set yrange [0.1:*]\nset logscale y\n" +
      traffic_lines(recording) + "unset multiplot\nunset logscale y\nreset\n";
  const std::string size = "1200," + std::to_string(400 * panel_count(recording));
  return "set terminal pngcairo size " + size + "\nset output '../plot.png'\n" + panels +
         "set terminal svg size " + size + " background '#ffffff'\nset output '../plot.svg'\n" +
         panels;
}

}  // namespace

void draw_plot(const Recording& recording) {
  const fs::path folder = fs::path(recording.folder) / "plot";
  fs::create_directories(folder);
  write_series(recording, folder);
  write_routers(recording, folder);
  write_traffic(recording, folder);
  const std::string commands = script(recording);
  std::ofstream(folder / "plot.gnuplot") << commands;
  run_gnuplot(commands, folder.string());
}

}  // namespace tocsin::report
