// SPDX-License-Identifier: Apache-2.0
#include "experiment/instrument.hpp"

#include <algorithm>

#include "runtime/component_entry.hpp"

namespace tocsin::experiment {

Instrument::Instrument(Context& context, const Params& params)
    : Component(context), params_(params) {
  if (params.listen) listen_to(topic::AllLinkTopics{});
  if (params.picture_hz > 0) pictures_ = std::make_unique<Output<topic::CameraImage>>(*this);
}

template <class... Topics>
void Instrument::listen_to(topic::List<Topics...>) {
  (heard_.push_back(bus().subscribe({Topics::info, &type_info<typename Topics::Message>()}, ear_)),
   ...);
}

void Instrument::tick(Time now) {
  if (!pictures_) return;
  if (now >= next_picture_) send_picture(now);
  wake_at(next_picture_);
}

void Instrument::send_picture(Time now) {
  next_picture_ = std::max(next_picture_, now) + seconds(1 / params_.picture_hz);
  // Sizes vary by a tenth to either side; multiples of the golden ratio spread them evenly.
  const double turns = static_cast<double>(sent_) * 0.6180339887498949;
  const double factor = 0.9 + 0.2 * (turns - static_cast<double>(static_cast<long>(turns)));
  topic::CameraImage::Message picture;
  picture.format("jpeg");
  picture.data().resize(static_cast<std::size_t>(params_.picture_bytes * factor));
  ++sent_;
  (void)pictures_->write(std::move(picture));
}

}  // namespace tocsin::experiment

TOCSIN_COMPONENT(tocsin::experiment::Instrument)
