// SPDX-License-Identifier: Apache-2.0
#include "sample_log/ledger.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>
#include <vector>

#include "foundation/error.hpp"
#include "foundation/hash.hpp"
#include "numbered.hpp"

namespace tocsin::sample_log {
namespace {

/// Stream, source, first, last, and the hash of these four.
using Record = std::array<std::uint64_t, 5>;
/// A file is written anew when it has so many records: 4 MB.
constexpr std::size_t most_records = 100'000;

std::uint64_t checksum_of(const Record& record) {
  return hash_of(
      {reinterpret_cast<const char*>(record.data()), sizeof(Record) - sizeof(Record::value_type)});
}

void put_records(std::vector<Record>& to, const SampleSet::Writer& writer,
                 const SequenceSet& sequences) {
  for (const auto& [first, last] : sequences.ranges()) {
    to.push_back({writer.first, writer.second, first, last, 0});
    to.back().back() = checksum_of(to.back());
  }
}

mcap::Kept append(LogFile& file, const std::vector<Record>& records) {
  if (records.empty()) return mcap::Kept::all;
  return file.append(
      {{reinterpret_cast<const std::uint8_t*>(records.data()), records.size() * sizeof(Record)}});
}

}  // namespace

Ledger::Ledger(LogFiles& files, std::string name) : files_(files), name_(std::move(name)) {
  for (const std::string& file : files_.names()) {
    const auto number = number_in(file, name_, "");
    if (!number) continue;
    number_ = std::max(number_, *number);
    read(file);
  }
  (void)begin_file();
}

void Ledger::read(const std::string& file) {
  try {
    const auto source = files_.open(file);
    Record record{};
    for (std::uint64_t at = 0; at + sizeof record <= source->size(); at += sizeof record) {
      std::array<std::uint8_t, sizeof record> bytes{};
      if (!source->read(at, bytes.data(), bytes.size())) break;
      std::memcpy(record.data(), bytes.data(), bytes.size());
      const auto [stream, writer, first, last, checksum] = record;
      if (checksum != checksum_of(record) || first > last) {
        ++damaged_;
        continue;
      }
      done_.add({stream, writer}, first, last);
    }
  } catch (const ConfigError&) {
    ++damaged_;
  }
}

bool Ledger::add(const SampleId& id) {
  if (!done_.add(id)) return false;
  unsaved_[{id.stream, id.source}].insert(id.sequence);
  return true;
}

mcap::Kept Ledger::save() {
  if (!file_ || records_ >= most_records) return begin_file();
  std::vector<Record> records;
  for (const auto& [writer, sequences] : unsaved_) put_records(records, writer, sequences);
  if (append(*file_, records) == mcap::Kept::nothing) return mcap::Kept::nothing;
  records_ += records.size();
  unsaved_.clear();
  return mcap::Kept::all;
}

/// Everything goes to a new file; then the old ones are not needed any more.
mcap::Kept Ledger::begin_file() {
  std::map<std::uint64_t, const SampleSet::Writer*> by_use;
  const auto& writers = done_.writers();
  for (const auto& entry : writers) by_use[entry.second.used] = &entry.first;
  std::vector<Record> records;
  for (const auto& one : by_use) {
    put_records(records, *one.second, writers.at(*one.second).sequences);
  }
  try {
    const std::string file = numbered(name_, number_ + 1, "");
    auto made = files_.make(file);
    if (append(*made, records) == mcap::Kept::nothing) {
      made.reset();
      files_.remove(file);
      return mcap::Kept::nothing;
    }
    made->sync();
    file_ = std::move(made);
  } catch (const ConfigError&) {
    return mcap::Kept::nothing;
  }
  ++number_;
  records_ = records.size();
  unsaved_.clear();
  for (const std::string& file : files_.names()) {
    const auto number = number_in(file, name_, "");
    if (number && *number < number_) files_.remove(file);
  }
  return mcap::Kept::all;
}

}  // namespace tocsin::sample_log
