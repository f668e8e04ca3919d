// SPDX-License-Identifier: Apache-2.0
#include "backfill/router_store.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/read_file.hpp"
#include "foundation/replace_file.hpp"

namespace tocsin {
namespace {

/// Entries that wait for a disk that does not answer; beyond them none is taken.
constexpr std::size_t most_waiting = 4096;
constexpr std::size_t longest_requests = 1'000'000;  // [byte]

}  // namespace

RouterStore::RouterStore(const Computer& computer, StorePlace place,
                         std::function<void()> on_answer)
    : computer_(computer), place_(std::move(place)), on_answer_(std::move(on_answer)) {}

RouterStore::~RouterStore() { background_.reset(); }

void RouterStore::open(Instant at) {
  if (background_) return;
  background_ = computer_.open_background();
  post([this, at] { open_files(at); });
}

void RouterStore::open_files(Instant at) {
  store_answer::Opened opened;
  try {
    if (place_.folder.empty()) throw ConfigError("there is no folder for stored samples");
    files_.folder = std::make_unique<sample_log::FolderFiles>(place_.folder);
    files_.log =
        std::make_unique<sample_log::SampleLog>(*files_.folder, place_.limits, at, place_.use);
    files_.delivered = std::make_unique<sample_log::Ledger>(*files_.folder, "given");
    opened.waiting = files_.log->waiting();
    for (const auto& entry : files_.log->streams()) opened.streams.push_back(entry.second);
    opened.delivered = files_.delivered->done();
    opened.requests = read_requests();
  } catch (const ConfigError& error) {
    answer(store_answer::Problem{std::string(error.what()) + "; nothing is stored"});
  }
  answer(std::move(opened));
  report_problems();
}

std::string RouterStore::read_requests() {
  try {
    if (!std::filesystem::exists(requests_file())) return "";
    return read_file(requests_file(), longest_requests);
  } catch (const ConfigError& error) {
    answer(store_answer::Problem{error.what()});
    return "";
  }
}

void RouterStore::add(sample_log::LoggedStream stream) {
  post([this, stream = std::move(stream)] {
    if (files_.log) files_.log->add(stream);
  });
}

void RouterStore::append(sample_log::LogEntry entry, Instant at) {
  if (!background_) return;
  const bool was_behind = std::exchange(is_behind_, background_->waiting() >= most_waiting);
  if (!is_behind_) {
    return post([this, entry = std::move(entry), at] { append_now(entry, at); });
  }
  if (!was_behind) answer(store_answer::Problem{place_.folder + ": the disk does not keep up"});
  answer(store_answer::Appended{{{entry.id, sample_log::Logged::refused}}});
}

void RouterStore::append_now(const sample_log::LogEntry& entry, Instant at) {
  store_answer::Appended appended{{{entry.id, sample_log::Logged::refused}}};
  if (files_.log) appended.logged[0].second = files_.log->append({entry}, at).at(0);
  answer(std::move(appended));
  report_problems();
}

void RouterStore::confirm(std::vector<sample_log::SampleId> ids) {
  if (ids.empty()) return;
  post([this, ids = std::move(ids)] {
    if (files_.log) files_.log->confirm(ids);
  });
}

void RouterStore::read(std::vector<sample_log::SampleId> ids) {
  if (ids.empty()) return;
  post([this, ids = std::move(ids)] {
    store_answer::Read read{ids, {}};
    if (files_.log) read.read = files_.log->read(ids);
    answer(std::move(read));
    report_problems();
  });
}

void RouterStore::find(std::uint64_t search, sample_log::LogQuery query) {
  post([this, search, query = std::move(query)] {
    store_answer::Found found{search, {}};
    if (files_.log) found.finding = files_.log->find(query);
    answer(std::move(found));
    report_problems();
  });
}

void RouterStore::forget(std::vector<sample_log::SampleId> ids) {
  if (ids.empty()) return;
  post([this, ids = std::move(ids)] {
    if (files_.log) files_.log->forget(ids);
  });
}

void RouterStore::keep_requests(std::string text) {
  post([this, text = std::move(text)] {
    if (!files_.folder) return;
    const std::error_code error = replace_file(requests_file(), text);
    if (error) answer(store_answer::Problem{requests_file() + ": " + error.message()});
  });
}

void RouterStore::note_delivered(std::vector<sample_log::SampleId> ids,
                                 std::optional<std::uint64_t> token) {
  if (ids.empty() && !token) return;
  post([this, ids = std::move(ids), token] {
    if (files_.delivered) {
      for (const sample_log::SampleId& id : ids) files_.delivered->add(id);
      (void)files_.delivered->save();  // what fails is tried again with the next
    }
    if (token) answer(store_answer::Saved{*token});
  });
}

void RouterStore::keep(Time now) {
  post([this, now] {
    if (!files_.log) return;
    store_answer::Retired retired{files_.log->retire(now)};
    if (!retired.ids.empty()) answer(std::move(retired));
    if (place_.use == sample_log::LogUse::history) {
      answer(store_answer::Contents{files_.log->contents()});
    }
    files_.log->sync();
    files_.delivered->sync();
  });
}

void RouterStore::report_problems() {
  if (!files_.log) return;
  for (std::string& text : files_.log->take_problems()) {
    answer(store_answer::Problem{place_.folder + ": " + std::move(text)});
  }
}

void RouterStore::answer(StoreAnswer answer) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    answers_.push_back(std::move(answer));
  }
  on_answer_();
}

std::optional<StoreAnswer> RouterStore::take() {
  if (!background_) return std::nullopt;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (answers_.empty()) return std::nullopt;
  StoreAnswer next = std::move(answers_.front());
  answers_.pop_front();
  return next;
}

}  // namespace tocsin
