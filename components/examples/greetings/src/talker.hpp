// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "example_idl/topics.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"

namespace example {

/// Says the same text again and again, numbered.
class Talker final : public tocsin::Component {
 public:
  struct Params {
    std::string text = "hello";
    double period_s = 1;
    template <class Visitor>
    void visit(Visitor& v) {
      live(v)("text", text, "what is said");
      v("period_s", period_s, {0.01, 60}, "[s] between two greetings");
    }
  };
  Talker(tocsin::Context& context, const Params& params);
  /// The text may change while it talks.
  void set_parameters(const Params& params) { params_ = params; }
  void tick(tocsin::Time now) override;

 private:
  tocsin::Output<Greetings> greetings_{*this};
  Params params_;
  std::uint32_t said_ = 0;
};

}  // namespace example
