// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace tocsin {

/// One class of a role in a traffic file.
struct ClassEntry {
  std::string while_poor = "send";
  std::vector<std::string> topics;
  std::vector<std::string> adaptive;
  std::vector<std::string> on_demand;
  std::vector<std::string> compress;
  std::vector<std::string> store;
  std::vector<std::string> log;
  std::vector<std::string> keep;
  std::vector<std::string> services;
  std::vector<std::string> actions;
  double max_rate_hz = 0;
  double lifespan_s = 0;
  int depth = 1;
  double call_deadline_s = 5;
  template <class Visitor>
  void visit(Visitor& v) {
    v("while_poor", while_poor, {"send", "latest", "drop", "store"},
      "what the gate does with new samples");
    v("topics", topics, "ROS names of the topics of this class, or patterns with * and ?");
    v("adaptive", adaptive, "those of them whose writers follow the link's budget");
    v("on_demand", on_demand,
      "those of them that cross while somebody on the other side reads them, and not otherwise");
    v("compress", compress,
      "those of them that cross as what is new in them, where that is less; or patterns that fit "
      "them");
    v("store", store, "those of them of which nothing is lost: a log keeps what does not cross");
    v("log", log,
      "topics of this class, or of none, that a log keeps: what did not cross does when asked for");
    v("keep", keep,
      "those of them, or patterns, that the other side's log keeps as they arrive, for late "
      "readers");
    v("max_rate_hz", max_rate_hz, {0, 1000},
      "[1/s] of each writer of its topics at most so many samples cross; 0: all");
    v("lifespan_s", lifespan_s, {0, 1e6},
      "[s] older samples do not cross; 0: what their writers offer");
    v("depth", depth, {1, 10000}, "[1] newest samples of each writer that count on the link");
    v("services", services, "ROS names of services that this side serves for the other");
    v("actions", actions, "ROS names of actions that this side serves for the other");
    v("call_deadline_s", call_deadline_s, {0.1, 600},
      "[s] a call of these without a reply is given up; not the wait for an action's result");
  }
};

}  // namespace tocsin
