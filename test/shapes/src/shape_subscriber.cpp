// SPDX-License-Identifier: Apache-2.0
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

#include "shape_bus.hpp"
#include "shape_publisher.hpp"
#include "shapes/shape_cache.hpp"

namespace tocsin::shapes {
namespace {

constexpr Duration read_look = std::chrono::milliseconds(10);

/// The reader of one topic: keeps what comes until it is asked.
class Reader : private Receiver {
 public:
  Reader(Bus& bus, const ShapeOptions& options, std::string topic)
      : options_(options),
        topic_(std::move(topic)),
        filter_(ShapeFilter::of(options)),
        cache_(options.qos) {
    say("Create topic: " + topic_);
    say("Create reader for topic: " + topic_);
    subscription_ = bus.subscribe(shape_endpoint(topic_.c_str()), *this);
  }
  ~Reader() override { subscription_.reset(); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  void print(Time now) {
    std::vector<Sample> samples;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      samples = options_.reads ? cache_.read(now) : cache_.take(now);
    }
    for (const Sample& sample : samples) print(sample, now);
  }

 private:
  void receive(const Sample& sample) override {
    const Shape shape = shape_of(*static_cast<const ShapeType*>(sample.message.get()));
    if (!filter_.passes(shape)) return;
    add(sample);
  }
  void instance_ended(const Sample& sample) override { add(sample); }
  void add(const Sample& sample) {
    const auto writer = subscription_ ? subscription_->writer(sample.source) : std::nullopt;
    const std::lock_guard<std::mutex> lock(mutex_);
    cache_.add(sample, writer ? seconds(writer->lifespan_s) : Duration::max());
  }
  void print(const Sample& sample, Time now) {
    if (sample.message) {
      const Shape shape = shape_of(*static_cast<const ShapeType*>(sample.message.get()));
      colors_[sample.instance] = shape.color;
      std::string line = sample_line(topic_, shape);
      if (options_.stamps) {
        line +=
            stamps_text(sample.received.time_since_epoch().count(), now.time_since_epoch().count());
      }
      return say(line);
    }
    const char* const state = sample.state == InstanceState::disposed
                                  ? "NOT_ALIVE_DISPOSED_INSTANCE_STATE"
                                  : "NOT_ALIVE_NO_WRITERS_INSTANCE_STATE";
    const auto color = colors_.find(sample.instance);
    if (color != colors_.end()) say(instance_line(topic_, color->second, state));
  }

  const ShapeOptions& options_;
  const std::string topic_;
  const ShapeFilter filter_;
  std::map<std::uint64_t, std::string> colors_;
  std::mutex mutex_;
  ShapeCache cache_;
  std::unique_ptr<Subscription> subscription_;
};

}  // namespace

void subscribe(const ShapeOptions& options, const std::function<bool()>& is_over) {
  const auto bus = make_shape_bus(options);
  std::deque<Reader> readers;
  for (int i = 0; i < options.topics; ++i) {
    readers.emplace_back(*bus, options, numbered(options.topic, i));
  }
  EventPrinter events;
  Time next = bus->now();
  for (int i = 0; !is_over() && (options.iterations == 0 || i < options.iterations);) {
    events.look(*bus);
    if (bus->now() >= next) {
      for (Reader& reader : readers) reader.print(bus->now());
      next = bus->now() + seconds(options.read_period_s);
      ++i;
    }
    std::this_thread::sleep_for(
        std::min<Duration>(read_look, std::max(next - bus->now(), Duration{0})));
  }
}

}  // namespace tocsin::shapes
