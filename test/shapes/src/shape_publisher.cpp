// SPDX-License-Identifier: Apache-2.0
#include "shape_publisher.hpp"

#include <chrono>
#include <deque>
#include <memory>
#include <random>
#include <thread>

#include "shape_bus.hpp"

namespace tocsin::shapes {
namespace {

constexpr Duration look = std::chrono::milliseconds(10);

/// Looks at the ends while it waits.
void wait(Bus& bus, EventPrinter& events, double s, const std::function<bool()>& is_over) {
  const Time end = bus.now() + seconds(s);
  do {
    events.look(bus);
    std::this_thread::sleep_for(std::min<Duration>(look, std::max(end - bus.now(), Duration{0})));
  } while (bus.now() < end && !is_over());
}

/// One writer for each topic.
class Writers {
 public:
  Writers(Bus& bus, const ShapeOptions& options) : options_(options) {
    for (int i = 0; i < options.topics; ++i) {
      names_.push_back(numbered(options.topic, i));
      say("Create topic: " + names_.back());
      say("Create writer for topic: " + names_.back() + " color: " + options.color);
      writers_.push_back(bus.advertise(shape_endpoint(names_.back().c_str())));
    }
  }
  void write(const std::vector<Shape>& round) {
    for (std::size_t i = 0; i < writers_.size(); ++i) {
      for (const Shape& shape : round) {
        (void)writers_[i]->write(std::make_shared<const ShapeType>(message_of(shape)));
        if (options_.print_written) say(sample_line(names_[i], shape));
      }
    }
  }
  /// A writer that goes writes its instances no more; Fast DDS 2.9.1 sends and reports that only
  /// when they are unregistered.
  void end_instances() {
    const auto how = options_.final_state == FinalState::dispose ? InstanceState::disposed
                                                                 : InstanceState::no_writers;
    for (const auto& writer : writers_) {
      for (int i = 0; i < options_.instances; ++i) {
        Shape key;
        key.color = numbered(options_.color, i);
        (void)writer->end_instance(std::make_shared<const ShapeType>(message_of(key)), how);
      }
    }
  }

 private:
  const ShapeOptions& options_;
  std::deque<std::string> names_;  // whose addresses stay
  std::vector<std::unique_ptr<Publication>> writers_;
};

}  // namespace

void publish(const ShapeOptions& options, const std::function<bool()>& is_over) {
  constexpr double last_samples_s = 1;  // reliable readers may need repairs
  const auto bus = make_shape_bus(options);
  Writers writers(*bus, options);
  ShapeMotion motion(options, std::random_device{}());
  EventPrinter events;
  for (int i = 0; !is_over() && (options.iterations == 0 || i < options.iterations); ++i) {
    writers.write(motion.next());
    wait(*bus, events, options.write_period_s, is_over);
  }
  writers.end_instances();
  wait(*bus, events, last_samples_s, is_over);
}

}  // namespace tocsin::shapes
