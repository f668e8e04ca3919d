// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bag/metadata.hpp"
#include "bag/topic.hpp"
#include "mcap/reader.hpp"

namespace tocsin::bag {

/// Which messages of a bag are wanted; both times included.
struct Selection {
  std::int64_t from_ns = 0;
  std::int64_t to_ns = std::numeric_limits<std::int64_t>::max();
  std::function<bool(const Topic&)> wanted;  ///< empty: all
};

/// A message of one of a bag's topics.
struct TopicMessage {
  std::size_t topic;  ///< its place in BagReader::topics()
  Message message;    ///< its bytes are valid until the next one is asked for
};

class BagStream {
 public:
  virtual ~BagStream() = default;
  /// The next one by log time; empty: there are no more.
  [[nodiscard]] virtual std::optional<TopicMessage> next() = 0;
};

/// Reads a bag: a folder with metadata.yaml, or without one all MCAP files of it, or one MCAP file.
/// One thread.
class BagReader {
 public:
  /// Throws ConfigError with the path when it is no bag.
  explicit BagReader(const std::string& path);

  /// With the messages of each; in the order in which the files name them.
  [[nodiscard]] const std::vector<Metadata::TopicCount>& topics() const { return about_.topics; }
  /// What the files themselves say, whatever metadata.yaml does.
  [[nodiscard]] const Metadata& about() const { return about_; }
  /// [byte] of all files.
  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// Files that lack something, with what.
  [[nodiscard]] std::vector<std::pair<std::string, mcap::Damage>> damaged() const;

  /// The reader must outlive the stream; only one stream is read at a time.
  [[nodiscard]] std::unique_ptr<BagStream> messages(const Selection& selection = {});
  [[nodiscard]] std::vector<mcap::Attachment> attachments();
  [[nodiscard]] std::vector<mcap::Metadata> metadata();

  /// One of its files.
  struct File {
    std::string name;
    std::unique_ptr<mcap::Reader> reader;
    std::vector<std::size_t> topic_of_channel;     ///< by channel id
    std::vector<std::uint64_t> writer_of_channel;  ///< 0: not told
  };

 private:
  void add_file(const std::string& folder, const std::string& name);
  [[nodiscard]] std::size_t topic_number(const mcap::Summary& summary,
                                         const mcap::Channel& channel);

  std::vector<File> files_;
  Metadata about_;
  std::uint64_t size_ = 0;
};

}  // namespace tocsin::bag
