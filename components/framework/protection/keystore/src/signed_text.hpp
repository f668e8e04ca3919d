// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "certificates.hpp"

namespace tocsin::keystore {

/// A document as DDS Security wants it (1.1 section 9.4.1.1): S/MIME 3.2, multipart/signed, the
/// text in the clear.
[[nodiscard]] std::string sign(const std::string& text, const Authority& authority);
/// The text, if `authority` has signed it and is valid itself at `now_s`.
[[nodiscard]] std::optional<std::string> verified(const std::string& document, X509& authority,
                                                  std::int64_t now_s);

}  // namespace tocsin::keystore
