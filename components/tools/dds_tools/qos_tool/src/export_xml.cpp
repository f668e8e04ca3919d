// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>
#include <tinyxml2.h>

#include <algorithm>

#include "policy_values.hpp"
#include "vendor_xml.hpp"

namespace tocsin::qos_tool {
namespace {

using tinyxml2::XMLElement;

constexpr double least_response_delay_s = 0.005;  // of the runtime's readers

/// The values of one end.
Values values_of_end(const QosProfile& profile, bool writer) {
  QosProfile end = effective(profile);
  if (writer) return value_map(end);
  if (end.requested_reliability == RequestedReliability::best_effort) {
    end.reliability = Reliability::best_effort;
  }
  end.heartbeat_response_delay_s = std::max(end.heartbeat_response_delay_s, least_response_delay_s);
  return value_map(end);
}

void write_end(XMLElement& base, const std::vector<Place>& places, const Values& values) {
  for (const Place& place : places) {
    const std::string policy = place.policy;
    const std::string& value = policy.empty() ? place.always : values.at(policy);
    if (value.empty() || value == "[]") continue;  // nothing is said by saying nothing
    write_value(make_at(base, place.path), place, value);
  }
}

/// Fast DDS has an element for each end, called by the profile.
XMLElement& element_of_end(Vendor vendor, XMLElement& holder, const std::string& name,
                           bool writer) {
  if (vendor == Vendor::cyclone) {
    for (auto* one = holder.FirstChildElement(); one != nullptr; one = one->NextSiblingElement()) {
      if (name == one->Attribute("name")) return *one;
    }
    XMLElement* const made = holder.InsertNewChildElement("qos_profile");
    made->SetAttribute("name", name.c_str());
    return *made;
  }
  XMLElement* const made = holder.InsertNewChildElement(writer ? "data_writer" : "data_reader");
  made->SetAttribute("profile_name", name.c_str());
  return *made;
}

XMLElement& holder_of_profiles(Vendor vendor, tinyxml2::XMLDocument& document) {
  document.InsertEndChild(document.NewDeclaration());
  XMLElement* const root = document.NewElement("dds");
  document.InsertEndChild(root);
  if (vendor != Vendor::cyclone) {
    root->SetAttribute("xmlns", "http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles");
    return *root->InsertNewChildElement("profiles");
  }
  root->SetAttribute("xmlns", "http://www.omg.org/spec/DDS-XML");
  XMLElement* const library = root->InsertNewChildElement("qos_library");
  library->SetAttribute("name", "tocsin");
  return *library;
}

/// Policies that say something and have no place in the vendor's file.
void note_losses(Vendor vendor, const std::string& name, const QosProfile& profile,
                 std::vector<std::string>& lost) {
  for (const PolicyValue& one : values_of(profile)) {
    const std::string why = why_lost(vendor, one.policy);
    if (one.is_default || why.empty()) continue;
    lost.push_back(fmt::format("{}.{}: {} is lost: {}", name, one.policy, one.value, why));
  }
  const auto& names = profile.partition;
  if (vendor != Vendor::cyclone && std::count(names.begin(), names.end(), "") > 0) {
    lost.push_back(name +
                   ".partition: the partition without name is lost: Fast DDS 2.9.1 refuses "
                   "an empty <name>");
  }
}

QosProfile without_unsaid_partition(Vendor vendor, QosProfile profile) {
  auto& names = profile.partition;
  if (vendor != Vendor::cyclone)
    names.erase(std::remove(names.begin(), names.end(), ""), names.end());
  return profile;
}

}  // namespace

Exported export_xml(Vendor vendor, const std::map<std::string, QosProfile>& profiles) {
  Exported result;
  tinyxml2::XMLDocument document;
  XMLElement& holder = holder_of_profiles(vendor, document);
  for (const auto& [name, profile] : profiles) {
    note_losses(vendor, name, profile, result.lost);
    const QosProfile said = without_unsaid_partition(vendor, profile);
    for (const bool writer : {true, false}) {
      write_end(element_of_end(vendor, holder, name, writer), places(vendor, writer),
                values_of_end(said, writer));
    }
  }
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  result.xml = printer.CStr();
  return result;
}

}  // namespace tocsin::qos_tool
