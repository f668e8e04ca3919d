// SPDX-License-Identifier: Apache-2.0
#include "fragments.hpp"

#include <algorithm>

namespace tocsin::rtps_filter {
namespace {

constexpr std::size_t most_open = 64;

Prefix prefix_in(const std::uint8_t* packet) {
  Prefix prefix;
  std::copy_n(packet + header_bytes - prefix.size(), prefix.size(), prefix.begin());
  return prefix;
}

void append(std::vector<std::uint8_t>& message, const std::uint8_t* bytes, std::size_t size) {
  message.insert(message.end(), bytes, bytes + size);
}

void append_number(std::vector<std::uint8_t>& message, std::uint32_t number, unsigned bytes,
                   bool little) {
  for (unsigned i = 0; i < bytes; ++i) {
    const unsigned shift = 8 * (little ? i : bytes - 1 - i);
    message.push_back(static_cast<std::uint8_t>(number >> shift));
  }
}

/// The message of a whole sample: who speaks, to whom, and one DATA until its end.
std::vector<std::uint8_t> whole_message(const Submessage& submessage, const Data& data,
                                        const Place& place) {
  constexpr std::uint8_t little = 1;
  constexpr std::uint8_t flag_qos = 2;
  constexpr std::uint8_t flag_data = 4;
  constexpr std::uint8_t flag_key = 8;
  constexpr std::size_t ids_and_number = 4 + 4 + 8;
  std::vector<std::uint8_t> message;
  append(message, place.packet, header_bytes);
  if (place.destination != nullptr) {
    message.insert(message.end(), {kind::info_dst, little, 12, 0});
    append(message, place.destination, Prefix().size());
  }
  const auto order = static_cast<std::uint8_t>(submessage.flags & little);
  const bool has_qos = data.inline_qos.left() > 0;
  const std::uint8_t flags = static_cast<std::uint8_t>(order | (has_qos ? flag_qos : 0) |
                                                       (data.has_key ? flag_key : flag_data));
  message.insert(message.end(), {kind::data, flags, 0, 0, 0, 0});
  const std::uint8_t octets_to_inline_qos = 16;
  message.push_back(order != 0 ? octets_to_inline_qos : std::uint8_t{0});
  message.push_back(order != 0 ? std::uint8_t{0} : octets_to_inline_qos);
  append(message, submessage.content.here() + 2 + 2, ids_and_number);
  append(message, data.inline_qos.here(), data.inline_qos.left());
  append(message, data.payload.here(), data.payload.left());
  return message;
}

}  // namespace

bool Fragments::full() const { return open_.size() >= most_open; }

Fragments::Samples::iterator Fragments::sample_of(const Data& data, const std::uint8_t* packet) {
  const Prefix prefix = prefix_in(packet);
  const auto found = std::find_if(open_.begin(), open_.end(), [&](const Sample& sample) {
    return sample.prefix == prefix && sample.writer == data.writer && sample.number == data.number;
  });
  const bool fits = found != open_.end() && found->shape.size == data.fragments.size &&
                    found->shape.sample == data.fragments.sample;
  if (fits) return found;
  if (rule_ == Rule::hide_last && (found != open_.end() || full())) return open_.end();
  if (found != open_.end()) open_.erase(found);  // its writer begins anew
  if (full()) open_.pop_front();
  Sample sample;
  sample.prefix = prefix;
  sample.writer = data.writer;
  sample.number = data.number;
  sample.shape = data.fragments;
  const std::uint32_t size = data.fragments.size;
  sample.there.resize((data.fragments.sample + size - 1) / size);
  sample.payload.resize(data.fragments.sample);
  return open_.insert(open_.end(), std::move(sample));
}

void Fragments::store(Sample& sample, const Data& data) {
  const std::size_t begin = std::size_t{data.fragments.first - 1} * data.fragments.size;
  const std::size_t bytes = std::min(std::size_t{data.fragments.count} * data.fragments.size,
                                     sample.payload.size() - begin);
  std::copy_n(data.payload.here(), bytes, sample.payload.data() + begin);
  std::fill_n(sample.there.begin() + static_cast<std::ptrdiff_t>(data.fragments.first - 1),
              data.fragments.count, true);
  if (data.inline_qos.left() > 0) {
    sample.inline_qos.assign(data.inline_qos.here(),
                             data.inline_qos.here() + data.inline_qos.left());
  }
}

FragmentFate Fragments::add(const Submessage& submessage, const Data& data, const Place& place) {
  const auto sample = sample_of(data, place.packet);
  if (sample == open_.end()) return {};
  store(*sample, data);
  if (std::find(sample->there.begin(), sample->there.end(), false) != sample->there.end()) {
    return {rule_ == Rule::hide_all, std::nullopt};
  }
  Data whole = data;
  whole.inline_qos =
      Cursor(sample->inline_qos.data(), sample->inline_qos.size(), data.inline_qos.little());
  whole.payload = Cursor(sample->payload.data(), sample->payload.size(), true);
  FragmentFate fate{true, whole_message(submessage, whole, place)};
  open_.splice(open_.end(), open_, sample);
  // What is not good stays complete, so that its fragments stay hidden.
  if (rule_ == Rule::hide_all) open_.pop_back();
  return fate;
}

std::vector<std::uint8_t> as_fragments(const std::vector<std::uint8_t>& whole,
                                       const Data::Fragments& fragment) {
  constexpr std::size_t submessage_header = 4;
  constexpr std::size_t ids_and_number = 4 + 4 + 8;
  constexpr std::uint8_t flag_key_of_data = 8;
  constexpr std::uint8_t flag_key_of_fragment = 4;
  constexpr std::uint8_t octets_to_inline_qos = 28;
  const std::size_t begin =
      header_bytes + (whole[header_bytes] == kind::info_dst ? submessage_header + 12 : 0);
  const std::uint8_t flags = whole[begin + 1];
  const bool little = (flags & 1U) != 0;
  const bool key = (flags & flag_key_of_data) != 0;
  std::vector<std::uint8_t> message(whole.begin(),
                                    whole.begin() + static_cast<std::ptrdiff_t>(begin));
  const auto new_flags =
      static_cast<std::uint8_t>((flags & 3U) | (key ? flag_key_of_fragment : 0U));
  message.insert(message.end(), {kind::data_frag, new_flags, 0, 0, 0, 0});
  message.push_back(little ? octets_to_inline_qos : std::uint8_t{0});
  message.push_back(little ? std::uint8_t{0} : octets_to_inline_qos);
  const std::uint8_t* ids = whole.data() + begin + submessage_header + 2 + 2;
  append(message, ids, ids_and_number);
  const std::uint32_t count = (fragment.sample + fragment.size - 1) / fragment.size;
  append_number(message, 1, 4, little);
  append_number(message, count, 2, little);
  append_number(message, fragment.size, 2, little);
  append_number(message, fragment.sample, 4, little);
  const std::uint8_t* rest = ids + ids_and_number;
  append(message, rest, static_cast<std::size_t>(whole.data() + whole.size() - rest));
  return message;
}

}  // namespace tocsin::rtps_filter
