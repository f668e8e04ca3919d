// SPDX-License-Identifier: Apache-2.0
#include "export.hpp"

#include <filesystem>
#include <set>

#include "csv_tables/bag_tables.hpp"
#include "csv_tables/csv_tables.hpp"
#include "foundation/error.hpp"
#include "pace.hpp"

namespace tocsin::bag_tool {

Exported export_csv(const RewriteOrder& order) {
  const TopicChoice choice(order.topics);
  bag::BagReader reader(order.inputs.at(0));
  if (std::filesystem::exists(order.output)) {
    throw ConfigError(order.output + ": is there already");
  }
  bag::Selection selection;
  selection.from_ns = later(reader.about().start_ns, order.start_offset_s);
  selection.to_ns = later(selection.from_ns, order.duration_s);
  selection.wanted = [&choice](const bag::Topic& topic) { return choice.contains(topic.name); };
  CsvTables tables(order.output);
  Exported result;
  std::set<std::string> unknown;
  read_messages(reader, selection, [&](const BagMessage& one) {
    tables.write(one.about, one.type, one.content.get());
    ++result.messages;
    if (one.type == nullptr) unknown.insert(one.about.topic);
    for (std::string& problem : tables.take_problems()) {
      result.problems.push_back(std::move(problem));
    }
  });
  result.lost = tables.lost();
  result.unknown.assign(unknown.begin(), unknown.end());
  return result;
}

}  // namespace tocsin::bag_tool
