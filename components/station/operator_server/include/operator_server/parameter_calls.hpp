// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "operator_server/hub.hpp"
#include "operator_server/service_calls.hpp"

namespace tocsin::foxglove {

/// Reads and sets parameters of the host's nodes, by ROS 2's services, for clients.
class ParameterCalls {
 public:
  /// A node that does not answer for `patience` has no parameters.
  ParameterCalls(Component& owner, Duration patience) : owner_(owner), patience_(patience) {}

  /// The nodes that there are, without slashes.
  void set_nodes(const std::set<std::string>& nodes) { nodes_ = nodes; }
  void ask(const AskParameters& order, Hub& hub, Time now);
  void change(const ChangeParameters& order, Hub& hub, Time now);
  /// Hands what came of calls to the hub.
  void take(Hub& hub, Time now);

 private:
  enum class Kind { list, get, set };
  /// What one client wants of any number of nodes.
  struct Job {
    ClientId client;
    std::optional<std::string> id;
    std::size_t open = 0;  ///< calls under way
    std::vector<Parameter> values = {};
  };
  using JobNumber = std::uint64_t;
  struct Pending {
    JobNumber job;
    std::vector<std::string> names;  ///< that are asked for, or set
  };
  struct Caller {
    std::unique_ptr<AnyClient> client;
    std::map<CallNumber, Pending> pending = {};
    Time last_used{};
  };
  using Where = std::pair<std::string, Kind>;  ///< node and service
  using Message = std::shared_ptr<const void>;

  Caller& caller(const Where& where);
  void call(const Where& where, Message request, Pending pending, Time now);
  void list(const std::string& node, JobNumber job, Time now);
  void get(const std::string& node, std::vector<std::string> names, JobNumber job, Time now);
  /// Answers the client when nothing of its job is under way any more.
  void finish(JobNumber number, Hub& hub);
  void on_answer(const Where& where, const Pending& pending, const Message& response, Hub& hub,
                 Time now);
  void on_values(const std::string& node, const Pending& pending, const Message& response);
  void on_set(const std::string& node, const Pending& pending, const Message& response, Hub& hub);

  Component& owner_;
  const Duration patience_;
  std::set<std::string> nodes_;
  std::map<Where, Caller> callers_;
  JobNumber last_job_ = 0;
  std::map<JobNumber, Job> jobs_;
  std::map<std::string, std::uint8_t> types_;  ///< of parameters that were read
};

}  // namespace tocsin::foxglove
