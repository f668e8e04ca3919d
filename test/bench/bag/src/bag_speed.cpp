// SPDX-License-Identifier: Apache-2.0
// bag_speed [--folder DIR] [--gigabytes N]: MB and thousands of messages a second on one core, for
// pictures of 1 MB and messages of 64 B, beside a copy in memory and a plain file in the same run;
// then a large bag: opened by its index, read from its middle, cut, and recovered.
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstring>
#include <filesystem>
#include <random>
#include <vector>

#include "bag/bag_reader.hpp"
#include "bag/bag_writer.hpp"
#include "bag/recover_bag.hpp"
#include "foundation/file_descriptor.hpp"
#include "measured.hpp"

namespace tocsin::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t picture_bytes = 1'000'000;
constexpr std::size_t small_bytes = 64;
constexpr std::int64_t t0 = 1'700'000'000'000'000'000;

/// `share` of the bytes are noise, the rest repeats: what a codec finds in raw pictures.
std::vector<std::uint8_t> content(std::size_t size, double share) {
  std::mt19937 random(1);
  std::vector<std::uint8_t> bytes(size);
  for (std::size_t i = 0; i < size; ++i) {
    const bool noise = static_cast<double>(random() % 1000) < share * 1000;
    bytes[i] = static_cast<std::uint8_t>(noise ? random() : i / 64);
  }
  return bytes;
}

void copy_in_memory(const std::vector<std::uint8_t>& message, std::uint64_t count) {
  std::vector<std::uint8_t> to(message.size());
  for (std::uint64_t i = 0; i < count; ++i) {
    std::memcpy(to.data(), message.data(), message.size());
    asm volatile("" : : "r"(to.data()) : "memory");
  }
}

/// In blocks of a chunk's size, as a bag is written.
void write_plain(const std::string& path, std::uint64_t bytes) {
  const std::vector<std::uint8_t> block(786'432, 7);
  const FileDescriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
  while (bytes > 0) {
    const std::uint64_t part = std::min<std::uint64_t>(bytes, block.size());
    if (::write(file.get(), block.data(), part) != static_cast<ssize_t>(part)) return;
    bytes -= part;
  }
}

void copy_plain(const std::string& from, const std::string& to) {
  const FileDescriptor in(::open(from.c_str(), O_RDONLY | O_CLOEXEC));
  const FileDescriptor out(::open(to.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
  std::vector<std::uint8_t> block(1U << 20U);
  for (ssize_t got = 1; got > 0;) {
    got = ::read(in.get(), block.data(), block.size());
    if (got > 0 && ::write(out.get(), block.data(), static_cast<std::size_t>(got)) != got) return;
  }
}

void write_bag(const std::string& folder, const std::vector<std::uint8_t>& message,
               std::uint64_t count, mcap::Compression compression) {
  fs::remove_all(folder);
  bag::BagOptions options;
  options.compression = compression;
  bag::BagWriter writer(folder, options);
  bag::Topic topic;
  topic.type = "std_msgs/msg/String";
  std::vector<std::size_t> topics;
  for (int i = 0; i < 10; ++i) {
    topic.name = "/topic_" + std::to_string(i);
    topics.push_back(writer.add(topic));
  }
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto time = t0 + static_cast<std::int64_t>(i) * 1'000'000;
    (void)writer.write(topics[i % topics.size()],
                       {static_cast<std::uint32_t>(i), time, time, message.data(), message.size()});
  }
}

void compare(const std::string& folder, const std::vector<std::uint8_t>& message,
             std::uint64_t count) {
  const std::uint64_t bytes = count * message.size();
  print_row("copy in memory", measured([&] { copy_in_memory(message, count); }), bytes, count);
  const std::string plain = folder + "/plain";
  print_row("plain file", measured([&] { write_plain(plain, bytes); }), bytes, count);
  fs::remove(plain);
  const std::string bag = folder + "/bag";
  for (const auto compression :
       {mcap::Compression::none, mcap::Compression::lz4, mcap::Compression::zstd}) {
    const auto took = measured([&] { write_bag(bag, message, count, compression); });
    print_row(fmt::format("bag, {}", words_of(compression)[static_cast<std::size_t>(compression)]),
              took, bytes, count);
  }
  write_bag(bag, message, count, mcap::Compression::none);
  print_row("bag read by index", measured([&] {
              bag::BagReader reader(bag);
              const auto stream = reader.messages();
              while (stream->next()) continue;
            }),
            bytes, count);
  fs::remove_all(bag);
}

void large_bag(const std::string& folder, std::uint64_t bytes) {
  const std::string bag = folder + "/large";
  const std::string file = bag + "/large_0.mcap";
  write_bag(bag, content(picture_bytes, 1), bytes / picture_bytes, mcap::Compression::none);
  drop_cache(file);
  const auto opened = measured([&] { const bag::BagReader reader(bag); });
  fmt::print("\n{:.1f} GB: opened by its index in {:.1f} ms", static_cast<double>(bytes) * 1e-9,
             opened.wall_s * 1e3);
  const auto middle = measured([&] {
    bag::BagReader reader(bag);
    bag::Selection selection;
    selection.from_ns = reader.about().start_ns + reader.about().duration_ns / 2;
    (void)reader.messages(selection)->next();
  });
  fmt::print(", the first message of its middle {:.1f} ms after the start\n", middle.wall_s * 1e3);
  fs::resize_file(file, fs::file_size(file) - 1000);
  fmt::print(
      "\n| large bag without its summary | MB/s by the clock | MB/s of CPU |\n|---|---|---|\n");
  drop_cache(file);
  print_row("copied as a file", measured([&] { copy_plain(file, folder + "/copy"); }), bytes);
  fs::remove(folder + "/copy");
  drop_cache(file);
  reset_peak();
  print_row("recovered", measured([&] { (void)bag::recover_bag(bag, folder + "/recovered"); }),
            bytes);
  fmt::print("\nmost memory while it was recovered: {:.0f} MB\n",
             static_cast<double>(peak_resident_kib()) * 1.024e-3);
  fs::remove_all(folder + "/recovered");
  fs::remove_all(bag);
}

void print_head(const char* what) {
  fmt::print(
      "\n| {} | MB/s by the clock | MB/s of CPU | 1000 messages/s | of CPU |\n"
      "|---|---|---|---|---|\n",
      what);
}

}  // namespace
}  // namespace tocsin::bench

int main(int argc, char** argv) {
  using namespace tocsin::bench;
  std::string folder = "bag_speed";
  double gigabytes = 2;
  CLI::App app("How fast bags are, beside memory and a plain file.");
  app.add_option("--folder", folder, "for the files, which are removed [bag_speed]");
  app.add_option("--gigabytes", gigabytes, "of the large bag [2]")->check(CLI::Range(0.01, 100.0));
  CLI11_PARSE(app, argc, argv);
  std::filesystem::create_directories(folder);
  print_head("pictures of 1 MB, all noise (JPEG)");
  compare(folder, content(picture_bytes, 1), 1000);
  print_head("pictures of 1 MB, a tenth noise (raw)");
  compare(folder, content(picture_bytes, 0.1), 1000);
  print_head("messages of 64 B");
  compare(folder, content(small_bytes, 0.3), 5'000'000);
  large_bag(folder, static_cast<std::uint64_t>(gigabytes * 1e9));
  std::filesystem::remove(folder);
  return 0;
}
