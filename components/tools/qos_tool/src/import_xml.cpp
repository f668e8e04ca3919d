// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>
#include <tinyxml2.h>

#include <algorithm>
#include <optional>
#include <set>

#include "foundation/error.hpp"
#include "policy_values.hpp"
#include "vendor_xml.hpp"
#include "xml_wires.hpp"

namespace tocsin::qos_tool {
namespace {

using tinyxml2::XMLElement;

/// What a file says of one end of one profile.
struct ImportedEnd {
  Values values;               ///< of all policies that have a place
  std::set<std::string> said;  ///< those that the file names
};

/// The profiles of one file.
class Reading {
 public:
  Reading(Vendor vendor, Imported& result) : vendor_(vendor), result_(result) {}

  void read(const std::string& name, const XMLElement& element, bool writer) {
    ImportedEnd& end = (writer ? writers_ : readers_)[name];
    std::set<const XMLElement*> understood;
    for (const Place& place : places(vendor_, writer))
      read_place(name, element, place, end, understood);
    note_rest(name, element, writer, understood);
  }
  void finish();

 private:
  void read_place(const std::string& name, const XMLElement& element, const Place& place,
                  ImportedEnd& end, std::set<const XMLElement*>& understood);
  void note_rest(const std::string& name, const XMLElement& element, bool writer,
                 const std::set<const XMLElement*>& understood);
  [[nodiscard]] bool is_of_other_end(const XMLElement& element, bool writer) const;
  [[nodiscard]] Values merged(const std::string& name, const ImportedEnd& writer,
                              const ImportedEnd& reader);
  void lose(const std::string& name, const std::string& what) {
    result_.lost.push_back(name + ": " + what);
  }

  Vendor vendor_;
  Imported& result_;
  std::map<std::string, ImportedEnd> writers_;
  std::map<std::string, ImportedEnd> readers_;
};

void Reading::read_place(const std::string& name, const XMLElement& element, const Place& place,
                         ImportedEnd& end, std::set<const XMLElement*>& understood) {
  const std::string policy = place.policy;
  const XMLElement* const leaf = find_at(element, place.path);
  if (leaf == nullptr) {
    if (!policy.empty()) end.values.emplace(policy, place.absent);
    return;
  }
  understood.insert(leaf);
  const auto value = read_value(*leaf, place);
  if (!value) {
    return lose(name, fmt::format("{} (line {}): its value is not understood", place.path,
                                  leaf->GetLineNum()));
  }
  if (policy.empty()) {
    if (*value == place.absent) return;
    return lose(name, fmt::format("{} {} (line {}): is always {} here", place.path, *value,
                                  leaf->GetLineNum(), place.absent));
  }
  const auto known = end.values.find(policy);
  if (known != end.values.end() && end.said.count(policy) != 0) {
    if (known->second == *value) return;
    return lose(name, fmt::format("{} {} (line {}): topics here have one instance", place.path,
                                  *value, leaf->GetLineNum()));
  }
  end.said.insert(policy);
  try {
    (void)settled_profile_of({{policy, *value}}, name, [](const auto&...) {});
    end.values[policy] = *value;
  } catch (const ConfigError& error) {
    end.values[policy] = place.absent;
    lose(name, fmt::format("{} (line {}): {}; {} instead", place.path, leaf->GetLineNum(),
                           error.what(), place.absent));
  }
}

/// In DDS-XML both ends stand below one element.
bool Reading::is_of_other_end(const XMLElement& element, bool writer) const {
  if (vendor_ != Vendor::cyclone) return false;
  const std::string name = element.Name();
  if (writer) return name == "datareader_qos" || name == "subscriber_qos";
  return name != "datareader_qos" && name != "subscriber_qos";
}

void Reading::note_rest(const std::string& name, const XMLElement& element, bool writer,
                        const std::set<const XMLElement*>& understood) {
  for (const auto* one = element.FirstChildElement(); one != nullptr;
       one = one->NextSiblingElement()) {
    const bool is_end = std::string(element.Name()) == "qos_profile";
    if (understood.count(one) != 0 || (is_end && is_of_other_end(*one, writer))) continue;
    if (one->FirstChildElement() != nullptr) {
      note_rest(name, *one, writer, understood);
    } else {
      lose(name, fmt::format("<{}> in <{}> (line {}): no policy of ours", one->Name(),
                             element.Name(), one->GetLineNum()));
    }
  }
}

/// Policies that only readers have.
bool is_of_readers(const std::string& policy) {
  return policy == "initial_acknack_delay_s" || policy == "heartbeat_response_delay_s" ||
         policy == "minimum_separation_s";
}

Values Reading::merged(const std::string& name, const ImportedEnd& writer,
                       const ImportedEnd& reader) {
  Values values = writer.values;
  for (const auto& [policy, value] : reader.values) {
    const auto offered = values.find(policy);
    if (is_of_readers(policy) || offered == values.end()) {
      values[policy] = value;
    } else if (offered->second != value && policy == "reliability" && value == "best_effort") {
      values["requested_reliability"] = "best_effort";
    } else if (offered->second != value) {
      lose(name, fmt::format("its readers have {} {}; ours have what writers have, {}", policy,
                             value, offered->second));
    }
  }
  return values;
}

void Reading::finish() {
  std::set<std::string> names;
  for (const auto* const ends : {&writers_, &readers_}) {
    for (const auto& one : *ends) names.insert(one.first);
  }
  for (const std::string& name : names) {
    const auto writer = writers_.find(name);
    const auto reader = readers_.find(name);
    const bool both = writer != writers_.end() && reader != readers_.end();
    const Values values = both ? merged(name, writer->second, reader->second)
                               : (writer != writers_.end() ? writer : reader)->second.values;
    result_.profiles[name] =
        settled_profile_of(values, name, [&](const QosConflict& broken, const std::string& value) {
          lose(name, broken.policy + " " + value + ": " + broken.reason + "; its default instead");
        });
  }
}

std::string attribute(const XMLElement& element, const char* name) {
  const char* const value = element.Attribute(name);
  return value == nullptr ? "" : value;
}

void read_fast_dds(const XMLElement& root, Reading& reading, Imported& result) {
  const XMLElement* const profiles =
      std::string(root.Name()) == "profiles" ? &root : root.FirstChildElement("profiles");
  if (profiles == nullptr) return;
  for (const auto* one = profiles->FirstChildElement(); one != nullptr;
       one = one->NextSiblingElement()) {
    const std::string kind = one->Name();
    const std::string name = attribute(*one, "profile_name");
    if (kind == "data_writer" || kind == "publisher") {
      reading.read(name, *one, true);
    } else if (kind == "data_reader" || kind == "subscriber") {
      reading.read(name, *one, false);
    } else {
      result.lost.push_back(
          fmt::format("<{}> {} (line {}): no profile of a topic", kind, name, one->GetLineNum()));
    }
  }
}

void read_dds_xml(const XMLElement& root, Reading& reading) {
  for (const auto* library = root.FirstChildElement("qos_library"); library != nullptr;
       library = library->NextSiblingElement("qos_library")) {
    for (const auto* one = library->FirstChildElement("qos_profile"); one != nullptr;
         one = one->NextSiblingElement("qos_profile")) {
      const std::string name = attribute(*one, "name");
      const bool has_reader = one->FirstChildElement("datareader_qos") != nullptr;
      if (one->FirstChildElement("datawriter_qos") != nullptr || !has_reader) {
        reading.read(name, *one, true);
      }
      if (has_reader) reading.read(name, *one, false);
    }
  }
}

Vendor vendor_of(const XMLElement& root, const std::string& file) {
  const std::string name = root.Name();
  if (name == "CycloneDDS") return Vendor::cyclone;
  if (name == "profiles") return Vendor::fast_dds;
  if (name == "dds" && root.FirstChildElement("qos_library") != nullptr) return Vendor::cyclone;
  if (name == "dds") return Vendor::fast_dds;
  throw ConfigError(file + ": <" + name +
                    "> is neither a profiles file of Fast DDS (<dds> or <profiles>) nor one of "
                    "Cyclone DDS (<dds> with <qos_library>, or <CycloneDDS>)");
}

}  // namespace

Imported import_xml(const std::string& text, const std::string& name) {
  tinyxml2::XMLDocument document;
  if (document.Parse(text.c_str(), text.size()) != tinyxml2::XML_SUCCESS ||
      document.RootElement() == nullptr) {
    throw ConfigError(name + ": is no XML" +
                      (document.ErrorLineNum() > 0
                           ? " (line " + std::to_string(document.ErrorLineNum()) + ")"
                           : ""));
  }
  const XMLElement& root = *document.RootElement();
  Imported result;
  result.vendor = vendor_of(root, name);
  Reading reading(result.vendor, result);
  if (result.vendor == Vendor::fast_dds) {
    read_fast_dds(root, reading, result);
  } else {
    read_dds_xml(root, reading);
  }
  reading.finish();
  result.wires = wires_of(result.vendor, root);
  return result;
}

}  // namespace tocsin::qos_tool
