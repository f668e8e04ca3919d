// SPDX-License-Identifier: Apache-2.0
#include "object_store.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/file_descriptor.hpp"

namespace tocsin::archive {
namespace {

namespace fs = std::filesystem;

std::string variable(const char* name, const char* otherwise) {
  const char* const value = std::getenv(name);
  return value == nullptr || *value == 0 ? otherwise : value;
}

void sync(const fs::path& path) {
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() >= 0) (void)::fsync(file.get());
}

class FolderStore final : public ObjectStore {
 public:
  explicit FolderStore(fs::path folder) : folder_(std::move(folder)) {}
  void put(const std::string& object, const fs::path& from) override {
    const fs::path to = folder_ / object;
    // Its own name for each process: two may put the same at once.
    const fs::path begun = to.string() + "." + std::to_string(::getpid()) + ".part";
    try {
      fs::create_directories(to.parent_path());
      fs::copy_file(from, begun, fs::copy_options::overwrite_existing);
      sync(begun);
      fs::rename(begun, to);
      sync(to.parent_path());
    } catch (const fs::filesystem_error& error) {
      std::error_code ignored;
      fs::remove(begun, ignored);
      throw EnvironmentError(error.what());
    }
  }
  void get(const std::string& object, const fs::path& to) override {
    std::error_code error;
    fs::copy_file(folder_ / object, to, error);
    if (error) throw EnvironmentError((folder_ / object).string() + ": " + error.message());
  }

 private:
  const fs::path folder_;
};

}  // namespace

S3Access s3_access_of_environment() {
  return {variable("AWS_ENDPOINT_URL", ""), variable("AWS_REGION", "us-east-1"),
          variable("AWS_ACCESS_KEY_ID", ""), variable("AWS_SECRET_ACCESS_KEY", "")};
}

bool is_s3(const std::string& where) { return where.rfind("s3://", 0) == 0; }

std::unique_ptr<ObjectStore> open_store(const std::string& where, const S3Access& access) {
  if (is_s3(where)) return open_s3_store(where, access);
  return std::make_unique<FolderStore>(where);
}

}  // namespace tocsin::archive
