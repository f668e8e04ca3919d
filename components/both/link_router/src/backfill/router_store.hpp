// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "devices/computer.hpp"
#include "foundation/instant.hpp"
#include "sample_log/ledger.hpp"
#include "sample_log/sample_log.hpp"

namespace tocsin {

/// What a RouterStore answers.
namespace store_answer {
struct Opened {  ///< first of all: what earlier instances left
  std::vector<sample_log::SampleId> waiting;
  std::vector<sample_log::LoggedStream> streams;
  sample_log::SampleSet delivered;
  std::string requests;  ///< that keep_requests kept
};
struct Appended {
  std::vector<std::pair<sample_log::SampleId, sample_log::Logged>> logged;
};
struct Read {
  std::vector<sample_log::SampleId> asked;
  std::vector<sample_log::LogEntry> read;
};
struct Retired {
  std::vector<sample_log::SampleId> ids;
};
struct Saved {  ///< what was delivered to the host up to here is safe
  std::uint64_t token;
};
struct Found {  ///< of a search
  std::uint64_t search;
  sample_log::LogFinding finding;
};
struct Contents {  ///< of a history, now and then
  std::vector<sample_log::LoggedSpan> spans;
};
struct Problem {
  std::string text;
};
}  // namespace store_answer
using StoreAnswer = std::variant<store_answer::Opened, store_answer::Appended, store_answer::Read,
                                 store_answer::Retired, store_answer::Saved, store_answer::Found,
                                 store_answer::Contents, store_answer::Problem>;

/// Where a store is and how it is used.
struct StorePlace {
  std::string folder;  ///< empty: there is none
  sample_log::LogLimits limits;
  sample_log::LogUse use = sample_log::LogUse::queue;
};

/// A log of what a router sends, and the ledger of what it has delivered, in one folder, used in
/// the background: nothing here waits for a disk. A folder that cannot be used, a full disk and a
/// disk that does not answer cost what would have been stored, and one line of a Problem.
///
/// One thread calls everything. `on_answer` is called by any thread when `take` has something.
class RouterStore {
 public:
  RouterStore(const Computer& computer, StorePlace place, std::function<void()> on_answer);
  /// Waits until all that was asked for is done.
  ~RouterStore();
  RouterStore(const RouterStore&) = delete;
  RouterStore& operator=(const RouterStore&) = delete;

  /// Opens the folder; again does nothing, and before it the others do nothing.
  void open(Instant at);
  void add(sample_log::LoggedStream stream);
  void append(sample_log::LogEntry entry, Instant at);
  void confirm(std::vector<sample_log::SampleId> ids);
  void read(std::vector<sample_log::SampleId> ids);
  /// Of a history: what is answered by Found with this number waits in the log from then on.
  void find(std::uint64_t search, sample_log::LogQuery query);
  /// Of a history: what was found is not wanted any more.
  void forget(std::vector<sample_log::SampleId> ids);
  /// Replaces what is kept of requests for the next instance.
  void keep_requests(std::string text);
  /// The host was delivered these. A token is answered when that is safe.
  void note_delivered(std::vector<sample_log::SampleId> ids, std::optional<std::uint64_t> token);
  /// To be called now and then: what is too old goes, and power cuts take nothing older.
  void keep(Time now);
  /// The oldest answer that was not taken yet.
  [[nodiscard]] std::optional<StoreAnswer> take();

 private:
  /// Used by the background only.
  struct Files {
    std::unique_ptr<sample_log::FolderFiles> folder;  ///< null: it cannot be used
    std::unique_ptr<sample_log::SampleLog> log;
    std::unique_ptr<sample_log::Ledger> delivered;
  };
  void open_files(Instant at);
  void append_now(const sample_log::LogEntry& entry, Instant at);
  [[nodiscard]] std::string read_requests();
  [[nodiscard]] std::string requests_file() const { return place_.folder + "/requests"; }
  void report_problems();
  void post(std::function<void()> work) {
    if (background_) background_->post(std::move(work));
  }
  void answer(StoreAnswer answer);

  const Computer& computer_;
  const StorePlace place_;
  const std::function<void()> on_answer_;
  bool is_behind_ = false;  ///< more waits than may
  Files files_;
  std::mutex mutex_;
  std::deque<StoreAnswer> answers_;
  std::unique_ptr<Background> background_;  ///< last: it uses the others
};

}  // namespace tocsin
