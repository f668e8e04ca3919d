// SPDX-License-Identifier: Apache-2.0
#include "bag/recover_bag.hpp"

#include <filesystem>

#include "bag/bag_reader.hpp"
#include "bag/metadata.hpp"
#include "folder.hpp"
#include "foundation/error.hpp"
#include "foundation/replace_file.hpp"

namespace tocsin::bag {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> mcap_files(const fs::path& from) {
  if (!fs::is_directory(from)) return {from};
  std::vector<fs::path> files;
  for (const std::string& name : mcap_files_in(from)) files.push_back(from / name);
  if (files.empty()) throw ConfigError(from.string() + ": has no MCAP file");
  return files;
}

mcap::Recovered recover_file(mcap::ByteSource& source, const mcap::Header& header,
                             const fs::path& to) {
  mcap::FileSink sink(to);
  mcap::WriterOptions options;
  options.profile = header.profile.empty() ? "ros2" : header.profile;
  mcap::Writer writer(sink, options);
  mcap::Recovered recovered = mcap::recover(source, writer);
  if (writer.close() == mcap::Kept::nothing) {
    throw EnvironmentError(to.string() + ": the disk is full");
  }
  return recovered;
}

}  // namespace

std::vector<RecoveredFile> recover_bag(const std::string& from, const std::string& folder) {
  const std::vector<fs::path> files = mcap_files(from);
  make_folder(folder);
  std::vector<RecoveredFile> recovered;
  for (const fs::path& file : files) {
    mcap::FileSource source(file);
    const mcap::Header header = header_of(source, file);
    const std::string name = file.filename();
    recovered.push_back({name, recover_file(source, header, fs::path(folder) / name)});
  }
  const Metadata metadata = BagReader(folder).about();
  const fs::path path = fs::path(folder) / metadata_file;
  if (const auto error = replace_file(path, to_yaml(metadata), Sync::no)) {
    throw EnvironmentError(path.string() + ": cannot be written: " + error.message());
  }
  return recovered;
}

}  // namespace tocsin::bag
