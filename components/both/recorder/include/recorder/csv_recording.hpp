// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "csv_tables/csv_tables.hpp"
#include "recorder/recording.hpp"
#include "runtime/logger.hpp"

namespace tocsin {

/// A folder of CSV files, see CsvTables.
class CsvRecording final : public Recording {
 public:
  /// Makes the folder. Throws ConfigError naming it when it cannot be made or written. `owner` is
  /// the name in front of errors; `log` must outlive the recording.
  CsvRecording(std::string owner, const std::string& directory, Logger& log);

  [[nodiscard]] std::size_t add(const ChosenTopic& topic) override;
  void write(std::size_t topic, const Sample& sample) override;
  void flush() override { tables_.flush(); }
  [[nodiscard]] std::uint64_t lost() const override { return tables_.lost(); }

 private:
  struct Topic {
    std::string name;
    const TypeInfo* type;
  };
  const std::string owner_;
  Logger& log_;
  CsvTables tables_;
  std::vector<Topic> topics_;
};

}  // namespace tocsin
