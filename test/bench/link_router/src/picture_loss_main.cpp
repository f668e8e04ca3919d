// SPDX-License-Identifier: Apache-2.0
// Pictures over a link that loses each packet by itself, both ways: whole samples, as DDS divides
// them, beside pieces that are sent again so many times at most.
// usage: picture_loss [BYTES [PERIOD_MS [PICTURES]]]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "foundation/program.hpp"
#include "foundation/whole_number.hpp"
#include "link_router/wire_cost.hpp"
#include "router_radio.hpp"

namespace {

using namespace tocsin;
using namespace tocsin::bench;

constexpr Time begin{std::chrono::hours(1)};
constexpr router::StreamId camera = 1;
constexpr router::StreamId heartbeat = 2;
constexpr Duration heartbeat_period = std::chrono::milliseconds(200);

struct Setting {
  std::size_t bytes = 30000;
  Duration period = std::chrono::milliseconds(200);
  std::uint64_t pictures = 2000;
};

struct Variant {
  const char* name;
  bool whole;
  int repairs;
};
constexpr Variant variants[] = {{"whole", true, 0},
                                {"pieces", false, 0},
                                {"pieces, once again", false, 1},
                                {"pieces, twice again", false, 2}};

class PictureRun {
 public:
  PictureRun(const Setting& setting, const Variant& variant, double loss)
      : setting_(setting),
        channel_(lossy_channel(loss, 0.005), {}, 1, begin),
        routers_(channel_, setup(variant), begin) {
    if (variant.whole) routers_.sender(0).set_largest_piece(0);
    routers_.add_stream(0, camera, stream_rule("camera", TrafficClass::low), begin);
    routers_.add_stream(0, heartbeat, stream_rule("heartbeat", TrafficClass::critical), begin);
    sent_at_.resize(setting.pictures);
  }

  void run() {
    const Time end = begin + setting_.pictures * setting_.period + std::chrono::seconds(2);
    const auto deliver = [this](std::size_t, router::StreamId stream, const router::Origin& origin,
                                Time at) {
      if (stream == camera) {
        latencies_ms_.push_back(1e3 * to_seconds(at - sent_at_[origin.sequence - 1]));
      }
    };
    Time next_picture = begin;
    Time next_heartbeat = begin;
    std::uint64_t heartbeats = 0;
    for (Time now = begin; now < end;) {
      if (now >= next_heartbeat) {
        routers_.sender(0).offer(heartbeat, {{8, ++heartbeats, now}, 100, nullptr}, now);
        next_heartbeat += heartbeat_period;
      }
      if (now >= next_picture && pictures_ < setting_.pictures) {
        sent_at_[pictures_++] = now;
        routers_.sender(0).offer(camera, {{7, pictures_, now}, setting_.bytes, nullptr}, now);
        next_picture += setting_.period;
      }
      routers_.serve(now);
      const Time next = std::min(
          {next_picture < now ? end : next_picture, next_heartbeat, routers_.next_event(now), end});
      now = std::max(next, now + Duration{1});
      routers_.advance(now, deliver);
    }
  }

  void print(const char* name, double loss) {
    std::sort(latencies_ms_.begin(), latencies_ms_.end());
    const auto at = [this](double share) {
      if (latencies_ms_.empty()) return 0.0;
      return latencies_ms_[static_cast<std::size_t>(share *
                                                    static_cast<double>(latencies_ms_.size() - 1))];
    };
    const double once = static_cast<double>(setting_.pictures) *
                        static_cast<double>(router::wire_cost(setting_.bytes).packets);
    const double all = static_cast<double>(routers_.packets_of(camera));
    std::printf(
        "%5.1f %%  %-20s %9.1f %9.2f %9.1f %9.1f\n", 100 * loss, name,
        100 * static_cast<double>(latencies_ms_.size()) / static_cast<double>(setting_.pictures),
        all / once, at(0.5), at(0.99));
  }

 private:
  static RouterRadio::Setup setup(const Variant& variant) {
    RouterRadio::Setup setup;
    setup.params.low_repairs = variant.repairs;
    return setup;
  }

  const Setting setting_;
  radio::RadioChannel channel_;
  RouterRadio routers_;
  std::vector<Time> sent_at_;
  std::vector<double> latencies_ms_;
  std::uint64_t pictures_ = 0;
};

Setting setting_of(const std::vector<std::string>& words) {
  Setting setting;
  if (!words.empty()) setting.bytes = whole_number(words[0], "BYTES", 1, 65'000);
  if (words.size() > 1) {
    setting.period = std::chrono::milliseconds(whole_number(words[1], "PERIOD_MS", 1, 60'000));
  }
  if (words.size() > 2) setting.pictures = whole_number(words[2], "PICTURES", 1, 1'000'000);
  return setting;
}

}  // namespace

int main(int argc, char** argv) {
  return tocsin::run_program("picture_loss", [&] {
    const Setting setting = setting_of({argv + 1, argv + argc});
    std::printf("%zu bytes, %zu packets, every %.0f ms\n", setting.bytes,
                router::wire_cost(setting.bytes).packets, 1e3 * to_seconds(setting.period));
    std::printf("%7s  %-20s %9s %9s %9s %9s\n", "loss", "", "arrive %", "air x", "p50 ms",
                "p99 ms");
    for (const double loss : {0.01, 0.05, 0.1, 0.2}) {
      for (const Variant& variant : variants) {
        PictureRun run(setting, variant, loss);
        run.run();
        run.print(variant.name, loss);
      }
    }
    return 0;
  });
}
