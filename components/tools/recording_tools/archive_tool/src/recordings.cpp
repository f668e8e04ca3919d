// SPDX-License-Identifier: Apache-2.0
#include "recordings.hpp"

#include <openssl/evp.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>

#include "foundation/error.hpp"
#include "foundation/role.hpp"
#include "foundation/yaml_sources.hpp"
#include "mcap/format.hpp"

namespace tocsin::archive {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t tail_bytes = 65536;
constexpr const char* deployment_file = "deployment.yaml";
constexpr const char* unknown = "unknown";

/// The last bytes of a file, at most so many; empty when it cannot be read.
std::string tail_of(const fs::path& path, std::uint64_t size) {
  const std::uint64_t length = std::min(size, tail_bytes);
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(size - length));
  std::string tail(length, '\0');
  file.read(tail.data(), static_cast<std::streamsize>(length));
  return file ? tail : "";
}

bool ends_as_mcap(const std::string& tail) {
  const std::string magic(mcap::magic.begin(), mcap::magic.end());
  return tail.size() > 2 * magic.size() &&
         tail.compare(tail.size() - magic.size(), magic.size(), magic) == 0;
}

std::string digest_of(const std::string& text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  EVP_Digest(text.data(), text.size(), digest.data(), &length, EVP_sha256(), nullptr);
  constexpr const char* digits = "0123456789abcdef";
  std::string hex;
  for (std::size_t i = 0; i < 8; ++i) {
    hex += digits[digest[i] >> 4U];
    hex += digits[digest[i] & 15U];
  }
  return hex;
}

/// The vehicle of a run of one.
std::string vehicle_in(const fs::path& deployment) {
  try {
    YamlSources sources;
    for (const auto& host : sources.read(deployment)["hosts"]) {
      const YAML::Node role = host.second["role"];
      if (role_of(role.as<std::string>("")) == Role::uxv) return host.first.as<std::string>();
    }
  } catch (const ConfigError&) {  // not ours, or cut
  } catch (const YAML::Exception&) {
  }
  return unknown;
}

void tell_run(Recording& recording) {
  const fs::path bag = recording.path.parent_path();
  recording.vehicle = unknown;
  recording.run = bag.filename();
  std::error_code ignored;
  for (fs::path host = bag; host.has_relative_path(); host = host.parent_path()) {
    const fs::path part = host.parent_path();
    if (!fs::exists(part / deployment_file, ignored)) continue;
    recording.host = host.filename();
    const bool of_several = fs::exists(part.parent_path() / deployment_file, ignored);
    recording.run = of_several ? part.parent_path().filename() : part.filename();
    recording.vehicle = of_several ? part.filename().string() : vehicle_in(part / deployment_file);
    return;
  }
}

std::optional<Recording> recording_at(const fs::path& path) {
  std::error_code gone;
  const std::uint64_t size = fs::file_size(path, gone);
  if (gone) return std::nullopt;
  const std::string tail = tail_of(path, size);
  if (!ends_as_mcap(tail)) return std::nullopt;
  Recording recording;
  recording.path = fs::absolute(path).lexically_normal();
  recording.bytes = size;
  recording.id = digest_of(std::to_string(size) + tail);
  tell_run(recording);
  return recording;
}

/// A part of an object's name: what is no letter, digit, dot, dash or line becomes a line.
std::string part_of_name(std::string text) {
  for (char& letter : text) {
    const bool plain = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                       (letter >= '0' && letter <= '9') || letter == '.' || letter == '-';
    if (!plain) letter = '_';
  }
  return text.empty() || text == "." || text == ".." ? "_" : text;
}

}  // namespace

std::vector<Recording> closed_recordings(const std::vector<std::string>& folders) {
  std::vector<Recording> all;
  for (const std::string& folder : folders) {
    if (!fs::is_directory(folder)) throw ConfigError(folder + ": is no folder of runs or bags");
    const auto options = fs::directory_options::skip_permission_denied;
    for (const auto& entry : fs::recursive_directory_iterator(folder, options)) {
      if (!entry.is_regular_file() || entry.path().extension() != ".mcap") continue;
      if (auto recording = recording_at(entry.path())) all.push_back(std::move(*recording));
    }
  }
  std::sort(all.begin(), all.end(),
            [](const auto& one, const auto& other) { return one.path < other.path; });
  return all;
}

std::string object_of(const Recording& recording) {
  const std::string host = recording.host.empty() ? "" : part_of_name(recording.host) + "_";
  return part_of_name(recording.vehicle) + "/" + part_of_name(recording.run) + "/" + host +
         part_of_name(recording.path.stem()) + "-" + recording.id + ".mcap";
}

}  // namespace tocsin::archive
