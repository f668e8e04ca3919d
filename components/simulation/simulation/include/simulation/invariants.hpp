// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "sample_log/sequence_set.hpp"
#include "simulation/observer.hpp"
#include "simulation/pressed_stop.hpp"
#include "simulation/sim_world.hpp"
#include "simulation/standing_stop.hpp"

namespace tocsin::simulation {

/// A promise that was not kept.
struct Violation {
  double at_s = 0;  ///< [s] since the start of the run
  std::string text;
};

/// How much time the promises leave.
struct InvariantLimits {
  /// [s] the base stands this long after the last byte from the computer: its own timeout of 0.5 s
  /// (config/base.yaml), 0.1 s of dead time, 0.47 s from full speed at 1.5 m/s2, position period.
  double base_stops_s = 1.2;
  /// [s] and this long after the last velocity that anybody wanted: the driver's hold besides.
  double vehicle_stops_s = 2.0;
  /// [s] an emergency stop has stood for so long: no velocity but zero is commanded any more.
  double stop_commanded_s = 0.5;
  /// [s] after it was written a sample of class critical or high has been put on the radio: strict
  /// priority, on a radio whose queue holds 0.3 s at its slowest.
  double leaves_s = 0.5;
  /// [s] the mission is over so long after the last fault: Mission A takes 90, Mission C 470.
  double recovers_s = 150;
};

/// Checks what the stack promises while a world runs:
/// a router puts samples of classes critical and high on the air soon, unless its gate is closed
/// for them, and sends nothing that its gate is closed for; what the gate kept it sends soon after
/// it opens, within its lifespan; the base stops whatever dies; while an emergency stop stands on
/// the vehicle's host the base is commanded to stand and stands, whoever publishes velocities; a
/// stop that the station has pressed stands there soon after anything crosses, until it releases;
/// nothing comes later than its lifespan; the samples of a writer come in order and once; of a
/// stored topic each sample that a router has taken is given to the other host once, live or filled
/// in and then in the order of its writer, or it is still in the log when the world ends; network
/// quality is in its range; no component throws; the mission is over in time.
class Invariants : public Observer {
 public:
  explicit Invariants(const InvariantLimits& limits = {}) : limits_(limits) {}

  void on_written(const Written& written) override;
  void on_sent(const Sent& sent) override;
  void on_logged(const LoggedSample& logged) override;
  void on_given(const GivenSample& given) override;
  void on_delivered(const Delivered& delivered) override;
  void on_position(const BasePosition& base) override;
  void on_gate(const GateChange& change) override;
  void on_process(const ProcessChange& change) override;
  void on_failure(const std::string& component, const std::string& what, Time now) override;
  void on_step(Time now) override;
  /// After the run, which lasted long enough for the mission to be over.
  void on_end(const Outcome& outcome);
  /// After the world, whose routers' logs are in this folder's `<role>/store`: what of stored
  /// topics was not given is in them.
  void on_logs(const std::string& run_dir, const Outcome& outcome);

  /// The first 20.
  [[nodiscard]] const std::vector<Violation>& violations() const { return violations_; }
  [[nodiscard]] std::uint64_t checks() const { return checks_; }

 private:
  void expect(bool kept, Time now, const char* promise, const std::string& detail);
  void check_message(const Written& written);
  void see_stop(const Written& written);
  void check_stop(const BasePosition& base, bool stands);
  void on_frozen(const std::string& process);
  InvariantLimits limits_;
  double x_m_ = 0;
  double y_m_ = 0;
  std::vector<Violation> violations_;
  std::uint64_t checks_ = 0;
  /// A sample of one end, by its number there, and a time.
  struct Mark {
    std::uint64_t sequence;
    Time time;
  };
  using Marks = std::map<const TopicEnd*, Mark>;
  [[nodiscard]] bool is_closed(const TopicEnd& end) const;
  void await(const TopicEnd& end, std::uint64_t sequence, Time since);
  static void forget(Marks& marks, const std::function<bool(const TopicEnd&)>& which);
  std::set<std::string> routed_;  ///< hosts whose router has sent something
  std::set<std::string> closed_;  ///< hosts whose gate is closed
  Marks kept_;                    ///< last samples that a gate holds, and since when
  Marks awaited_;                 ///< that are to be on the radio, and until when
  Time next_due_ = Time::max();   ///< the first of these
  /// Samples of one end that another one was given.
  struct Given {
    std::uint64_t newest = 0;
    std::set<std::uint64_t> recent;
  };
  [[nodiscard]] static bool is_new(Given& given, const TopicEnd& from, std::uint64_t sequence);
  std::map<std::pair<const TopicEnd*, const TopicEnd*>, Given> given_;
  /// A stored topic in one process, as far as it was given to one host.
  struct StoredEnd {
    std::string name;                                ///< outlives the world, as its end does not
    std::map<std::uint64_t, std::uint64_t> missing;  ///< writers' sources by Written::sequence
    sample_log::SequenceSet given;
    std::uint64_t last_backfilled = 0;
  };
  [[nodiscard]] StoredEnd& stored(const TopicEnd& end);
  std::map<const TopicEnd*, StoredEnd> stored_;
  Time wanted_ = Time::min();  ///< when a velocity was last wanted
  StandingStop stop_;
  PressedStop pressed_stop_;
  std::string vehicle_;  ///< the host of the base
};

}  // namespace tocsin::simulation
