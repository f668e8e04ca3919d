// SPDX-License-Identifier: Apache-2.0
// The cases of the OMG's DDS interoperability suite (omg-dds/dds-rtps, July 2026), and what comes
// of each with one side on our runtime and the other on Cyclone DDS 0.10.2.
#pragma once

#include <string>
#include <vector>

namespace tocsin::interop {

/// What a program of a case came to, as the suite calls it.
enum class Code {
  ok,
  incompatible_qos,
  reader_not_matched,
  data_not_received,
  data_not_correct,
  deadline_missed,
  receiving_from_one,
  receiving_from_both,
  unsupported,
  not_created,
};
[[nodiscard]] const char* word_of(Code code);

/// How a subscriber's samples are looked at.
enum class Check {
  received,     ///< one came
  in_order,     ///< sizes of a colour grow
  no_losses,    ///< and none is missing
  sizes,        ///< of how many sizes they are
  colors,       ///< of how many colours
  at_most_20,   ///< no size above 20
  separated,    ///< stamps of a colour are `limit` ms apart, and some were dropped
  short_lived,  ///< read within a lifespan of `limit` ms, and some have expired
  newest_kept,  ///< none is missing but before the `limit` newest of a read
  first_kept,   ///< the first one written came
  first_gone,   ///< it did not: the reader came later
  no_writers,   ///< four instances ended without writers
  disposed,     ///< four instances were disposed of
  ballast,      ///< with the last byte of a large payload
  deadline,
};

/// A case of the suite: publishers, then one subscriber.
struct ShapeCase {
  std::string name;
  std::vector<std::string> apps;
  std::vector<Code> expected;
  Check check = Check::received;
  int limit = 0;  ///< see Check
};
[[nodiscard]] const std::vector<ShapeCase>& shape_cases();

/// Who publishes; the other side subscribes.
enum class Side { ours, cyclone };

/// Why a case comes to something else than the suite expects, and to what. Empty `why`: it does
/// not.
struct Departure {
  std::vector<Code> codes;
  std::string why;
};
[[nodiscard]] Departure departure(const ShapeCase& its, Side publisher);

/// What a program's output says. Cases with a `limit` are judged by the stamps that a subscriber
/// prints with --stamps, so a busy machine changes how much it reads and not the verdict.
[[nodiscard]] Code code_of_publisher(const std::vector<std::string>& output, bool prints);
[[nodiscard]] Code code_of_subscriber(const std::vector<std::string>& output, Check check,
                                      int limit = 0);

/// Whether a subscriber's output needs no more lines.
[[nodiscard]] bool is_enough(const std::vector<std::string>& output, Check check);

}  // namespace tocsin::interop
