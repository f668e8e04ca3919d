// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/refused_names.hpp"

#include <mutex>

#include "foundation/printable.hpp"

namespace tocsin {
namespace {

/// Of a name that is shown.
constexpr std::size_t longest_name = 100;

/// Of the process, as its router is.
struct Refused {
  std::mutex mutex;
  RefusedNames names;
};

Refused& refused_here() {
  static Refused instance;
  return instance;
}

}  // namespace

RefusedNames::News RefusedNames::add(const std::string& name, const std::string& peer) {
  ++total_;
  const std::string shown = printable(name, longest_name);
  const std::string who = peer.empty() ? "an unnamed peer" : printable(peer, longest_name);
  const std::string line = shown + " from " + who;
  const auto known = lines_.find(line);
  if (known != lines_.end()) {
    ++known->second;
    return News::none;
  }
  if (lines_.size() >= most_lines) return ++lines_[others] == 1 ? News::full : News::none;
  lines_[line] = 1;
  return names_.insert(shown).second ? News::first : News::none;
}

void refuse(const std::string& what, const std::string& name, const std::string& peer,
            Logger& log) {
  RefusedNames::News news{};
  {
    const std::lock_guard<std::mutex> lock(refused_here().mutex);
    news = refused_here().names.add(what + " " + name, peer);
  }
  if (news == RefusedNames::News::first) {
    log.warn("{} {} from {} is refused: no rule of the traffic file sends it here", what, name,
             peer.empty() ? "an unnamed peer" : peer);
  }
  if (news == RefusedNames::News::full) {
    log.warn("more than {} names are refused; the others are counted together",
             RefusedNames::most_lines);
  }
}

RefusedNames refused_names() {
  const std::lock_guard<std::mutex> lock(refused_here().mutex);
  return refused_here().names;
}

}  // namespace tocsin
