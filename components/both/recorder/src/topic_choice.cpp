// SPDX-License-Identifier: Apache-2.0
#include "recorder/topic_choice.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <sstream>

#include "foundation/error.hpp"
#include "foundation/names.hpp"
#include "foundation/printable.hpp"
#include "foundation/spelling.hpp"
#include "idl_support/type_registry.hpp"

namespace tocsin {
namespace {

/// What a reader asks for that must match every writer.
constexpr const char* modest_qos = "sensor";

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

bool is_word(const std::string& text) {
  const auto allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text[0])) == 0 &&
         std::all_of(text.begin(), text.end(), allowed);
}

bool is_topic_name(const std::string& name) {
  const auto words = words_of_path(name);
  return !words.empty() && std::all_of(words.begin(), words.end(), is_word);
}

/// `sensor_msgs::msg::dds_::Image_` of `sensor_msgs/msg/Image`; empty when it is none.
std::string wire_name(const std::string& type) {
  const auto words = words_of_path(type);
  const bool good =
      words.size() == 3 && words[1] == "msg" && is_word(words[0]) && is_word(words[2]);
  return good ? words[0] + "::msg::dds_::" + words[2] + "_" : "";
}

/// Collects the topics of all wishes.
class Choice {
 public:
  Choice(std::string owner, const std::vector<KnownTopic>& known)
      : owner_(std::move(owner)), known_(known) {}

  void add_link_topics() {
    for (const KnownTopic& topic : known_) {
      if (topic.info.scope == Scope::link) add({topic.info, topic.type});
    }
  }

  void add(const std::string& wish) {
    const auto words = words_of(wish);
    if (words.empty() || words.size() > 4) {
      fail(wish, "is not a name, a pattern or NAME TYPE [QOS [host|link]]");
    }
    const std::string name = without_slash(words[0]);
    if (words.size() > 1) {
      add_described(name, words);
    } else if (name.find_first_of("*?[") != std::string::npos) {
      add_matching(name);
    } else {
      add_known(name);
    }
  }

  std::vector<ChosenTopic> take() { return std::move(chosen_); }

 private:
  [[noreturn]] void fail(const std::string& what, const std::string& why) const {
    throw ConfigError(owner_ + ".topics: '" + printable(what) + "' " + why);
  }

  void add(const ChosenTopic& topic) {
    const std::string name = topic.info.name;
    for (ChosenTopic& other : chosen_) {
      if (other.info.name != name) continue;
      if (topic.named) other = topic;  // it says more than a rule
      return;
    }
    chosen_.push_back(topic);
  }

  [[nodiscard]] const KnownTopic* find(const std::string& name) const {
    const auto found = std::find_if(known_.begin(), known_.end(), [&](const KnownTopic& topic) {
      return topic.info.name == name;
    });
    return found == known_.end() ? nullptr : &*found;
  }

  void add_known(const std::string& name) {
    const KnownTopic* const topic = find(name);
    if (topic == nullptr) {
      std::vector<std::string> names;
      for (const KnownTopic& one : known_) names.emplace_back(one.info.name);
      fail(name, "is not a known topic" + did_you_mean(names, name, "known are") +
                     "; of another one say the type, too: '" + printable(name) +
                     " package/msg/Type'");
    }
    add({topic->info, topic->type, true});
  }

  void add_matching(const std::string& pattern) {
    bool any = false;
    for (const KnownTopic& topic : known_) {
      if (::fnmatch(pattern.c_str(), topic.info.name, 0) != 0) continue;
      any = true;
      add({topic.info, topic.type});
    }
    if (!any) fail(pattern, "matches no known topic");
  }

  void add_described(const std::string& name, const std::vector<std::string>& words) {
    if (!is_topic_name(name)) fail(name, "is not a name of a topic");
    const std::string wire = wire_name(words[1]);
    if (wire.empty()) fail(words[1], "is not a type such as sensor_msgs/msg/Image");
    const TypeInfo* const type = find_type(wire);
    if (type == nullptr) fail(words[1], "is a type that no installed IDL library has");
    const KnownTopic* const known = find(name);
    if (known != nullptr && known->type != type) {
      fail(name, "has the type " + std::string(known->type->name) + ", not " + wire);
    }
    if (known != nullptr && words.size() == 2) {
      add({known->info, type, true});
      return;
    }
    const std::string qos = words.size() > 2 ? words[2] : modest_qos;
    add({make_topic_info(name, qos, scope_of(words)), type, true});
  }

  [[nodiscard]] Scope scope_of(const std::vector<std::string>& words) const {
    if (words.size() < 4 || words[3] == "host") return Scope::host;
    if (words[3] != "link") fail(words[3], "is neither host nor link");
    return Scope::link;
  }

  const std::string owner_;
  const std::vector<KnownTopic>& known_;
  std::vector<ChosenTopic> chosen_;
};

}  // namespace

bool are_stated(const std::vector<std::string>& wishes, const std::vector<KnownTopic>& known) {
  return std::all_of(wishes.begin(), wishes.end(), [&known](const std::string& wish) {
    const auto words = words_of(wish);
    if (words.size() > 1) return find_type(wire_name(words[1])) != nullptr;
    return !words.empty() && std::any_of(known.begin(), known.end(), [&](const KnownTopic& topic) {
      return topic.info.name == without_slash(words[0]);
    });
  });
}

std::vector<ChosenTopic> choose_topics(const std::string& owner, const TopicWishes& wishes,
                                       const std::vector<KnownTopic>& known) {
  Choice choice(owner, known);
  if (wishes.link_topics) choice.add_link_topics();
  for (const std::string& wish : wishes.topics) choice.add(wish);
  return choice.take();
}

}  // namespace tocsin
