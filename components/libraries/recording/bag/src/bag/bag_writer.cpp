// SPDX-License-Identifier: Apache-2.0
#include "bag/bag_writer.hpp"

#include <filesystem>

#include "bag_file.hpp"
#include "folder.hpp"
#include "foundation/error.hpp"
#include "foundation/replace_file.hpp"
#include "foundation/time.hpp"
#include "totals.hpp"

namespace tocsin::bag {
namespace {

namespace fs = std::filesystem;
using mcap::Kept;

std::string name_of(const std::string& folder) {
  return fs::absolute(folder).lexically_normal().filename();
}

}  // namespace

BagWriter::BagWriter(const std::string& folder, const BagOptions& options)
    : folder_(without_slash_behind(folder)), options_(options) {
  make_folder(folder_);
  if (begin_file() == Kept::all) return;
  std::error_code none;
  fs::remove(folder_, none);
  throw ConfigError(folder_ + ": no file can be made in it");
}

BagWriter::~BagWriter() { (void)close(); }

std::size_t BagWriter::add(const Topic& topic) {
  topics_.push_back(topic);
  counts_.push_back(0);
  if (file_) file_->add(topic);
  return topics_.size() - 1;
}

bool BagWriter::has_to_split(std::int64_t log_time_ns) const {
  if (!file_) return true;
  if (file_->start_ns() == 0) return false;
  const bool full = options_.max_bytes > 0 && file_->writer().size() >= options_.max_bytes;
  const bool old = options_.max_duration_s > 0 &&
                   log_time_ns - file_->start_ns() >= seconds(options_.max_duration_s).count();
  return full || old;
}

Kept BagWriter::write(std::size_t topic, const Message& message) {
  if (closed_) return Kept::nothing;
  if (has_to_split(message.log_time_ns)) {
    (void)end_file();
    if (begin_file() == Kept::nothing) {
      ++lost_;
      return Kept::nothing;
    }
  }
  return file_->write(topic, message);
}

Kept BagWriter::write(const mcap::Attachment& attachment) {
  return file_ ? file_->writer().write(attachment) : Kept::nothing;
}

Kept BagWriter::write(const mcap::Metadata& metadata) {
  return file_ ? file_->writer().write(metadata) : Kept::nothing;
}

Kept BagWriter::flush() {
  if (!file_) return Kept::nothing;
  if (!has_metadata_) (void)write_metadata();
  return file_->writer().flush();
}

Kept BagWriter::begin_file() {
  const std::string path = name_of(folder_) + "_" + std::to_string(files_.size()) + ".mcap";
  try {
    file_ = std::make_unique<File>((fs::path(folder_) / path).string(), options_.compression);
  } catch (const ConfigError&) {
    return Kept::nothing;
  }
  files_.push_back({path, 0, 0, 0});
  for (const Topic& topic : topics_) file_->add(topic);
  (void)file_->writer().flush();  // its header and topics, so that it can be read from now on
  (void)write_metadata();         // made again at the end
  return Kept::all;
}

Kept BagWriter::end_file() {
  if (!file_) return Kept::all;
  const Kept kept = file_->writer().close();
  files_.back() = described(files_.back().path, file_->writer().statistics());
  for (std::size_t i = 0; i < topics_.size(); ++i) counts_[i] += file_->count(i);
  lost_ += file_->writer().lost();
  file_.reset();
  return kept;
}

Kept BagWriter::close() {
  if (closed_) return Kept::all;
  closed_ = true;
  const Kept kept = end_file();
  return write_metadata() == Kept::all ? kept : Kept::nothing;
}

Kept BagWriter::write_metadata() {
  Metadata metadata;
  metadata.files = files_;
  set_totals(metadata);
  for (std::size_t i = 0; i < topics_.size(); ++i) {
    metadata.topics.push_back({topics_[i], counts_[i]});
  }
  const auto failed =
      replace_file((fs::path(folder_) / metadata_file).string(), to_yaml(metadata), Sync::no);
  has_metadata_ = !failed;
  return failed ? Kept::nothing : Kept::all;
}

std::uint64_t BagWriter::lost() const { return lost_ + (file_ ? file_->writer().lost() : 0); }

}  // namespace tocsin::bag
