// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "mcap/writer.hpp"
#include "sample_channel.hpp"
#include "sample_log/sample_log.hpp"

namespace tocsin::sample_log {

/// The segment that is being written. Ends it with a summary when it is destroyed.
class SampleLog::Active {
 public:
  explicit Active(std::unique_ptr<LogFile> file)
      : file_(std::move(file)), writer_(*file_, options()) {}

  /// Entries with their log times: all of them as one chunk, or none.
  [[nodiscard]] mcap::Kept append(
      const std::vector<std::pair<const LogEntry*, std::uint64_t>>& entries,
      const std::map<std::uint64_t, LoggedStream>& streams);
  [[nodiscard]] std::uint64_t bytes() const { return writer_.size(); }
  void sync() { file_->sync(); }
  void close() { (void)writer_.close(); }

 private:
  [[nodiscard]] static mcap::WriterOptions options();
  [[nodiscard]] std::optional<std::uint16_t> channel_of(
      const SampleId& id, const std::map<std::uint64_t, LoggedStream>& streams);

  std::unique_ptr<LogFile> file_;
  mcap::Writer writer_;
  std::map<std::uint64_t, std::uint16_t> schemas_;  ///< by stream
  std::map<ChannelKey, std::uint16_t> channels_;
};

}  // namespace tocsin::sample_log
