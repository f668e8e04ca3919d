// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "bag/bag_writer.hpp"
#include "idl_support/encode.hpp"
#include "mcap/reader.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::archive {

inline constexpr std::int64_t second_ns = 1'000'000'000;
/// 29 November 2026, noon.
inline constexpr std::int64_t noon_ns = 1'795'953'600 * second_ns;

/// A bag of a vehicle that drives along x with 1 m/s and measures its link each second.
class SmallBag {
 public:
  explicit SmallBag(const std::filesystem::path& folder, std::int64_t from_ns = noon_ns)
      : from_ns_(from_ns), writer_(made(folder), {mcap::Compression::zstd, 0, 0}) {}

  template <class Topic>
  void write(const typename Topic::Message& message, double at_s, std::uint32_t sequence) {
    const std::string name = std::string("rt/") + Topic::info.name;
    const auto& type = type_info<typename Topic::Message>();
    const auto [topic, is_new] = topics_.try_emplace(name, 0);
    if (is_new) topic->second = writer_.add(bag::make_topic(name, type.name));
    const auto bytes = encode(type, &message);
    const auto at_ns = from_ns_ + static_cast<std::int64_t>(at_s * 1e9);
    (void)writer_.write(topic->second, {sequence, at_ns, at_ns, bytes.data(), bytes.size(), 1});
  }
  void locate(double x_m, double at_s, std::uint32_t sequence) {
    topic::Location::Message location;
    location.pose().pose().position().x(x_m);
    write<topic::Location>(location, at_s, sequence);
  }
  void measure(float signal_dbm, double at_s, std::uint32_t sequence) {
    topic::NetworkQuality::Message quality;
    quality.signal_dbm(signal_dbm);
    quality.per_percent(5);
    write<topic::NetworkQuality>(quality, at_s, sequence);
  }
  /// So many seconds.
  void drive(int seconds) {
    for (int i = 0; i < seconds; ++i) {
      const auto sequence = static_cast<std::uint32_t>(i + 1);
      locate(i, i, sequence);
      measure(-50.0F - static_cast<float>(i), i + 0.1, sequence);
    }
  }
  void close() { (void)writer_.close(); }
  bag::BagWriter& writer() { return writer_; }

 private:
  static std::string made(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder.parent_path());
    return folder;
  }
  const std::int64_t from_ns_;
  bag::BagWriter writer_;
  std::map<std::string, std::size_t> topics_;
};

inline void put_text(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

/// Changes bytes of its first chunk of messages.
inline void damage(const std::filesystem::path& file) {
  const auto chunk = mcap::Reader(file).summary().chunks.at(0);
  std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
  bytes.seekp(static_cast<std::streamoff>(chunk.offset + 80));
  bytes << "damage";
}

/// A run of one vehicle, recorded on both sides.
inline void make_run(const std::filesystem::path& run, std::int64_t from_ns = noon_ns) {
  put_text(run / "deployment.yaml", "hosts: {rover: {role: uxv}, gcs: {role: gcs}}\n");
  SmallBag on_board(run / "rover/bag", from_ns);
  on_board.drive(10);
  SmallBag at_station(run / "gcs/bag", from_ns);
  at_station.drive(8);
}

}  // namespace tocsin::archive
