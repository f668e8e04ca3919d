// SPDX-License-Identifier: Apache-2.0
// What link_hop loads into the router's own container.
#include "hop_message.hpp"
#include "runtime/component.hpp"
#include "runtime/component_entry.hpp"
#include "runtime/port.hpp"

namespace tocsin::bench {

class HopWriter final : public Component {
 public:
  struct Params {
    int octets = 56;
    double period_s = 0.02;
    template <class Visitor>
    void visit(Visitor& v) {
      v("octets", octets, {0, 1e6}, "[B] of each message");
      v("period_s", period_s, {0.001, 60}, "[s] between two of them");
    }
  };
  HopWriter(Context& context, const Params& params) : Component(context), params_(params) {
    wake_every(seconds(params.period_s));
  }
  void tick(Time) override {
    HopMessage message = hop_message(static_cast<std::size_t>(params_.octets), "own");
    if (params_.octets < 1000) {
      (void)small_.write(std::move(message));
    } else {
      (void)image_.write(std::move(message));
    }
  }

 private:
  struct Small {
    using Message = HopMessage;
    static constexpr TopicInfo info{"crossing/up", "stream", Scope::host};
  };
  struct Image {
    using Message = HopMessage;
    static constexpr TopicInfo info{"crossing/image", "stream", Scope::host};
  };
  Params params_;
  Output<Small> small_{*this};
  Output<Image> image_{*this};
};

}  // namespace tocsin::bench

TOCSIN_COMPONENT(tocsin::bench::HopWriter)
