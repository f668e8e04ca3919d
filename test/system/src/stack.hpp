// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace tocsin {

/// How a program ended, and all that it printed.
struct Ended {
  int code = -1;  ///< -1: by a signal
  std::string output;
};

/// Runs an installed program to its end, with a shell's words behind it.
[[nodiscard]] Ended run_to_end(const std::string& program, const std::string& arguments);

/// A bringup file: gateway.yaml with both hosts on this computer, over an emulated radio.
inline constexpr const char* gateway_on_one_computer =
    "extends: gateway.yaml\n"
    "radio:\n"
    "  channel: ${share}/config/radio/open.yaml\n"
    "  walls: ${share}/config/maps/classroom.walls.yaml\n";

/// A running `tocsin launch` with a run folder of its own, which is removed in the end; the
/// launcher is stopped when it still runs.
class Stack {
 public:
  /// `arguments` follow `tocsin launch`. `--run-dir` is added. `disk_mib`: size of a disk of its
  /// own for the run folder, which only its processes see as such; 0: none.
  explicit Stack(const std::vector<std::string>& arguments, int disk_mib = 0);
  ~Stack();
  Stack(const Stack&) = delete;
  Stack& operator=(const Stack&) = delete;

  /// Path of an installed program.
  [[nodiscard]] static std::string program(const std::string& name);
  /// Path of the installation's setup.bash.
  [[nodiscard]] static std::string setup();
  /// Path of an installed file below share/tocsin.
  [[nodiscard]] static std::string share(const std::string& name);
  /// True as soon as `condition` holds; false when `limit` passes before.
  static bool eventually(std::chrono::seconds limit, const std::function<bool()>& condition);

  /// Whole text of a file in the run folder, empty when there is none.
  [[nodiscard]] std::string read(const std::string& name) const;
  /// The fields of a topic that the recorder of a side has written so far, as a CSV text.
  [[nodiscard]] std::string recorded(const std::string& side, const std::string& topic) const;
  [[nodiscard]] bool logged(const std::string& text) const;
  /// Everything that the launcher printed.
  [[nodiscard]] std::string output() const;
  /// Names of the processes that run now, and the process id of one (0 when it does not run, or is
  /// not in its host's network yet).
  [[nodiscard]] std::vector<std::string> processes() const;
  [[nodiscard]] pid_t pid(const std::string& process) const;
  /// The same, once it runs. Errors: std::runtime_error when it does not within half a minute.
  [[nodiscard]] pid_t running(const std::string& process) const;
  /// Fills the disk of the run folder to the last byte with a file of this name.
  void fill_disk(const std::string& name) const;
  /// Removes the run folder under those who write there meanwhile. False when it stays.
  [[nodiscard]] bool remove_folder() const;
  /// Sends a line to a control socket of the run folder, for example radio.sock.
  void control(const std::string& socket, const std::string& line) const;
  /// The launcher's exit code; -1 when it did not end within `limit`.
  int exit_code(std::chrono::seconds limit);
  [[nodiscard]] const std::string& folder() const { return folder_; }
  /// A file of the run folder as this process reaches it.
  [[nodiscard]] std::string path(const std::string& name) const;
  /// A folder beside it, for what belongs to the test; lives as long as this.
  [[nodiscard]] const std::string& scratch() const { return top_; }
  [[nodiscard]] pid_t launcher() const { return launcher_; }
  /// Keeps the run folder, for a person to look at after a failure.
  void keep() { keep_ = true; }

 private:
  std::string top_;
  std::string folder_;
  bool own_disk_;
  pid_t launcher_ = -1;
  int code_ = -1;
  bool keep_ = false;
};

/// Whether the vehicle has driven, by what it has recorded.
[[nodiscard]] bool is_driving(const Stack& stack);

/// Whether the last two locations of a CSV text, 0.2 s apart, are two places.
[[nodiscard]] bool moves_in(const std::string& locations);

/// Rows of a CSV text as cells of the named column; quoted cells may hold commas.
[[nodiscard]] std::vector<std::string> column(const std::string& csv, const std::string& name);

}  // namespace tocsin
