// SPDX-License-Identifier: Apache-2.0
#include "page/html.hpp"

#include <cmath>
#include <cstdio>

namespace tocsin::experiment::html {
namespace {

constexpr const char* style =
    "body{font:15px/1.5 sans-serif;color:#222;max-width:1080px;margin:2em auto;padding:0 1em}"
    "h1,h2,h3{line-height:1.25}h2{margin-top:2.2em;border-bottom:1px solid #ccc}"
    "table{border-collapse:collapse;font-size:13px;margin:1em 0;display:block;overflow-x:auto}"
    "th,td{border:1px solid #ccc;padding:.25em .6em;text-align:right;white-space:nowrap}"
    "th:first-child,td:first-child{text-align:left}th{background:#f2f2f2}"
    "td.text{white-space:normal;text-align:left}figure{margin:1.2em "
    "0}svg{max-width:100%;height:auto}"
    "figcaption{font-size:13px;color:#555}.yes{color:#00703c;font-weight:bold}"
    ".no{color:#b00020;font-weight:bold}.open{color:#8a6d00;font-weight:bold}"
    "pre{background:#f7f7f7;padding:1em;overflow-x:auto;font-size:12px}";

}  // namespace

std::string escape(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string heading(int level, const std::string& text) {
  const std::string tag = "h" + std::to_string(level);
  return "<" + tag + ">" + escape(text) + "</" + tag + ">\n";
}

std::string paragraph(const std::string& text) { return "<p>" + text + "</p>\n"; }

std::string table(const std::vector<std::vector<std::string>>& rows) {
  std::string text = "<table>\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string tag = i == 0 ? "th" : "td";
    text += "<tr>";
    for (const std::string& cell : rows[i]) {
      const bool prose = cell.size() > 60 && cell.find('<') == std::string::npos;
      text += "<" + tag + (prose ? " class=\"text\">" : ">") + cell + "</" + tag + ">";
    }
    text += "</tr>\n";
  }
  return text + "</table>\n";
}

std::string details(const std::string& summary, const std::string& inner) {
  return "<details><summary>" + escape(summary) + "</summary>\n" + inner + "</details>\n";
}

std::string preformatted(const std::string& text) { return "<pre>" + escape(text) + "</pre>\n"; }

std::string number(double value) {
  if (!std::isfinite(value)) return "-";
  char text[40];
  const double size = std::fabs(value);
  const int decimals = size >= 100 || value == 0 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3;
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string number(const Estimate& estimate) {
  if (!std::isfinite(estimate.low)) return number(estimate.mean);
  return number(estimate.mean) + " [" + number(estimate.low) + ", " + number(estimate.high) + "]";
}

std::string page(const std::string& title, const std::string& body) {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" +
         escape(title) + "</title><style>" + style + "</style></head>\n<body>\n" + body +
         "</body></html>\n";
}

}  // namespace tocsin::experiment::html
