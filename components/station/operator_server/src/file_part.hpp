// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <cstdint>  // Boost 1.83 needs it and does not say so

#include <algorithm>
#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/beast/core/error.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/optional.hpp>
#include <utility>

#include "foundation/file_descriptor.hpp"

namespace tocsin::foxglove {

/// A part of an open file, as the body of an answer (Beast's concept Body): read while it is sent.
/// The file may grow; when it became shorter the answer ends in an error.
struct FilePart {
  struct value_type {  // NOLINT: Beast knows it by this name
    FileDescriptor file;
    std::uint64_t at = 0;      ///< [byte] in the file
    std::uint64_t length = 0;  ///< [byte] still to be sent
  };
  static std::uint64_t size(const value_type& part) { return part.length; }

  class writer {  // NOLINT: the same
   public:
    using const_buffers_type = boost::asio::const_buffer;
    template <bool is_request, class Fields>
    writer(boost::beast::http::header<is_request, Fields>& /*head*/, value_type& part)
        : part_(part) {}
    void init(boost::beast::error_code& error) { error = {}; }
    boost::optional<std::pair<const_buffers_type, bool>> get(boost::beast::error_code& error) {
      error = {};
      if (part_.length == 0) return boost::none;
      const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(part_.length, size));
      const ssize_t got =
          ::pread(part_.file.get(), bytes_.data(), wanted, static_cast<off_t>(part_.at));
      if (got <= 0) {
        error = boost::beast::errc::make_error_code(boost::beast::errc::io_error);
        return boost::none;
      }
      part_.at += static_cast<std::uint64_t>(got);
      part_.length -= static_cast<std::uint64_t>(got);
      return std::make_pair(const_buffers_type(bytes_.data(), static_cast<std::size_t>(got)),
                            part_.length > 0);
    }

   private:
    static constexpr std::size_t size = std::size_t{64} << 10U;
    value_type& part_;
    std::array<char, size> bytes_{};
  };
};

}  // namespace tocsin::foxglove
