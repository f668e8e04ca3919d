// SPDX-License-Identifier: Apache-2.0
#include "rewrite.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "bag/bag_reader.hpp"
#include "info_text.hpp"
#include "pace.hpp"

namespace tocsin::bag_tool {
namespace {

/// One input, and where its topics are in the output.
struct Input {
  std::string path;
  std::unique_ptr<bag::BagReader> reader;
  std::vector<std::size_t> output_topic;
  std::unique_ptr<bag::BagStream> stream;
  std::optional<bag::TopicMessage> next;
};

std::vector<Input> opened(const std::vector<std::string>& paths) {
  std::vector<Input> inputs;
  for (const std::string& path : paths) {
    inputs.push_back({path, std::make_unique<bag::BagReader>(path), {}, nullptr, std::nullopt});
  }
  return inputs;
}

bag::Selection selection_of(const RewriteOrder& order, const std::vector<Input>& inputs,
                            const TopicChoice& choice) {
  std::optional<std::int64_t> earliest;
  for (const Input& input : inputs) {
    const bag::Metadata& about = input.reader->about();
    if (about.count > 0) earliest = std::min(earliest.value_or(about.start_ns), about.start_ns);
  }
  bag::Selection selection;
  selection.from_ns = later(earliest.value_or(0), order.start_offset_s);
  selection.to_ns = later(selection.from_ns, order.duration_s);
  selection.wanted = [&choice](const bag::Topic& topic) { return choice.contains(topic.name); };
  return selection;
}

/// Topics of one name and type of all inputs become one, with what the first of them offered.
void declare_topics(std::vector<Input>& inputs, const TopicChoice& choice, bag::BagWriter& writer) {
  std::map<std::pair<std::string, std::string>, std::size_t> numbers;
  for (Input& input : inputs) {
    for (const auto& [topic, count] : input.reader->topics()) {
      const std::pair key{topic.name, topic.type};
      auto found = numbers.find(key);
      if (found == numbers.end() && choice.contains(topic.name)) {
        found = numbers.emplace(key, writer.add(topic)).first;
      }
      input.output_topic.push_back(found == numbers.end() ? 0 : found->second);
    }
  }
}

Input* earliest_of(std::vector<Input>& inputs) {
  Input* earliest = nullptr;
  for (Input& input : inputs) {
    if (!input.next) continue;
    const bool first = earliest == nullptr ||
                       input.next->message.log_time_ns < earliest->next->message.log_time_ns;
    if (first) earliest = &input;
  }
  return earliest;
}

}  // namespace

Rewritten rewrite(const RewriteOrder& order) {
  const TopicChoice choice(order.topics);
  std::vector<Input> inputs = opened(order.inputs);
  const bag::Selection selection = selection_of(order, inputs, choice);
  bag::BagWriter writer(order.output, order.options);
  declare_topics(inputs, choice, writer);
  Rewritten result;
  for (Input& input : inputs) {
    for (const auto& one : input.reader->attachments()) (void)writer.write(one);
    for (const auto& one : input.reader->metadata()) (void)writer.write(one);
    input.stream = input.reader->messages(selection);
    input.next = input.stream->next();
  }
  while (Input* const input = earliest_of(inputs)) {
    (void)writer.write(input->output_topic[input->next->topic], input->next->message);
    ++result.messages;
    input->next = input->stream->next();
  }
  (void)writer.close();
  result.lost = writer.lost();
  result.messages -= result.lost;
  for (const Input& input : inputs) {
    for (const auto& [file, damage] : input.reader->damaged()) {
      result.damage.push_back(input.path + ": " + file + " " + damage_text(damage));
    }
  }
  return result;
}

}  // namespace tocsin::bag_tool
