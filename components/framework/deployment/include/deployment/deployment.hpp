// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "foundation/role.hpp"
#include "foundation/yaml_sources.hpp"

/// The bringup file in memory: which components run in which process, on which host.
namespace tocsin::deployment {

/// One component of a container process.
struct ComponentInstance {
  std::string component;  ///< library that offers it, also its default name
  std::string name;       ///< unique on its host
  /// A map of parameters, never null, possibly empty. Its nodes know where they were written, so
  /// `load_parameters<P>(*parameters, name, deployment.sources)` points there.
  std::shared_ptr<const YAML::Node> parameters;
  std::string place = "";  ///< "file:line" where it stands
};

/// When the health of a container's parts is no longer fine.
struct HealthLimits {
  double period_s = 1.0;
  double slow_tick_s = 0.5;
  double blocked_tick_s = 5.0;
  double overrun_share = 0.1;
  double resident_mib = 512;
  double growth_mib = 64;
  double disk_low_mib = 100;
  double stuck_s = 5;
  double memory_mib = 2048;
  template <class Visitor>
  void visit(Visitor& v) {
    v("period_s", period_s, {0.1, 60}, "[s] between reports");
    v("slow_tick_s", slow_tick_s, {0.001, 3600}, "[s] a longer tick is a WARN");
    v("blocked_tick_s", blocked_tick_s, {0.001, 3600}, "[s] a tick that runs longer is an ERROR");
    v("overrun_share", overrun_share, {0, 1}, "[1] a larger share of skipped periods is a WARN");
    v("resident_mib", resident_mib, {1, 1e6}, "[MiB] more resident memory is a WARN");
    v("growth_mib", growth_mib, {1, 1e6}, "[MiB] memory that grew by more is a WARN");
    v("disk_low_mib", disk_low_mib, {0, 1e9}, "[MiB] less room on the run folder's disk is a WARN");
    v("stuck_s", stuck_s, {1, 3600},
      "[s] a thread of DDS that does nothing for longer is an ERROR; twice as long, a restart");
    v("memory_mib", memory_mib, {16, 1e6}, "[MiB] more resident memory is a restart");
  }
};

/// Which nodes of a process have ROS 2's parameter services: six servers, twelve ends of DDS each.
enum class ParameterServices {
  on_demand,  ///< one that somebody asks; all, while a participant of ROS 2 is on the host
  always,
  never,
};
[[nodiscard]] inline constexpr std::array<const char*, 3> words_of(ParameterServices) {
  return {"on_demand", "always", "never"};
}

/// One process that runs components.
struct Container {
  std::string name;       ///< unique among the programs and containers of its host
  bool terminal = false;  ///< owns the terminal; at most one of a deployment
  std::vector<ComponentInstance> components;
  HealthLimits health = {};
  ParameterServices parameter_services = ParameterServices::on_demand;
  /// Whom a container of the station serves, of several vehicles; its topics are in the namespace
  /// of this name, also where the file has no `vehicles`. Empty: all, or there is one.
  std::string vehicle = {};
};

/// One plain process without DDS.
struct Program {
  std::string name;
  std::vector<std::string> command;  ///< program and arguments, at least the program
};

/// A second way over the link, beside the one of `address` and `peers`.
struct SecondPath {
  std::string address;             ///< IPv4, of this host on it
  std::vector<std::string> peers;  ///< IPv4 addresses of the host's peers, in the same order
};

/// One side of the radio link.
struct Host {
  std::string name;
  Role role = Role::uxv;
  std::string address;             ///< IPv4, of this host on the link
  std::vector<std::string> peers;  ///< IPv4 addresses of the other hosts
  int local_domain = 0;            ///< DDS domain id of topics that stay on this host
  std::vector<Program> programs;
  std::vector<Container> containers;
  std::string enclave = {};  ///< name of its identity in the keystore
  std::optional<SecondPath> second = {};
  /// Of a vehicle with several peers: their names in the same order. It speaks with the first one
  /// that it hears, so the order is one of preference. Else empty.
  std::vector<std::string> sites = {};
};

/// The emulated radio between the two hosts; with it each host has a network namespace.
struct Radio {
  std::string channel;      ///< absolute path of the channel's parameters
  std::string walls;        ///< absolute path of the wall segments
  std::string second = {};  ///< the channel of a second radio; empty: there is none
};

/// A site's host passes what its vehicles say on to another station, and the other way round. Its
/// routers meet the vehicles' topics in the namespace of their names on the site's domain, and are
/// in namespace `station/vehicle` themselves.
struct Relay {
  std::string site;     ///< name of the host of role uxv: for the station it is its vehicles
  std::string station;  ///< name of the host of role gcs
};

/// When and how often a process that died is started again.
struct RestartPolicy {
  double backoff_s = 0.2;  ///< [0.01, 60] wait before a restart, doubled by each one within 60 s
  double max_backoff_s = 5.0;  ///< [0.01, 600] longest wait, at least backoff_s
  int limit = 10;              ///< [0, 1000] restarts of one process within 60 s
  template <class Visitor>
  void visit(Visitor& v) {
    v("backoff_s", backoff_s, {0.01, 60},
      "[s] wait before a restart, doubled by each one within 60 s; the first comes at once");
    v("max_backoff_s", max_backoff_s, {0.01, 600}, "[s] longest wait");
    v("limit", limit, {0, 1000}, "[1] restarts of one process within 60 s");
  }
};

/// A whole bringup file. All paths are absolute, all variables replaced.
struct Deployment {
  std::string file;     ///< it was read from; for error texts
  YamlSources sources;  ///< that file, those that it extends, parameter files, settings
  std::string run_dir;  ///< folder of this run's recordings, logs and sockets
  std::string share;    ///< installed share/tocsin folder
  int seed = 1;
  std::string qos;            ///< path; empty only without containers
  std::string traffic;        ///< path; empty only without containers
  int link_domain = 2;        ///< DDS domain id of the topics that cross the radio; of several
                              ///< vehicles that of the first one, the others' follow
  std::string ros_namespace;  ///< of all topics; empty or words joined by '/'
  std::string security;       ///< folder of the link's keystore; empty: the link is open
  std::string user;           ///< whom a launch by root becomes, name or number; or empty
  /// "host/process" of those whose exits with 0 or 1 end the run: when the last one has.
  std::vector<std::string> stop_when_exits;
  RestartPolicy restart;
  std::optional<Radio> radio;
  /// One or two, in the file's order, or several vehicles, then a station; more stations where a
  /// vehicle has several sites.
  std::vector<Host> hosts;
  /// Names of the hosts that are vehicles when `vehicles` of the file names them; with a relay
  /// those that stand behind its site; else empty.
  std::vector<std::string> vehicles;
  std::optional<Relay> relay;
};

/// What the command line adds to a bringup file.
struct Overrides {
  std::string run_dir;        ///< value of ${run_dir}
  std::string share;          ///< value of ${share}
  int seed = 1;               ///< value of ${seed}
  std::optional<int> domain;  ///< in place of the file's `domain`
  std::string channel;        ///< path in place of the file's `radio.channel`; empty: none
  std::string security;       ///< path in place of the file's `security`; empty: none
  std::string qos;            ///< path in place of the file's `qos`; empty: none
  std::string traffic;        ///< path in place of the file's `traffic`; empty: none
  /// "name.key=value" or "host/name.key=value", value in YAML, an empty text without; names as in
  /// `means`.
  std::vector<std::string> set;
  /// "host/process" or "host/process/component" left out; names as in `resolve_path`.
  std::vector<std::string> without;
  std::string host;  ///< alone of those of the file, without emulated radio; empty: all
  /// Components that can be loaded; another one in the file is an error. Empty: not looked at.
  std::vector<std::string> installed;
};

/// Reads a bringup file, the files that it extends and its parameter files, and applies the
/// overrides.
/// Throws ConfigError naming file:line, key, value and what is allowed.
[[nodiscard]] Deployment load_deployment(const std::string& path, const Overrides& overrides);

/// The deployment as one self-contained YAML text; each parameter with its origin as a comment.
[[nodiscard]] std::string resolved_text(const Deployment& deployment);

/// Writes that text to a file, whole or not at all. Throws EnvironmentError when it cannot.
void write_resolved(const Deployment& deployment, const std::string& path);

/// Makes the folder of each of several vehicles and sites, and writes its part of the deployment
/// there: it is like the folder of a run of this one alone. Throws EnvironmentError.
void write_parts(const Deployment& deployment);

/// Reads what write_resolved wrote. Throws ConfigError like load_deployment. `copy`: where the same
/// text is read instead; empty: at `path`, which errors name in any case.
[[nodiscard]] Deployment load_resolved(const std::string& path, const std::string& copy = "");

/// The host that `--host` names: by its name, with or without a slash in front, or by its role when
/// no host has this name. Throws ConfigError with the choice.
[[nodiscard]] const Host& host_named(const Deployment& deployment, const std::string& given);

/// What one of several vehicles and the station are to each other: the vehicle's host, and of the
/// station what serves it or all; their link domain, peers and run folder. The whole of a
/// deployment without `vehicles`.
[[nodiscard]] Deployment part_of(const Deployment& deployment, const std::string& vehicle);
/// The part of each vehicle, or the whole.
[[nodiscard]] std::vector<Deployment> parts_of(const Deployment& deployment);
/// Of several vehicles the one that the container is on, or serves; else empty.
[[nodiscard]] std::string vehicle_of(const Deployment& deployment, const Host& host,
                                     const Container& container);
/// Of the container's topics on its host; empty or words joined by '/'.
[[nodiscard]] std::string namespace_of(const Deployment& deployment, const Host& host,
                                       const Container& container);
/// Of what its router takes from its host, and gives there.
[[nodiscard]] std::string routed_namespace_of(const Deployment& deployment,
                                              const Container& container);
/// Names of those whom the container's router listens to on the link; empty: it does not matter.
[[nodiscard]] std::vector<std::string> peer_names_of(const Deployment& deployment, const Host& host,
                                                     const Container& container);
/// The folder for a host's files in that of a run, or of a vehicle's part of it: of several sites
/// each but the first has one of its own.
[[nodiscard]] std::string folder_of(const Deployment& deployment, const Host& host);
/// The folder for the files of the container's components.
[[nodiscard]] std::string run_dir_of(const Deployment& deployment, const Host& host,
                                     const Container& container);
/// Null when there is no such host or container.
[[nodiscard]] const Host* find_host(const Deployment& deployment, const std::string& name);
[[nodiscard]] const Container* find_container(const Host& host, const std::string& name);
/// The folder of the host's identity for the link; empty when the link is open.
[[nodiscard]] std::string enclave_of(const Deployment& deployment, const Host& host);
/// Whether one of the host's containers has the component `link_router`: then that alone speaks on
/// the link.
[[nodiscard]] bool is_routed(const Host& host);
/// Whether a component of the chain before the wheels runs on one of its hosts: kobuki_driver,
/// safety_controller, velocity_mux or velocity_smoother; with a relay behind its site. Then the
/// vehicle obeys this stack's emergency stop; without them a gateway carries the topics of
/// another's robot.
[[nodiscard]] bool drives_a_vehicle(const Deployment& deployment);

}  // namespace tocsin::deployment
