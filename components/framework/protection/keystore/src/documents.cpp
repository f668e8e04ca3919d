// SPDX-License-Identifier: Apache-2.0
#include "documents.hpp"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <array>
#include <ctime>

#include "foundation/joined.hpp"

namespace tocsin::keystore {
namespace {

// Domains end at 230 here: Cyclone DDS 0.10.2 refuses a document that names a higher one.
constexpr const char* governance_text = R"(<?xml version="1.0" encoding="UTF-8"?>
<dds xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
     xsi:noNamespaceSchemaLocation="http://www.omg.org/spec/DDS-SECURITY/20170901/omg_shared_ca_governance.xsd">
  <domain_access_rules>
    <domain_rule>
      <domains><id_range><min>0</min><max>230</max></id_range></domains>
      <allow_unauthenticated_participants>false</allow_unauthenticated_participants>
      <enable_join_access_control>true</enable_join_access_control>
      <discovery_protection_kind>ENCRYPT</discovery_protection_kind>
      <liveliness_protection_kind>ENCRYPT</liveliness_protection_kind>
      <rtps_protection_kind>NONE</rtps_protection_kind>
      <topic_access_rules>
        <topic_rule>
          <topic_expression>*</topic_expression>
          <enable_discovery_protection>true</enable_discovery_protection>
          <enable_liveliness_protection>true</enable_liveliness_protection>
          <enable_read_access_control>true</enable_read_access_control>
          <enable_write_access_control>true</enable_write_access_control>
          <metadata_protection_kind>SIGN</metadata_protection_kind>
          <data_protection_kind>ENCRYPT</data_protection_kind>
        </topic_rule>
      </topic_access_rules>
    </domain_rule>
  </domain_access_rules>
</dds>
)";

constexpr const char* permissions_format = R"(<?xml version="1.0" encoding="UTF-8"?>
<dds xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
     xsi:noNamespaceSchemaLocation="http://www.omg.org/spec/DDS-SECURITY/20170901/omg_shared_ca_permissions.xsd">
  <permissions>
    <grant name="{name}">
      <subject_name>{subject}</subject_name>
      <validity><not_before>{from}</not_before><not_after>{until}</not_after></validity>
      <allow_rule>
        <domains><id_range><min>0</min><max>230</max></id_range></domains>
{publish}{subscribe}      </allow_rule>
      <default>DENY</default>
    </grant>
  </permissions>
</dds>
)";

/// A list that is empty has no element: the schema wants a topic in it.
std::string criteria(const char* verb, const std::vector<std::string>& topics) {
  if (topics.empty()) return "";
  const auto element = [](const std::string& topic) { return "<topic>" + topic + "</topic>"; };
  return fmt::format("        <{0}><topics>{1}</topics></{0}>\n", verb,
                     joined_of(topics, element, ""));
}

std::vector<std::string> topics_in(const tinyxml2::XMLElement& rule, const char* verb) {
  std::vector<std::string> topics;
  for (auto* all = rule.FirstChildElement(verb); all != nullptr;
       all = all->NextSiblingElement(verb)) {
    const auto* const list = all->FirstChildElement("topics");
    if (list == nullptr) continue;
    for (auto* one = list->FirstChildElement("topic"); one != nullptr;
         one = one->NextSiblingElement("topic")) {
      if (one->GetText() != nullptr) topics.emplace_back(one->GetText());
    }
  }
  return topics;
}

/// Seconds since the epoch; nothing for a text that is no date.
std::optional<std::int64_t> time_in(const tinyxml2::XMLElement* element) {
  std::tm broken{};
  if (element == nullptr || element->GetText() == nullptr) return std::nullopt;
  if (strptime(element->GetText(), "%Y-%m-%dT%H:%M:%S", &broken) == nullptr) return std::nullopt;
  return timegm(&broken);
}

}  // namespace

std::string date_text(std::int64_t time_s) {
  const std::time_t time = time_s;
  std::tm broken{};
  gmtime_r(&time, &broken);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &broken);
  return text.data();
}

std::string governance_xml() { return governance_text; }

std::string permissions_xml(const Grant& grant) {
  return fmt::format(permissions_format, fmt::arg("name", grant.subject),
                     fmt::arg("subject", grant.subject), fmt::arg("from", date_text(grant.from_s)),
                     fmt::arg("until", date_text(grant.until_s)),
                     fmt::arg("publish", criteria("publish", grant.permissions.publish)),
                     fmt::arg("subscribe", criteria("subscribe", grant.permissions.subscribe)));
}

std::optional<Grant> grant_in(const std::string& permissions_xml) {
  tinyxml2::XMLDocument document;
  if (document.Parse(permissions_xml.data(), permissions_xml.size()) != tinyxml2::XML_SUCCESS) {
    return std::nullopt;
  }
  tinyxml2::XMLHandle handle(document);
  auto grant =
      handle.FirstChildElement("dds").FirstChildElement("permissions").FirstChildElement("grant");
  auto* const subject = grant.FirstChildElement("subject_name").ToElement();
  auto validity = grant.FirstChildElement("validity");
  const auto from = time_in(validity.FirstChildElement("not_before").ToElement());
  const auto until = time_in(validity.FirstChildElement("not_after").ToElement());
  auto* const rule = grant.FirstChildElement("allow_rule").ToElement();
  if (subject == nullptr || subject->GetText() == nullptr || !from || !until || rule == nullptr) {
    return std::nullopt;
  }
  return Grant{subject->GetText(),
               *from,
               *until,
               {topics_in(*rule, "publish"), topics_in(*rule, "subscribe")}};
}

}  // namespace tocsin::keystore
