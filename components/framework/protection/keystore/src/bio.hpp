// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <openssl/bio.h>

#include <memory>
#include <string>

namespace tocsin::keystore {

struct FreeBio {
  void operator()(BIO* bio) const { BIO_free_all(bio); }
};
/// OpenSSL's stream.
using Bio = std::unique_ptr<BIO, FreeBio>;

[[nodiscard]] inline Bio memory() { return Bio(BIO_new(BIO_s_mem())); }
/// Reads a text, which must outlive it.
[[nodiscard]] inline Bio memory_of(const std::string& text) {
  return Bio(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
}
/// All that was written to it.
[[nodiscard]] inline std::string text_of(BIO& bio) {
  char* bytes = nullptr;
  const long size = BIO_get_mem_data(&bio, &bytes);
  return {bytes, static_cast<std::size_t>(size)};
}

}  // namespace tocsin::keystore
