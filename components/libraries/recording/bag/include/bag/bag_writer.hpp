// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bag/metadata.hpp"
#include "bag/topic.hpp"
#include "mcap/byte_sink.hpp"
#include "mcap/format.hpp"

namespace tocsin::bag {

struct BagOptions {
  mcap::Compression compression = mcap::Compression::none;  ///< of chunks within the files
  std::uint64_t max_bytes = 0;                              ///< [byte] of a file; 0: no limit
  double max_duration_s = 0;  ///< [s] of a file, by log time; 0: no limit
};

/// Writes a bag: a folder `name` with `name_0.mcap`, `name_1.mcap`, ... and metadata.yaml. One
/// thread; after its constructor nothing throws.
///
/// metadata.yaml is there from the beginning, or as soon as there is room, and is made anew with
/// each file and at the end.
class BagWriter {
 public:
  /// Throws ConfigError when the folder is there already or cannot be made.
  BagWriter(const std::string& folder, const BagOptions& options);
  /// Closes.
  ~BagWriter();
  BagWriter(const BagWriter&) = delete;
  BagWriter& operator=(const BagWriter&) = delete;

  /// The number by which `write` knows the topic.
  [[nodiscard]] std::size_t add(const Topic& topic);
  /// `Kept::nothing`: the disk is full, and messages are lost.
  mcap::Kept write(std::size_t topic, const Message& message);
  mcap::Kept write(const mcap::Attachment& attachment);
  mcap::Kept write(const mcap::Metadata& metadata);
  /// Brings all messages to the file: a process that is killed after that loses none of them.
  mcap::Kept flush();
  mcap::Kept close();

  /// Messages that a full disk took.
  [[nodiscard]] std::uint64_t lost() const;
  [[nodiscard]] const std::string& folder() const { return folder_; }

 private:
  class File;
  [[nodiscard]] bool has_to_split(std::int64_t log_time_ns) const;
  mcap::Kept begin_file();
  mcap::Kept end_file();
  mcap::Kept write_metadata();

  const std::string folder_;
  const BagOptions options_;
  std::vector<Topic> topics_;
  std::vector<std::uint64_t> counts_;  ///< by topic, of files that are closed
  std::vector<Metadata::File> files_;  ///< the last one may be open
  std::unique_ptr<File> file_;
  std::uint64_t lost_ = 0;     ///< by files that are closed, or that could not be made
  bool has_metadata_ = false;  ///< of the files that there are; false: the disk was full
  bool closed_ = false;
};

}  // namespace tocsin::bag
