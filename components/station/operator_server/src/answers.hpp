// SPDX-License-Identifier: Apache-2.0
// What requests of HTTP get.
#pragma once

#include <cstdint>  // Boost 1.83 needs it and does not say so

#include <atomic>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <functional>
#include <string>
#include <variant>

#include "file_part.hpp"
#include "operator_server/access.hpp"
#include "web_server.hpp"

namespace tocsin::foxglove {

namespace http = boost::beast::http;

using Request = http::request<http::string_body>;
using Response = http::response<http::string_body>;
using FileResponse = http::response<FilePart>;
/// Makes an answer that takes longer, on a thread that nobody else waits for.
using SlowResponse = std::function<Response()>;
using Answer = std::variant<OpenSocket, Response, FileResponse, SlowResponse>;

/// Empty: it has none of that name.
[[nodiscard]] std::string field(const Request& request, http::field name);

[[nodiscard]] Response respond(const Request& request, const Refuse& refusal);
[[nodiscard]] Response page_answer(const std::string& folder, const std::string& path,
                                   const Request& request);
/// Opens each recording: takes as long as the disk.
[[nodiscard]] Response bag_list_answer(const std::string& folder, const Request& request);
/// A recording, or the part of it that is asked for.
[[nodiscard]] Answer bag_answer(const std::string& folder, const std::string& path,
                                const Request& request);
/// What the recorder of a folder has written of a topic so far, as CSV: nothing where it has not.
/// Reads its bags: takes as long as the disk.
[[nodiscard]] Response table_answer(const std::string& folder, const std::string& topic,
                                    const Request& request);
/// Runs the tool, and blocks until it has ended or `cancelled`.
[[nodiscard]] Response what_if_answer(const WebSettings& settings, const std::string& query,
                                      const Request& request, const std::atomic<bool>& cancelled);

}  // namespace tocsin::foxglove
