// SPDX-License-Identifier: Apache-2.0
#include "info_text.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <array>
#include <ctime>

#include "foundation/joined.hpp"
#include "foundation/printable.hpp"

namespace tocsin::bag_tool {
namespace {

constexpr std::int64_t ns_per_s = 1'000'000'000;
/// All lines of a list stand below its first one.
const std::string indent(19, ' ');

std::string seconds_text(std::int64_t ns) {
  return fmt::format("{}.{:09}", ns / ns_per_s, ns % ns_per_s);
}

/// In local time, as `ros2 bag` does.
std::string time_text(std::int64_t ns) {
  const std::time_t s = ns / ns_per_s;
  std::tm local{};
  localtime_r(&s, &local);
  return fmt::format("{:%b %e %Y %H:%M:%S}.{:09} ({})", local, ns % ns_per_s, seconds_text(ns));
}

std::string topic_text(const bag::Metadata::TopicCount& one) {
  return fmt::format("Topic: {} | Type: {} | Count: {} | Serialization Format: {}\n",
                     printable(one.topic.name), printable(one.topic.type), one.count,
                     printable(one.topic.serialization_format));
}

}  // namespace

std::string size_text(std::uint64_t bytes) {
  constexpr std::array units{"B", "KiB", "MiB", "GiB", "TiB"};
  auto size = static_cast<double>(bytes);
  std::size_t unit = 0;
  for (; size >= 1024 && unit + 1 < units.size(); ++unit) size /= 1024;
  return fmt::format("{:.{}f} {}", size, unit == 0 ? 0 : 1, units[unit]);
}

std::string damage_text(const mcap::Damage& damage) {
  std::vector<std::string> faults;
  if (damage.cut_at)
    faults.push_back(fmt::format("ends within a record at byte {}", *damage.cut_at));
  if (damage.no_summary) faults.emplace_back("has no summary");
  if (damage.chunks > 0) faults.push_back(fmt::format("{} chunks are damaged", damage.chunks));
  if (damage.messages > 0) {
    faults.push_back(
        fmt::format("{} messages are of channels that nobody declared", damage.messages));
  }
  return joined(faults);
}

std::string info_text(const bag::BagReader& reader) {
  const bag::Metadata& about = reader.about();
  const auto files = joined_of(
      about.files, [](const auto& file) { return printable(file.path); }, "\n" + indent);
  std::string text = fmt::format(
      "\nFiles:             {}\nBag size:          {}\nStorage id:        mcap\n"
      "Duration:          {}s\nStart:             {}\nEnd:               {}\n"
      "Messages:          {}\nTopic information: ",
      files, size_text(reader.size()), seconds_text(about.duration_ns), time_text(about.start_ns),
      time_text(about.start_ns + about.duration_ns), about.count);
  text += joined_of(about.topics, topic_text, indent);
  if (about.topics.empty()) text += "\n";
  for (const auto& [file, damage] : reader.damaged()) {
    text += fmt::format("Damaged:           {} {}; tocsin bag recover mends it\n", printable(file),
                        damage_text(damage));
  }
  return text;
}

}  // namespace tocsin::bag_tool
