// SPDX-License-Identifier: Apache-2.0
#include <curl/curl.h>

#include <array>
#include <cstdio>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "object_store.hpp"

namespace tocsin::archive {
namespace {

namespace fs = std::filesystem;
using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

constexpr long connect_timeout_s = 10;
/// Below so many bytes a second for so long a transfer is given up.
constexpr long least_bytes_per_s = 100;
constexpr long stalled_s = 30;
constexpr long http_ok = 200;
constexpr std::size_t answer_bytes = 500;

File open_file(const fs::path& path, const char* mode) {
  File file(std::fopen(path.c_str(), mode), std::fclose);
  if (!file) throw EnvironmentError(path.string() + ": cannot be opened");
  return file;
}

/// Keeps the beginning of an answer, for the error.
std::size_t keep_answer(char* data, std::size_t size, std::size_t count, void* to) {
  auto& answer = *static_cast<std::string*>(to);
  if (answer.size() < answer_bytes) answer.append(data, size * count);
  return size * count;
}

/// Signature version 4 is curl's.
class S3Store final : public ObjectStore {
 public:
  S3Store(const std::string& bucket, const std::string& prefix, const S3Access& access)
      : url_(url_of(bucket, access) + (prefix.empty() ? "" : "/" + prefix)),
        user_(access.key + ":" + access.secret),
        signature_("aws:amz:" + access.region + ":s3") {}

  void put(const std::string& object, const fs::path& from) override {
    const File file = open_file(from, "rb");
    std::string answer;
    const Curl curl = request(object);
    set(curl, CURLOPT_UPLOAD, 1L);
    set(curl, CURLOPT_READDATA, file.get());
    set(curl, CURLOPT_INFILESIZE_LARGE, static_cast<curl_off_t>(fs::file_size(from)));
    set(curl, CURLOPT_WRITEFUNCTION, keep_answer);
    set(curl, CURLOPT_WRITEDATA, &answer);
    perform(curl, object, answer);
  }
  void get(const std::string& object, const fs::path& to) override {
    const File file = open_file(to, "wbx");
    try {
      const Curl curl = request(object);
      set(curl, CURLOPT_FAILONERROR, 1L);
      set(curl, CURLOPT_WRITEDATA, file.get());
      perform(curl, object, "");
      if (std::fflush(file.get()) != 0) throw EnvironmentError(to.string() + ": the disk is full");
    } catch (const EnvironmentError&) {
      std::error_code ignored;
      fs::remove(to, ignored);
      throw;
    }
  }

 private:
  struct Curl {
    Curl() : handle(curl_easy_init(), curl_easy_cleanup), headers(nullptr, curl_slist_free_all) {}
    std::unique_ptr<CURL, decltype(&curl_easy_cleanup)> handle;
    std::unique_ptr<curl_slist, decltype(&curl_slist_free_all)> headers;
  };
  template <class Value>
  static void set(const Curl& curl, CURLoption option, Value value) {
    (void)curl_easy_setopt(curl.handle.get(), option, value);
  }
  static std::string url_of(const std::string& bucket, const S3Access& access) {
    std::string endpoint = access.endpoint;
    if (endpoint.empty()) endpoint = "https://s3." + access.region + ".amazonaws.com";
    while (!endpoint.empty() && endpoint.back() == '/') endpoint.pop_back();
    return endpoint + "/" + bucket;
  }
  [[nodiscard]] Curl request(const std::string& object) const {
    Curl curl;
    if (!curl.handle) throw EnvironmentError("curl: no memory");
    // The content is not signed: it is read once, and TLS or the site's own network protects it.
    curl.headers.reset(curl_slist_append(nullptr, "x-amz-content-sha256: UNSIGNED-PAYLOAD"));
    set(curl, CURLOPT_URL, (url_ + "/" + object).c_str());
    set(curl, CURLOPT_AWS_SIGV4, signature_.c_str());
    set(curl, CURLOPT_USERPWD, user_.c_str());
    set(curl, CURLOPT_HTTPHEADER, curl.headers.get());
    set(curl, CURLOPT_CONNECTTIMEOUT, connect_timeout_s);
    set(curl, CURLOPT_LOW_SPEED_LIMIT, least_bytes_per_s);
    set(curl, CURLOPT_LOW_SPEED_TIME, stalled_s);
    set(curl, CURLOPT_NOSIGNAL, 1L);
    return curl;
  }
  void perform(const Curl& curl, const std::string& object, const std::string& answer) const {
    std::array<char, CURL_ERROR_SIZE> why{};
    set(curl, CURLOPT_ERRORBUFFER, why.data());
    const CURLcode result = curl_easy_perform(curl.handle.get());
    long status = 0;
    (void)curl_easy_getinfo(curl.handle.get(), CURLINFO_RESPONSE_CODE, &status);
    if (result == CURLE_OK && status == http_ok) return;
    const std::string what =
        result != CURLE_OK ? std::string(why[0] != 0 ? why.data() : curl_easy_strerror(result))
                           : std::to_string(status) + " " + printable(answer);
    throw EnvironmentError("bucket " + url_ + "/" + object + ": " + what);
  }
  const std::string url_;
  const std::string user_;
  const std::string signature_;
};

}  // namespace

std::unique_ptr<ObjectStore> open_s3_store(const std::string& where, const S3Access& access) {
  const std::string name = where.substr(std::string("s3://").size());
  const std::size_t slash = name.find('/');
  const std::string bucket = name.substr(0, slash);
  std::string prefix = slash == std::string::npos ? "" : name.substr(slash + 1);
  while (!prefix.empty() && prefix.back() == '/') prefix.pop_back();
  if (bucket.empty()) throw ConfigError("--archive: '" + where + "' must be s3://BUCKET/PREFIX");
  if (access.key.empty() || access.secret.empty()) {
    throw ConfigError(
        "--archive: a bucket needs AWS_ACCESS_KEY_ID and AWS_SECRET_ACCESS_KEY in the environment");
  }
  return std::make_unique<S3Store>(bucket, prefix, access);
}

}  // namespace tocsin::archive
