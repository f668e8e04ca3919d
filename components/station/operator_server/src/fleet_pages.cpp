// SPDX-License-Identifier: Apache-2.0
#include "operator_server/fleet_pages.hpp"

#include <algorithm>
#include <cctype>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"

namespace tocsin::foxglove {
namespace {

bool is_plain(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) {
    return std::isgraph(static_cast<unsigned char>(c)) != 0 && c != '=' && c != '"';
  });
}

/// `http://host:port` of an address; empty: it is none.
std::string origin_of(const std::string& url) {
  for (const std::string scheme : {"http://", "https://"}) {
    if (url.rfind(scheme, 0) != 0) continue;
    const std::size_t end = std::min(url.find('/', scheme.size()), url.size());
    return end > scheme.size() ? url.substr(0, end) : std::string();
  }
  return {};
}

}  // namespace

std::vector<FleetPage> fleet_pages(const std::string& owner,
                                   const std::vector<std::string>& items) {
  std::vector<FleetPage> pages;
  for (const std::string& item : items) {
    const std::size_t at = item.find('=');
    const std::string name = item.substr(0, at);
    const std::string url = at == std::string::npos ? "" : item.substr(at + 1);
    const std::string origin = origin_of(url);
    if (name.empty() || origin.empty() || !is_plain(name) || !is_plain(url)) {
      throw ConfigError(owner + ".fleet: '" + printable(item) +
                        "' is not VEHICLE=http://HOST:PORT/ or https");
    }
    pages.push_back({name, url.size() == origin.size() ? url + "/" : url, origin});
  }
  return pages;
}

std::string fleet_text(const std::vector<FleetPage>& pages) {
  std::string text;
  for (const FleetPage& page : pages) {
    text += (text.empty() ? "" : " ") + page.vehicle + "=" + page.url;
  }
  return text;
}

}  // namespace tocsin::foxglove
