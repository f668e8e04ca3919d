// SPDX-License-Identifier: Apache-2.0
#include "answers.hpp"

#include <utility>

#include "csv_tables/bag_tables.hpp"
#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "operator_server/bag_list.hpp"
#include "operator_server/what_if.hpp"
#include "page_files.hpp"
#include "run_tool.hpp"

namespace tocsin::foxglove {
namespace {

void set_common_fields(http::fields& fields, const char* type) {
  fields.set(http::field::content_type, type);
  fields.set(http::field::cache_control, "no-cache");
  fields.set("X-Content-Type-Options", "nosniff");
  fields.set("Referrer-Policy", "no-referrer");
  fields.set("X-Frame-Options", "DENY");
}

constexpr const char* plain_text = "text/plain; charset=utf-8";
constexpr double what_if_window_s = 600;

Response respond(const Request& request, unsigned status, const char* type, std::string body) {
  Response response{static_cast<http::status>(status), request.version()};
  set_common_fields(response, type);
  response.keep_alive(request.keep_alive() && status < 400);
  response.content_length(body.size());
  if (request.method() != http::verb::head) response.body() = std::move(body);
  return response;
}

/// A file, or the part of it that is asked for.
Answer file_answer(OpenBag bag, const Request& request) {
  const auto range = byte_range(field(request, http::field::range), bag.bytes);
  if (!range) {
    Response response = respond(request, Refuse{416, "it has no such bytes"});
    response.set(http::field::content_range, "bytes */" + std::to_string(bag.bytes));
    return response;
  }
  FileResponse response{range->is_part ? http::status::partial_content : http::status::ok,
                        request.version()};
  set_common_fields(response, "application/octet-stream");
  response.set(http::field::accept_ranges, "bytes");
  if (range->is_part) {
    response.set(http::field::content_range, "bytes " + std::to_string(range->first) + "-" +
                                                 std::to_string(range->first + range->length - 1) +
                                                 "/" + std::to_string(bag.bytes));
  }
  response.keep_alive(request.keep_alive());
  response.content_length(range->length);
  const bool has_body = request.method() != http::verb::head;
  response.body() = {std::move(bag.file), range->first, has_body ? range->length : 0};
  return response;
}

}  // namespace

std::string field(const Request& request, http::field name) {
  const auto found = request.find(name);
  return found == request.end() ? std::string() : std::string(found->value());
}

Response respond(const Request& request, const Refuse& refusal) {
  return respond(request, refusal.status, plain_text, refusal.reason + "\n");
}

Response page_answer(const std::string& folder, const std::string& path, const Request& request) {
  const bool takes_gzip =
      field(request, http::field::accept_encoding).find("gzip") != std::string::npos;
  PageFile file = page_file(folder, path, takes_gzip);
  Response response = respond(request, file.status, file.type, std::move(file.bytes));
  if (file.zipped) response.set(http::field::content_encoding, "gzip");
  response.set("Content-Security-Policy", page_policy);
  return response;
}

Response bag_list_answer(const std::string& folder, const Request& request) {
  return respond(request, 200, content_type(".json"), to_json(list_bags(folder)));
}

Answer bag_answer(const std::string& folder, const std::string& path, const Request& request) {
  OpenBag bag = open_bag(folder, path);
  if (!bag.file) return respond(request, Refuse{404, "there is no such recording"});
  return file_answer(std::move(bag), request);
}

Response table_answer(const std::string& folder, const std::string& topic, const Request& request) {
  std::string table;
  try {
    table = BagTables(recorded_bags(folder), [&topic](const std::string& one) {
              return one == topic;
            }).of(topic);
  } catch (const ConfigError&) {
    // a bag that is being made, or damaged: as if there were none
  }
  return respond(request, 200, "text/csv; charset=utf-8", std::move(table));
}

Response what_if_answer(const WebSettings& settings, const std::string& query,
                        const Request& request, const std::atomic<bool>& cancelled) {
  const auto question = parse_what_if(query);
  if (const auto* const fault = std::get_if<std::string>(&question)) {
    return respond(request, Refuse{400, *fault});
  }
  if (settings.decide.empty())
    return respond(request, Refuse{404, "tocsin decide is not installed"});
  if (recorded_bags(settings.recorded).empty()) {
    return respond(request, Refuse{404, "this run has no recorded decisions: no recorder"});
  }
  const ToolOutcome outcome =
      run_tool(what_if_command(settings.decide, settings.recorded, std::get<WhatIf>(question)), {},
               cancelled);
  if (outcome.end != ToolOutcome::End::success) {
    const bool is_done = outcome.end == ToolOutcome::End::failure;
    return respond(request, Refuse{is_done ? 400U : 503U,
                                   is_done ? printable(outcome.printed, 400) : "it took too long"});
  }
  return respond(request, 200, content_type(".json"), last_rows(outcome.printed, what_if_window_s));
}

}  // namespace tocsin::foxglove
