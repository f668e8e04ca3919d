// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_01.hpp>
#include <cmath>
#include <random>
#include <utility>

#include "decision/design/link_model.hpp"

namespace tocsin::decision {
namespace {

/// Standard normal and uniform numbers of one seed. Boost's are the same with every compiler, and
/// its normal ones take half the time.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double normal() { return normal_(engine_); }
  double uniform() { return uniform_(engine_); }

 private:
  std::mt19937_64 engine_;
  boost::random::normal_distribution<double> normal_;
  boost::random::uniform_01<double> uniform_;
};

class Ar1Source final : public QualitySource {
 public:
  Ar1Source(const Ar1Link& model, std::uint64_t seed)
      : model_(model),
        fresh_(std::sqrt(1 - model.correlation * model.correlation)),
        random_(seed),
        z_(random_.normal()) {}
  double next() override {
    const double now = z_;
    z_ = model_.correlation * z_ + fresh_ * random_.normal();
    return std::clamp(model_.law.mean + model_.law.sd * now, 0.0, 100.0);
  }
  void restart() override { z_ = random_.normal(); }

 private:
  Ar1Link model_;
  double fresh_;
  Random random_;
  double z_;
};

class TwoStateSource final : public QualitySource {
 public:
  TwoStateSource(const TwoStateLink& model, std::uint64_t seed) : model_(model), random_(seed) {
    TwoStateSource::restart();
  }
  double next() override {
    const Normal& law = low_ ? model_.low : model_.high;
    const double quality = std::clamp(law.mean + law.sd * random_.normal(), 0.0, 100.0);
    if (random_.uniform() < (low_ ? model_.low_to_high : model_.high_to_low)) low_ = !low_;
    return quality;
  }
  void restart() override {
    low_ = random_.uniform() * (model_.high_to_low + model_.low_to_high) < model_.high_to_low;
  }

 private:
  TwoStateLink model_;
  Random random_;
  bool low_ = false;
};

/// The circular block bootstrap: blocks may run over the end of the recording to its begin.
class BlockSource final : public QualitySource {
 public:
  BlockSource(BlockLink model, std::uint64_t seed) : model_(std::move(model)), random_(seed) {}
  double next() override {
    if (left_ == 0) {
      const double size = static_cast<double>(model_.recording.size());
      at_ = static_cast<std::size_t>(random_.uniform() * size);
      left_ = model_.block;
    }
    --left_;
    const double quality = model_.recording[at_];
    at_ = at_ + 1 == model_.recording.size() ? 0 : at_ + 1;
    return quality;
  }
  void restart() override { left_ = 0; }

 private:
  BlockLink model_;
  Random random_;
  std::size_t at_ = 0;
  int left_ = 0;
};

struct MakeSource {
  std::uint64_t seed;
  std::unique_ptr<QualitySource> operator()(const Ar1Link& model) const {
    return std::make_unique<Ar1Source>(model, seed);
  }
  std::unique_ptr<QualitySource> operator()(const TwoStateLink& model) const {
    return std::make_unique<TwoStateSource>(model, seed);
  }
  std::unique_ptr<QualitySource> operator()(const BlockLink& model) const {
    return std::make_unique<BlockSource>(model, seed);
  }
};

}  // namespace

std::unique_ptr<QualitySource> source_of(const LinkModel& model, std::uint64_t seed) {
  return std::visit(MakeSource{seed}, model);
}

}  // namespace tocsin::decision
