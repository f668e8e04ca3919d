// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "bag/bag_writer.hpp"
#include "foundation/csv_table.hpp"
#include "idl_support/encode.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::report {

/// A row of a table whose cells become fields of a message; a column that is not there leaves the
/// field as it is.
class TableRow {
 public:
  TableRow(const CsvTable& table, std::size_t row) : table_(table), row_(row) {}
  [[nodiscard]] std::string text(const char* column) const { return table_.text(row_, column); }
  [[nodiscard]] double number(const char* column) const { return table_.number(row_, column); }
  [[nodiscard]] std::uint32_t count(const char* column) const {
    const double value = number(column);
    return std::isfinite(value) ? static_cast<std::uint32_t>(value) : 0;
  }
  [[nodiscard]] std::int64_t ns(const char* column) const {
    return std::llround(number(column) * 1e9);
  }

 private:
  const CsvTable& table_;
  std::size_t row_;
};

inline void fill(tocsin_msgs::msg::TransmissionState& state, const TableRow& row) {
  state.role(row.text("role"));
  state.active(row.count("active") == 1);
  state.policy(row.text("policy"));
  state.reason(row.text("reason"));
  state.qni(static_cast<float>(row.number("qni")));
}

inline void fill(tocsin_msgs::msg::NetworkQuality& quality, const TableRow& row) {
  quality.per_percent(static_cast<float>(row.number("per_percent")));
  quality.signal_dbm(static_cast<float>(row.number("signal_dbm")));
}

inline void fill(tocsin_msgs::msg::MissionStatus& status, const TableRow& row) {
  status.mission(row.text("mission"));
  status.state(row.text("state"));
  status.waypoint(row.count("waypoint"));
  status.waypoints(row.count("waypoints"));
  status.goals_sent(row.count("goals_sent"));
  status.elapsed_s(row.number("elapsed_s"));
}

inline void fill(tocsin_msgs::msg::LinkState& state, const TableRow& row) {
  state.role(row.text("role"));
  state.capacity_bytes_per_s(static_cast<float>(row.number("capacity_bytes_per_s")));
  state.backlog_s(static_cast<float>(row.number("backlog_s")));
  state.capacity_measured(row.count("capacity_measured") == 1);
  if (row.text("second_chosen").empty()) return;
  state.paths().resize(2);
  state.paths()[row.count("second_chosen")].chosen(true);
}

inline void fill(topic::Location::Message& pose, const TableRow& row) {
  pose.pose().pose().position().x(row.number("pose.pose.position.x"));
  pose.pose().pose().position().y(row.number("pose.pose.position.y"));
}

/// The bag of a recorder's folder, made of CSV texts by topic as `tocsin bag export` writes them;
/// `messages` has those of the topics without a text, and writer and number of the others.
class TableBag {
 public:
  TableBag(const std::string& folder, const std::map<std::string, std::string>& texts)
      : writer_(folder + "/bag", {}) {
    const auto found = texts.find("messages");
    const CsvTable messages(found == texts.end() ? "" : found->second);
    for (std::size_t i = 0; i < messages.rows(); ++i) {
      const std::string topic = messages.text(i, "topic");
      const TableRow row(messages, i);
      origins_[{topic, row.ns("receive_s")}] = {row.count("writer"), row.count("sequence")};
      if (texts.count(topic) == 0) write_bytes(topic, row);
    }
    write_all<tocsin_msgs::msg::TransmissionState>("transmission_state", texts);
    write_all<tocsin_msgs::msg::NetworkQuality>("network_quality", texts);
    write_all<tocsin_msgs::msg::MissionStatus>("mission_status", texts);
    write_all<tocsin_msgs::msg::LinkState>("link_state", texts);
    write_all<topic::Location::Message>("location", texts);
  }

 private:
  struct Origin {
    std::uint32_t writer;
    std::uint32_t sequence;
  };

  void write_bytes(const std::string& name, const TableRow& row) {
    bag::Topic topic;
    topic.name = "/" + name;
    topic.type = "toy_msgs/msg/Bytes";
    const auto known = numbers_.find(name);
    const std::size_t number =
        known == numbers_.end() ? numbers_[name] = writer_.add(topic) : known->second;
    write(name, number, row, std::vector<std::uint8_t>(row.count("bytes")));
  }
  template <class Message>
  void write_all(const std::string& topic, const std::map<std::string, std::string>& texts) {
    const auto text = texts.find(topic);
    if (text == texts.end()) return;
    const std::size_t number =
        writer_.add(bag::make_topic("rt/" + topic, type_info<Message>().name));
    const CsvTable table(text->second);
    for (std::size_t i = 0; i < table.rows(); ++i) {
      const TableRow row(table, i);
      Message message;
      fill(message, row);
      write(topic, number, row, encode(type_info<Message>(), &message));
    }
  }
  void write(const std::string& topic, std::size_t number, const TableRow& row,
             const std::vector<std::uint8_t>& bytes) {
    const auto [writer, sequence] = origins_[{topic, row.ns("receive_s")}];
    (void)writer_.write(number, {sequence, row.ns("receive_s"), row.ns("send_s"), bytes.data(),
                                 bytes.size(), writer});
  }

  bag::BagWriter writer_;
  std::map<std::string, std::size_t> numbers_;
  std::map<std::pair<std::string, std::int64_t>, Origin> origins_;
};

}  // namespace tocsin::report
