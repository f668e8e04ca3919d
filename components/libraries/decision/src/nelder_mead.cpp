// SPDX-License-Identifier: Apache-2.0
#include "nelder_mead.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin::decision {
namespace {

using Point = std::vector<double>;
using Function = std::function<double(const Point&)>;

struct Vertex {
  Point x;
  double value;
};

class Simplex {
 public:
  Simplex(const Function& f, const Point& start) : f_(f) {
    add(start);
    for (std::size_t i = 0; i < start.size(); ++i) {
      Point x = start;
      x[i] += x[i] == 0 ? 0.1 : 0.05 * std::abs(x[i]);
      add(x);
    }
    sort();
  }

  void step() {
    const Point center = centroid();
    const Vertex reflected = towards(center, -1);
    if (reflected.value < best().value) {
      const Vertex expanded = towards(center, -2);
      worst() = expanded.value < reflected.value ? expanded : reflected;
    } else if (reflected.value < vertices_[vertices_.size() - 2].value) {
      worst() = reflected;
    } else {
      contract(center, reflected);
    }
    sort();
  }

  [[nodiscard]] bool small() const {
    for (std::size_t i = 0; i < best().x.size(); ++i) {
      const double spread = std::abs(vertices_.back().x[i] - best().x[i]);
      if (spread > 1e-9 * (1 + std::abs(best().x[i]))) return false;
    }
    return vertices_.back().value - best().value <= 1e-12 * (1 + std::abs(best().value));
  }
  [[nodiscard]] const Vertex& best() const { return vertices_.front(); }

 private:
  void add(const Point& x) { vertices_.push_back({x, f_(x)}); }
  Vertex& worst() { return vertices_.back(); }
  void sort() {
    std::stable_sort(vertices_.begin(), vertices_.end(),
                     [](const Vertex& a, const Vertex& b) { return a.value < b.value; });
  }
  [[nodiscard]] Point centroid() const {
    Point sum(best().x.size(), 0.0);
    for (std::size_t v = 0; v + 1 < vertices_.size(); ++v) {
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += vertices_[v].x[i];
    }
    for (double& x : sum) x /= static_cast<double>(vertices_.size() - 1);
    return sum;
  }
  /// From the center by `factor` of the way to the worst vertex.
  Vertex towards(const Point& center, double factor) {
    Point x = center;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += factor * (worst().x[i] - center[i]);
    return {x, f_(x)};
  }
  void contract(const Point& center, const Vertex& reflected) {
    const bool outside = reflected.value < worst().value;
    const Vertex contracted = towards(center, outside ? -0.5 : 0.5);
    if (contracted.value < std::min(reflected.value, worst().value)) {
      worst() = contracted;
    } else {
      shrink();
    }
  }
  void shrink() {
    for (std::size_t v = 1; v < vertices_.size(); ++v) {
      for (std::size_t i = 0; i < best().x.size(); ++i) {
        vertices_[v].x[i] = (vertices_[v].x[i] + best().x[i]) / 2;
      }
      vertices_[v].value = f_(vertices_[v].x);
    }
  }

  const Function& f_;
  std::vector<Vertex> vertices_;
};

}  // namespace

Minimum minimize(const Function& f, const Point& start) {
  constexpr int max_steps = 3000;
  Minimum minimum{start, 0, false};
  for (int round = 0; round < 2; ++round) {
    Simplex simplex(f, minimum.x);
    int step = 0;
    for (; step < max_steps && !simplex.small(); ++step) simplex.step();
    minimum = {simplex.best().x, simplex.best().value, step < max_steps};
  }
  return minimum;
}

}  // namespace tocsin::decision
