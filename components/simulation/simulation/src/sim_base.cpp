// SPDX-License-Identifier: Apache-2.0
#include "sim_base.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/numbers.hpp"
#include "foundation/whole_number.hpp"
#include "geometry/wall_file.hpp"
#include "kobuki_model/base_settings.hpp"
#include "laser_model/obstacle_file.hpp"

namespace tocsin::simulation {
namespace {

using Arguments = std::map<std::string, std::string>;

Arguments arguments_of(const deployment::Program& program) {
  Arguments arguments;
  for (std::size_t i = 1; i + 1 < program.command.size(); i += 2) {
    arguments[program.command[i]] = program.command[i + 1];
  }
  return arguments;
}

std::uint64_t seed_of(const std::string& text) {
  if (const auto seed = whole_number(text)) return *seed;
  throw ConfigError("kobuki_simulator --seed: '" + text + "' is not a whole number from 0");
}

void set_config(const std::string& path, BaseOptions& options) {
  const kobuki::BaseSettings settings = kobuki::load_base_settings(path);
  options.model = settings.model;
  options.line = settings.line;
}

laser::Room make_room(const BaseOptions& options) {
  std::vector<geometry::Wall> walls;
  std::vector<geometry::Wall> low;
  laser::Obstacles obstacles;
  if (!options.walls.empty()) walls = geometry::load_walls(options.walls);
  if (options.dock) low.push_back(kobuki::Dock(*options.dock).front());
  if (!options.obstacles.empty()) obstacles = laser::load_obstacles(options.obstacles);
  return {walls, low, obstacles};
}

void set_laser(Arguments& arguments, LaserOptions& options) {
  options.link = arguments["--laser"];
  if (arguments.count("--laser-profile") > 0) options.profile = arguments["--laser-profile"];
  if (arguments.count("--laser-mount") > 0) {
    options.mount =
        kobuki::parse_pose("kobuki_simulator --laser-mount", arguments["--laser-mount"]);
  }
}

}  // namespace

BaseOptions read_base_options(const deployment::Program& program) {
  Arguments arguments = arguments_of(program);
  BaseOptions options;
  options.link = arguments["--link"];
  if (options.link.empty()) throw ConfigError(program.name + ": kobuki_simulator needs --link");
  options.walls = arguments["--walls"];
  options.obstacles = arguments["--obstacles"];
  set_laser(arguments, options.laser);
  if (arguments.count("--start") > 0)
    options.start = kobuki::parse_pose("kobuki_simulator --start", arguments["--start"]);
  if (arguments.count("--dock") > 0)
    options.dock = kobuki::parse_pose("kobuki_simulator --dock", arguments["--dock"]);
  if (arguments.count("--seed") > 0) options.seed = seed_of(arguments["--seed"]);
  if (arguments.count("--config") > 0) set_config(arguments["--config"], options);
  return options;
}

class SimBase::Port final : public SerialDevice {
 public:
  explicit Port(SimBase& base) : base_(base), plugged_(base.plugged_) {}
  ~Port() override {
    if (!lost()) base_.readable_ = nullptr;
  }
  std::optional<std::size_t> read(std::uint8_t* to, std::size_t size) override {
    if (lost()) return std::nullopt;
    auto& arrived = base_.arrived_;
    const std::size_t count = std::min(size, arrived.size());
    std::copy_n(arrived.begin(), count, to);
    arrived.erase(arrived.begin(), arrived.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }
  bool write(const std::uint8_t* bytes, std::size_t size) override {
    if (lost()) return false;
    if (base_.core_.dying) return true;
    base_.commanded_ = base_.core_.now;
    base_.model_.receive({bytes, size}, base_.core_.now);
    return true;
  }

 private:
  [[nodiscard]] bool lost() const { return base_.unplugged_ || plugged_ != base_.plugged_; }
  SimBase& base_;
  int plugged_;  ///< how often it was plugged in when this was opened
};

SimBase::SimBase(Core& core, const BaseOptions& options)
    : core_(core),
      path_(options.link),
      room_(make_room(options)),
      model_(options.model, room_.touched(), options.start, options.seed, core.now),
      line_(options.line, options.seed + 1, core.now),
      quiet_line_(options.line),
      next_(model_.next_frame()) {
  if (options.dock) model_.set_dock(kobuki::Dock(*options.dock));
  if (!options.laser.link.empty()) {
    laser_.emplace(core, options.laser, room_.seen(), options.seed + 2);
  }
}

Time SimBase::next_event() const { return laser_ ? std::min(next_, laser_->next_event()) : next_; }

void SimBase::advance() {
  if (next_event() > core_.now) return;
  constexpr double ns_per_s = 1e9;
  if (room_.set_time(static_cast<double>(Core::wall_ns(core_.now)) / ns_per_s)) {
    model_.surroundings_moved();
  }
  if (laser_) laser_->advance({model_.pose(), model_.velocity()});
  if (model_.next_frame() <= core_.now) step_model();
  if (line_.last_delivery() <= core_.now) deliver();
  next_ = std::min(model_.next_frame(), line_.last_delivery());
}

void SimBase::step_model() {
  model_.step(core_.now, [this](Time sent, ByteView frame) { line_.send(frame, sent); });
}

void SimBase::deliver() {
  const std::size_t before = arrived_.size();
  line_.deliver_all(core_.now, [this](ByteView packet) {
    if (readable_) arrived_.insert(arrived_.end(), packet.begin(), packet.end());
  });
  if (arrived_.size() == before) return;
  readable_();
}

void SimBase::unplug() {
  unplugged_ = true;
  line_.clear();
  arrived_.clear();
  if (const auto tell = std::exchange(readable_, nullptr)) tell();
}

void SimBase::plug() {
  unplugged_ = false;
  ++plugged_;
}

void SimBase::set_noise(double share) {
  kobuki::LineParams params = quiet_line_;
  params.flip_probability = params.loss_probability = params.noise_probability = share / 3;
  line_.configure(share > 0 ? params : quiet_line_);
}

void SimBase::carry_off(double most_m) {
  constexpr double step_m = 0.1;
  constexpr double room_m = 0.3;  // round the middle of the base
  constexpr int directions = 12;
  const geometry::Pose from = model_.pose();
  const auto touched = room_.touched();
  geometry::Pose best = from;
  double best_m = 0;
  for (int i = 0; i < directions; ++i) {
    const double bearing_rad = from.heading_rad + i * 2 * pi / directions;
    for (double way_m = step_m; way_m <= most_m; way_m += step_m) {
      const double x_m = from.x_m + way_m * std::cos(bearing_rad);
      const double y_m = from.y_m + way_m * std::sin(bearing_rad);
      if (!touched(x_m, y_m, 0.1).empty()) break;  // a wall: what is behind may be out of reach
      if (way_m <= best_m || !touched(x_m, y_m, room_m).empty()) continue;
      best = {x_m, y_m, geometry::wrap_angle(from.heading_rad + 2)};
      best_m = way_m;
    }
  }
  model_.place(best);
}

std::unique_ptr<SerialDevice> SimBase::open(Devices::Readable readable) {
  if (unplugged_) return nullptr;
  arrived_.clear();
  readable_ = std::move(readable);
  return std::make_unique<Port>(*this);
}

}  // namespace tocsin::simulation
