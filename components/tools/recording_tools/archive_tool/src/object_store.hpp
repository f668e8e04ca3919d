// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace tocsin::archive {

/// Keeps files by name: a folder, or a bucket of the S3 API. One thread.
class ObjectStore {
 public:
  virtual ~ObjectStore() = default;
  /// Whole or not at all; what is there under the name is replaced. Throws EnvironmentError.
  virtual void put(const std::string& object, const std::filesystem::path& from) = 0;
  /// Into a new file. Throws EnvironmentError, also when there is no such object.
  virtual void get(const std::string& object, const std::filesystem::path& to) = 0;
};

/// Where a bucket is and who asks: the names of environment variables that all clients of S3 know.
struct S3Access {
  std::string endpoint;  ///< AWS_ENDPOINT_URL; empty: Amazon's of the region
  std::string region;    ///< AWS_REGION; us-east-1
  std::string key;       ///< AWS_ACCESS_KEY_ID
  std::string secret;    ///< AWS_SECRET_ACCESS_KEY
};
[[nodiscard]] S3Access s3_access_of_environment();

/// Of `s3://BUCKET/PREFIX`, else of the folder, which is made when it is absent. Throws ConfigError
/// for a bucket without name, or without keys in `access`.
[[nodiscard]] std::unique_ptr<ObjectStore> open_store(const std::string& where,
                                                      const S3Access& access);

[[nodiscard]] bool is_s3(const std::string& where);
[[nodiscard]] std::unique_ptr<ObjectStore> open_s3_store(const std::string& where,
                                                         const S3Access& access);

}  // namespace tocsin::archive
