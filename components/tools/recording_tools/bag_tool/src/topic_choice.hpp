// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace tocsin::bag_tool {

/// What a person said about topics, with the words of `ros2 bag`.
struct TopicWishes {
  bool all = false;                 ///< -a
  std::vector<std::string> topics;  ///< names, with or without the slash in front
  std::string regex;                ///< -e: names that contain a match (Perl's syntax)
  std::string exclude_regex;        ///< -x
  std::vector<std::string> exclude_topics;
  bool hidden = false;  ///< names with a part that begins with _, too
};

/// Which topics are meant. Without `all`, `topics` and `regex`, all are.
class TopicChoice {
 public:
  /// Throws ConfigError for a regular expression that is none.
  explicit TopicChoice(const TopicWishes& wishes);
  ~TopicChoice();
  TopicChoice(const TopicChoice&) = delete;
  TopicChoice& operator=(const TopicChoice&) = delete;

  /// By its name with the slash. Throws ConfigError when an expression is too costly for it.
  [[nodiscard]] bool contains(const std::string& topic) const;

 private:
  struct Expressions;
  [[nodiscard]] bool is_wanted(const std::string& topic) const;
  [[nodiscard]] bool is_excluded(const std::string& topic) const;

  TopicWishes wishes_;
  std::unique_ptr<Expressions> expressions_;
};

/// `/odom` of `odom` and `/odom`.
[[nodiscard]] std::string absolute(const std::string& topic);

}  // namespace tocsin::bag_tool
