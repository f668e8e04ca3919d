// SPDX-License-Identifier: Apache-2.0
// Where the XML files of other vendors say what a policy of ours says.
#pragma once

#include <string>
#include <vector>

namespace tinyxml2 {
class XMLElement;
}

namespace tocsin::qos_tool {

/// How a value is written in XML.
enum class Form {
  word,     ///< our word in capitals, with the place's suffix
  seconds,  ///< <sec> and <nanosec>
  number,
  not_flag,  ///< the opposite of ours
  names,     ///< a child for each, called as the suffix says
  hex,       ///< bytes as dotted hexadecimal numbers in the child <value>
};

/// What a place of an XML file says.
struct Place {
  const char* policy;  ///< of a profile; "": of none, always `always`
  std::string path;    ///< below the element of the end: `qos/deadline/period`
  Form form;
  const char* suffix = "";  ///< of a word, or name of the child elements
  const char* always = "";  ///< value of a place of no policy, in our words
};

/// Makes `leaf` say `value`, which is in our words.
void write_value(tinyxml2::XMLElement& leaf, const Place& place, const std::string& value);

/// The child at a path, made where it is missing.
[[nodiscard]] tinyxml2::XMLElement& make_at(tinyxml2::XMLElement& base, const std::string& path);

/// A vendor's file format; Fast DDS 3 calls times otherwise than Fast DDS 2.
enum class Vendor { fast_dds, fast_dds_3, cyclone };

/// Places of a writer and of a reader. Fast DDS: below <data_writer> and <data_reader>; Cyclone
/// DDS, whose format is OMG DDS-XML 1.0: below <qos_profile>.
[[nodiscard]] const std::vector<Place>& places(Vendor vendor, bool writer);

/// Why a policy of ours has no place in the vendor's file; empty when it has.
[[nodiscard]] std::string why_lost(Vendor vendor, const std::string& policy);

}  // namespace tocsin::qos_tool
