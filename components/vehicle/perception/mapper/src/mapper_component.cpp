// SPDX-License-Identifier: Apache-2.0
#include "mapper/mapper_component.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/read_file.hpp"
#include "geometry/pose_message.hpp"
#include "mapping/session_bytes.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

constexpr double resolution_m = 0.05;
constexpr Duration second = std::chrono::seconds(1);
constexpr Duration anew_period = std::chrono::seconds(5);  // between paintings of the whole
constexpr std::size_t most_waiting = 40;                   // scans whose joining is late
constexpr std::size_t longest_session = 2'000'000'000;     // [byte]
constexpr double matched_m = 0.03;                         // deviation where scans are matched,
constexpr double matched_rad = 0.02;
constexpr double drift_share = 0.05;  // and what each metre without a match adds

diagnostic_msgs::msg::KeyValue value(const char* key, std::string text) {
  diagnostic_msgs::msg::KeyValue pair;
  pair.key(key);
  pair.value(std::move(text));
  return pair;
}

bool exists(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::exists(path, ignored);
}

MapWorker worker_of(const Context& context, const std::string& session) {
  auto background = context.computer.get().open_background();
  if (session.empty()) return {std::move(background), {}, resolution_m};
  return {std::move(background),
          {},
          resolution_m,
          mapping::session_in(read_file(session, longest_session), printable(session))};
}

/// Odometry of a vehicle that drives: no wheel moves it so far in that time.
bool is_jump(const geometry::Pose& step, double s) {
  constexpr double fastest_mps = 3;
  constexpr double least_m = 0.3;
  return std::hypot(step.x_m, step.y_m) > least_m + fastest_mps * std::clamp(s, 0.0, 1.0);
}

}  // namespace

/// A process that ends within its launch is followed by one that goes on with what was saved.
MapperComponent::Start MapperComponent::start_of(const StateFile& file, const Context& context,
                                                 const Params& params) {
  const std::string own = params.map_name.empty() ? "" : params.map_name + ".session";
  std::istringstream text(file.load().value_or(""));
  pid_t parent = 0;
  geometry::Pose kept;
  text >> parent >> kept.x_m >> kept.y_m >> kept.heading_rad;
  const bool is_ours = text && parent == ::getppid() && is_finite(kept);
  if (is_ours && !own.empty() && exists(own)) return {{}, own, kept};
  const bool goes_on = !own.empty() && own == params.session_file;
  const bool keeps = context.computer.get().keeps_files && !own.empty();
  for (const char* ending : {".yaml", ".session"}) {
    const std::string path = params.map_name + ending;
    if (!is_ours && !goes_on && keeps && exists(path)) {
      throw ConfigError(fmt::format(
          "{}.map_name: {} is there already; go on with it by session_file, or name another",
          context.name, printable(path)));
    }
  }
  return {{params.start_x_m, params.start_y_m, params.start_yaw_rad}, params.session_file, {}};
}

MapperComponent::MapperComponent(Context& context, const Params& params)
    : Component(context),
      map_(*this, resolution_m),
      params_(params),
      file_(context.state_path(".map")),
      keeps_files_(context.computer.get().keeps_files),
      start_(start_of(file_, context, params)),
      worker_(worker_of(context, start_.session)) {
  nodes_ = saved_nodes_ = worker_.nodes_at_start();
}

MapperComponent::~MapperComponent() {
  if (!keeps_files_ || params_.map_name.empty() || nodes_ == saved_nodes_) return;
  (void)worker_.save_map(params_.map_name);
  (void)worker_.save_session(params_.map_name);
}

void MapperComponent::tick(Time now) {
  take_odometry();
  take_calls();
  take_scan(now);
  take_news(now);
  take_saved();
  map_.publish(wall(now), now);
  send_tiles(now);
  save(now);
  publish_diagnostics(now);
  remember(now);
  const Duration look = seconds(0.1);  // at what goes on beside
  wake_at(std::min({map_.deadline(), next_diagnostics_, now + look}));
}

void MapperComponent::take_odometry() {
  while (const auto odom = odom_.take()) {
    const geometry::Pose pose = geometry::pose_in(odom->pose().pose());
    const std::int64_t stamp_ns = stamp_ns_of(odom->header());
    if (!is_finite(pose)) continue;
    const double s = static_cast<double>(stamp_ns - last_odom_ns_) * 1e-9;
    if (last_odom_ && is_jump(relative(*last_odom_, pose), s)) {
      log().warn("the odometry has jumped: it counts anew from here");
      odometry_.clear();
      if (local_) local_->on_new_odometry(*last_odom_, pose);
    }
    odometry_.add(stamp_ns, pose);
    const auto& twist = odom->twist().twist();
    velocity_ = {twist.linear().x(), twist.angular().z()};
    last_odom_ = pose;
    last_odom_ns_ = stamp_ns;
  }
}

void MapperComponent::take_scan(Time now) {
  const auto turn = scan_.take(odometry_, velocity_);
  if (!turn) return;
  const auto odometry = odometry_.at(turn->stamp_ns);
  if (!odometry) return;
  if (!local_) {
    session_ = static_cast<std::uint32_t>(turn->stamp_ns / 1'000'000'000);
    next_save_ = now + seconds(params_.save_every_s);
    begin(*turn, *odometry);
  }
  use(*turn, *odometry);
  publish_pose(*odometry, turn->stamp_ns);
}

void MapperComponent::begin(const ScanInput::Turn& turn, const geometry::Pose& odometry) {
  geometry::Pose start =
      start_.map_from_odom ? compose(*start_.map_from_odom, odometry) : start_.pose;
  if (!start_.session.empty()) {
    start = place_in_session(turn.scan, start);
    worker_.paint(true);
  }
  local_.emplace(mapping::LocalParams{}, start, worker_.nodes_at_start());
}

geometry::Pose MapperComponent::place_in_session(const laser::Scan& scan,
                                                 const geometry::Pose& guess) {
  const auto located = worker_.locate(scan, guess);
  const geometry::Pose start = located.value_or(guess);
  if (located || start_.map_from_odom) {
    log().info("goes on with {} at ({:.2f}, {:.2f})", printable(start_.session), start.x_m,
               start.y_m);
  } else {
    log().warn("{} does not show what is seen at ({:.2f}, {:.2f}): is the vehicle there?",
               printable(start_.session), guess.x_m, guess.y_m);
  }
  return start;
}

bool MapperComponent::is_full() const {
  return nodes_ >= static_cast<std::size_t>(params_.most_scans);
}

void MapperComponent::use(const ScanInput::Turn& turn, const geometry::Pose& odometry) {
  const bool was_late = std::exchange(is_late_, worker_.waiting() >= most_waiting);
  if (is_late_ && !was_late) log().warn("the map is late: scans are passed over");
  if (is_late_) return;
  const geometry::Pose before = local_->pose_at(odometry);
  auto step = local_->on_scan(odometry, turn.scan);
  if (!step) return;
  is_matched_ = step->matched;
  const double way_m = distance(position(last_pose_), position(before));
  unmatched_m_ = is_matched_ ? 0 : unmatched_m_ + way_m;
  last_pose_ = step->pose;
  if (!is_full()) return worker_.add(std::move(*step));
  if (!std::exchange(was_full_, true)) {
    log().warn("the map has its {} scans and grows no more", params_.most_scans);
  }
}

geometry::Pose MapperComponent::pose_at(const geometry::Pose& odometry) const {
  return compose(map_from_local_, local_->pose_at(odometry));
}

void MapperComponent::publish_pose(const geometry::Pose& odometry, std::int64_t stamp_ns) {
  const geometry::Pose pose = pose_at(odometry);
  const double off_m = matched_m + drift_share * unmatched_m_;
  const double off_rad = matched_rad + drift_share * unmatched_m_;
  pose_.publish_pose(pose, {off_m * off_m, 0, 0, 0, off_m * off_m, 0, 0, 0, off_rad * off_rad},
                     stamp_of(stamp_ns));
  pose_.publish_transform(compose(pose, inverse(odometry)), stamp_of(stamp_ns));
}

/// Relative ones lie where the launch does.
std::string MapperComponent::path_of(const std::string& name) const {
  return name.empty() ? params_.map_name : name;
}

void MapperComponent::take_calls() {
  while (const auto call = save_map_.take()) {
    const std::string path = path_of(call->request->map_url());
    if (path.empty()) {
      save_map_.reply(call->id, {});
    } else {
      calls_[worker_.save_map(path)] = {call->id, false};
    }
  }
  while (const auto call = serialize_.take()) {
    const std::string path = path_of(call->request->filename());
    if (path.empty()) {
      SerializePoseGraph::Response response;
      response.result(
          slam_toolbox::srv::SerializePoseGraph_Response_Constants::RESULT_FAILED_TO_WRITE_FILE);
      serialize_.reply(call->id, std::move(response));
    } else {
      calls_[worker_.save_session(path)] = {call->id, true};
    }
  }
}

void MapperComponent::take_saved() {
  for (const MapWorker::Saved& saved : worker_.take_saved()) {
    const bool is_saved = saved.error.empty();
    if (!is_saved) log().warn("{}", saved.error);
    const auto found = calls_.find(saved.ticket);
    if (found == calls_.end()) continue;
    const SaveCall call = found->second;
    calls_.erase(found);
    if (is_saved) log().info("saved {}", printable(saved.path));
    if (call.is_session) {
      using namespace slam_toolbox::srv::SerializePoseGraph_Response_Constants;
      SerializePoseGraph::Response response;
      response.result(is_saved ? RESULT_SUCCESS : RESULT_FAILED_TO_WRITE_FILE);
      serialize_.reply(call.id, std::move(response));
    } else {
      SaveMap::Response response;
      response.result(is_saved);
      save_map_.reply(call.id, std::move(response));
    }
  }
}

void MapperComponent::take_news(Time now) {
  if (local_ && now >= next_paint_ && worker_.waiting() == 0) {
    next_paint_ = now + seconds(params_.paint_every_s);
    const bool may_begin_anew = now >= next_anew_;
    if (may_begin_anew) next_anew_ = now + anew_period;
    worker_.paint(may_begin_anew);
  }
  MapWorker::News news = worker_.take_news();
  if (news.map_from_local) {
    map_from_local_ = *news.map_from_local;
    nodes_ = news.nodes;
    if (news.loops != loops_) log().info("{} places recognised", news.loops);
    loops_ = news.loops;
  }
  for (auto& [index, tile] : news.tiles) {
    if (map_.put(index, std::move(tile)) == navigation::TileMap::Put::changed) {
      queue_.on_change(index);
    }
  }
}

void MapperComponent::send_tiles(Time now) {
  if (now >= next_tile_) {
    if (const auto index = queue_.next_changed()) {
      next_tile_ = now + seconds(1 / params_.tile_hz);
      send_tile(*index, now);
    }
  }
  if (params_.repeat_hz == 0 || now < next_repeat_) return;
  next_repeat_ = now + seconds(1 / params_.repeat_hz);
  if (const auto index = queue_.next_repeat()) send_tile(*index, now);
}

void MapperComponent::send_tile(navigation::TileMap::Index index, Time now) {
  topic::MapTiles::Message message;
  message.stamp(wall(now));
  message.session(session_);
  message.column(index.column);
  message.row(index.row);
  message.resolution(static_cast<float>(resolution_m));
  message.side(navigation::TileMap::side);
  message.cells(navigation::packed(map_.tiles().tiles().at(index)));
  if (map_tiles_.write(std::move(message)) == Status::failed) queue_.on_change(index);
}

void MapperComponent::save(Time now) {
  if (!keeps_files_ || params_.map_name.empty() || !local_ || now < next_save_) return;
  next_save_ = now + seconds(params_.save_every_s);
  if (nodes_ == saved_nodes_) return;
  saved_nodes_ = nodes_;
  (void)worker_.save_map(params_.map_name);
  (void)worker_.save_session(params_.map_name);
}

void MapperComponent::publish_diagnostics(Time now) {
  if (now < next_diagnostics_) return;
  next_diagnostics_ = next_instant(second, now);
  if (!diagnostics_.wanted()) return;
  const char* const words = !local_        ? "waiting for scans and odometry"
                            : is_late_     ? "late: scans are passed over"
                            : is_full()    ? "the map is full"
                            : !is_matched_ ? "by odometry: the scans do not match"
                                           : "mapping";
  diagnostic_msgs::msg::DiagnosticStatus status;
  status.level(local_ && is_matched_ && !is_late_ && !is_full() ? 0 : 1);
  status.name(name() + ": map");
  status.message(words);
  status.values({value("scans", std::to_string(nodes_)),
                 value("places recognised", std::to_string(loops_)),
                 value("waiting", std::to_string(worker_.waiting()))});
  topic::Diagnostics::Message message;
  message.header().stamp(wall(now));
  message.status().push_back(status);
  if (diagnostics_.write(std::move(message)) == Status::failed) log().warn("no diagnostics sent");
}

void MapperComponent::remember(Time now) {
  if (!file_.keeps() || !local_ || !last_odom_ || now < next_remember_) return;
  next_remember_ = now + second;
  const geometry::Pose map_from_odom = compose(pose_at(*last_odom_), inverse(*last_odom_));
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << ::getppid() << ' ' << map_from_odom.x_m << ' ' << map_from_odom.y_m << ' '
       << map_from_odom.heading_rad;
  if (!file_.save(text.str())) log().warn("the pose cannot be saved for a restart");
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::MapperComponent)
