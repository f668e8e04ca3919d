// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::experiment {

/// Stands in for the recorder (`listen`) or for the camera (`picture_hz` above 0) of a simulated
/// run: reads and writes the same topics in the same process, so that the radio carries the same
/// packets, but touches no disk and draws no picture.
class Instrument final : public Component {
 public:
  struct Params {
    bool listen = false;
    double picture_hz = 0;
    int picture_bytes = 40000;
    template <class Visitor>
    void visit(Visitor& v) {
      v("listen", listen, "reads every link topic, and forgets it");
      v("picture_hz", picture_hz, {0, 30}, "[1/s] pictures; 0: none");
      v("picture_bytes", picture_bytes, {1000, 1000000}, "[byte] of a picture, +-10 %");
    }
  };
  Instrument(Context& context, const Params& params);
  void tick(Time now) override;

 private:
  /// A reader that wakes nobody.
  class Ear final : public Receiver {
   public:
    void receive(const Sample&) override {}
  };
  template <class... Topics>
  void listen_to(topic::List<Topics...>);
  void send_picture(Time now);

  Params params_;
  Ear ear_;
  std::vector<std::unique_ptr<Subscription>> heard_;
  std::unique_ptr<Output<topic::CameraImage>> pictures_;
  Time next_picture_{};
  std::uint64_t sent_ = 0;
};

}  // namespace tocsin::experiment
