// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "recorder/csv_file.hpp"
#include "recorder/recording.hpp"
#include "runtime/logger.hpp"

namespace tocsin {

/// `messages.csv` has a row per sample: when it was sent and received, from which writer, its
/// number there. `<topic>.csv` (with '.' for '/') has the fields of the messages; it is made with
/// the first of them.
class CsvRecording final : public Recording {
 public:
  /// Makes the folder. Throws ConfigError naming it when it cannot be made or written. `owner` is
  /// the name in front of errors; `log` must outlive the recording.
  CsvRecording(std::string owner, std::string directory, Logger& log);

  [[nodiscard]] std::size_t add(const ChosenTopic& topic) override;
  void write(std::size_t topic, const Sample& sample) override;
  void flush() override;
  [[nodiscard]] std::uint64_t lost() const override;

 private:
  struct Track {
    std::string topic;
    const TypeInfo* type;
    std::unique_ptr<CsvFile> fields;  ///< opened with the first sample, which tells the columns
  };
  void open(Track& track, const std::vector<std::string>& columns);

  const std::string owner_;
  const std::string directory_;
  Logger& log_;
  std::unique_ptr<CsvFile> messages_;
  std::vector<Track> tracks_;
};

}  // namespace tocsin
