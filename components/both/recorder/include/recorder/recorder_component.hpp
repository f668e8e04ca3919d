// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "recorder/csv_file.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Records every link topic that reaches its process.
///
/// `messages.csv` has a row per sample: when it was sent and received, from which writer, its
/// number there. `<topic>.csv` (with '.' for '/') has the fields of the messages.
class RecorderComponent final : public Component {
 public:
  struct Params {
    std::string directory;
    double flush_period_s = 0.5;
    template <class Visitor>
    void visit(Visitor& v) {
      v("directory", directory, "folder of the files; made when absent; empty: run folder/role");
      v("flush_period_s", flush_period_s, {0.05, 60}, "[s] between writes to the disk");
    }
  };

  RecorderComponent(Context& context, const Params& params);
  void tick(Time now) override;

 private:
  /// One topic: where it comes from and goes to.
  struct Track {
    std::string topic;
    const TypeInfo* type;
    std::unique_ptr<InputPort> input;
    std::unique_ptr<CsvFile> fields;  ///< opened with the first sample, which tells the columns
  };
  template <class... Topics>
  void add_all(topic::List<Topics...>);
  void record(Track& track, const Sample& sample);
  void open(Track& track, const std::vector<std::string>& columns);
  void flush(Time now);
  [[nodiscard]] std::uint64_t lost() const;

  std::string directory_;
  Duration flush_period_;
  Time next_flush_{};
  std::unique_ptr<CsvFile> messages_;
  std::vector<Track> tracks_;
  bool disk_full_ = false;
  std::uint64_t lost_ = 0;
};

}  // namespace tocsin
