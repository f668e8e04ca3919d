// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bag/bag_reader.hpp"
#include "csv_tables/message_rows.hpp"
#include "foundation/csv_table.hpp"

namespace tocsin {

/// A message of a bag, and what it says.
struct BagMessage {
  RecordedMessage about;
  const TypeInfo* type = nullptr;  ///< null: no loaded library has it, or its bytes are damaged
  std::shared_ptr<const void> content;  ///< of that type; null with it
};

/// Gives the messages of a bag, by log time, to `receive`.
void read_messages(bag::BagReader& bag, const bag::Selection& selection,
                   const std::function<void(const BagMessage&)>& receive);

/// Whether there is a bag: a folder with metadata.yaml or an MCAP file in it, or an MCAP file.
[[nodiscard]] bool is_bag(const std::string& path);

/// The bags that a recorder has left in its folder, in the order in which it made them: `bag`,
/// `bag_2`, ... of a recorder that was started again.
[[nodiscard]] std::vector<std::string> recorded_bags(const std::string& folder);

/// Bags of one run as CSV texts, one after the other, with the rows that `tocsin bag export`
/// writes. The types of tocsin_idl are known; of others only the row in messages.csv is there,
/// unless the program has loaded them.
class BagTables {
 public:
  /// Reads the whole bags, but only topics (without leading slash) that are wanted. Throws
  /// ConfigError.
  explicit BagTables(const std::vector<std::string>& bags,
                     const std::function<bool(const std::string& topic)>& wanted = {});

  /// messages.csv
  [[nodiscard]] const std::string& messages() const { return messages_; }
  /// <topic>.csv; empty when there is none.
  [[nodiscard]] const std::string& of(const std::string& topic) const;
  [[nodiscard]] const std::map<std::string, std::string>& topics() const { return topics_; }

 private:
  std::string messages_;
  std::map<std::string, std::string> topics_;
};

}  // namespace tocsin
