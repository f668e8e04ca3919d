// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "sample_log/log_files.hpp"
#include "sample_log/sample_id.hpp"
#include "sample_log/sample_set.hpp"

namespace tocsin::sample_log {

/// Which samples are done with: given to the host, or known to be on the other side. It survives
/// that its process is killed, from `save` on.
///
/// A file of records of one size, each with its own checksum: one that was half written, or is
/// damaged, is left out. It is written anew, without what is no longer needed, when it is opened
/// and when it has become long. Nothing throws. One thread.
class Ledger {
 public:
  /// Reads all files of `files` whose name begins with `name` and a dot.
  Ledger(LogFiles& files, std::string name);

  [[nodiscard]] const SampleSet& done() const { return done_; }
  /// Whether it was not in it yet.
  bool add(const SampleId& id);
  /// Brings what was added to the file. `nothing`: it cannot be written; what was added is tried
  /// again with the next call.
  [[nodiscard]] mcap::Kept save();
  /// What was saved survives a power cut from then on. May block for long.
  void sync() {
    if (file_) file_->sync();
  }
  /// Damaged records that were left out at the start.
  [[nodiscard]] std::size_t damaged() const { return damaged_; }

 private:
  void read(const std::string& file);
  [[nodiscard]] mcap::Kept begin_file();

  LogFiles& files_;
  const std::string name_;
  SampleSet done_;
  std::map<SampleSet::Writer, SequenceSet> unsaved_;
  std::uint64_t number_ = 0;  ///< of the last file
  std::size_t records_ = 0;   ///< in it
  std::size_t damaged_ = 0;
  std::unique_ptr<LogFile> file_;
};

}  // namespace tocsin::sample_log
