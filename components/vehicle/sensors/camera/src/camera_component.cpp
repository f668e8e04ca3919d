// SPDX-License-Identifier: Apache-2.0
#include "camera/camera_component.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "camera/jpeg.hpp"
#include "geometry/pose_message.hpp"
#include "geometry/wall_file.hpp"
#include "laser_model/obstacle_file.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

/// The view of a pose on the floor; empty when a part of it is not finite.
std::optional<geometry::Pose> to_view(const topic::Location::Message& message) {
  const geometry::Pose pose = geometry::pose_in(message.pose().pose());
  return is_finite(pose) ? std::optional(pose) : std::nullopt;
}

/// Whether the law of picture sizes was fitted to these parameters.
bool is_fitted(const CameraComponent::Params& params) {
  const CameraComponent::Params fitted;
  const camera::CameraParams& a = params.camera;
  const camera::CameraParams& b = fitted.camera;
  return params.quality == fitted.quality && a.width == b.width && a.height == b.height &&
         a.field_of_view_deg == b.field_of_view_deg && a.camera_height_m == b.camera_height_m &&
         a.sensor_noise == b.sensor_noise;
}

std::vector<geometry::Wall> with_what_stands(std::vector<geometry::Wall> walls,
                                             const laser::Obstacles& obstacles) {
  const auto add = [&walls](const std::vector<geometry::Wall>& sides) {
    walls.insert(walls.end(), sides.begin(), sides.end());
  };
  add(laser::sides_of(obstacles.boxes));
  for (const laser::Disc& disc : obstacles.discs) add(laser::sides_of(disc));
  return walls;
}

}  // namespace

CameraComponent::CameraComponent(Context& context, const Params& params)
    : Component(context),
      params_(params),
      obstacles_(params.obstacles_file.empty() ? laser::Obstacles()
                                               : laser::load_obstacles(params.obstacles_file)),
      walls_(with_what_stands(geometry::load_walls(params.walls_file), obstacles_)),
      period_(seconds(1 / params.rate_hz)),
      pose_timeout_(seconds(params.pose_timeout_s)) {
  const bool draws =
      context.computer.get().has_spectators || params.in_simulated_time == Pictures::drawn;
  if (draws) renderer_.emplace(params.camera, walls_);
}

void CameraComponent::tick(Time now) {
  take_budget(now);
  take_location(now);
  const bool fresh = view_ && now - view_time_ <= pose_timeout_;
  if (!fresh) return;  // the next location wakes
  if (now >= next_picture_) {
    next_picture_ = next_instant(period_, now);
    if (const auto size = stream_.next(now)) publish(*size, now);
  }
  wake_at(next_picture_);
}

void CameraComponent::take_location(Time now) {
  const auto message = location_.take_latest();
  const auto view = message ? to_view(*message) : std::nullopt;
  if (!view) return;
  view_ = view;
  view_time_ = now;
}

void CameraComponent::take_budget(Time now) {
  const auto message = budget_.take_latest();
  if (!message) return;
  for (const auto& stream : message->streams()) {
    if (stream.topic() != topic::CameraImage::info.name) continue;
    stream_.set_budget(static_cast<double>(stream.scale()), stream.hold(), now);
  }
}

void CameraComponent::publish(double size, Time now) {
  const std::shared_ptr<Picture> picture = unused_picture();
  picture->header().stamp(wall(now));
  picture->header().frame_id("camera");
  picture->format("jpeg");
  fill(*picture, size);
  if (image_.write(picture) == Status::failed) log().warn("a picture was not sent");
}

/// One of zeros that everybody else has let go, so that its memory serves again.
std::shared_ptr<CameraComponent::Picture> CameraComponent::unused_picture() {
  constexpr std::size_t most = 8;
  const auto found = std::find_if(pictures_.begin(), pictures_.end(),
                                  [](const auto& one) { return one.use_count() == 1; });
  if (found != pictures_.end()) return *found;
  auto fresh = std::make_shared<Picture>();
  const bool is_zeros = !renderer_ && size_;
  if (!is_zeros || pictures_.size() == most) return fresh;
  return pictures_.emplace_back(std::move(fresh));
}

void CameraComponent::fill(Picture& picture, double size) {
  if (renderer_) {
    picture.data(draw(size));
  } else {
    picture.data().resize(static_cast<std::size_t>(size * static_cast<double>(full_size())));
  }
}

std::vector<geometry::Wall> CameraComponent::people() {
  constexpr double ns_per_s = 1e9;
  const double now_s = static_cast<double>(bus().wall_ns(bus().now())) / ns_per_s;
  std::vector<geometry::Wall> people;
  for (const laser::Walker& walker : obstacles_.walkers) {
    const auto sides = laser::sides_of(laser::Disc{place_of(walker, now_s), walker.radius_m});
    people.insert(people.end(), sides.begin(), sides.end());
  }
  return people;
}

std::vector<std::uint8_t> CameraComponent::draw(double size) {
  const camera::Picture picture = renderer_->render(*view_, frame_++, people());
  return camera::encode_jpeg(picture, size < 1 ? quality_for(size, picture) : params_.quality);
}

/// The law is that of the first picture which must be smaller.
int CameraComponent::quality_for(double size, const camera::Picture& picture) {
  constexpr std::array parts{0.05, 0.15, 0.3, 0.5, 0.75, 1.0};
  if (qualities_.empty()) {
    for (const double part : parts) {
      const int quality = std::max(1, static_cast<int>(part * params_.quality));
      qualities_.add(quality, camera::encode_jpeg(picture, quality).size());
    }
  }
  return qualities_.quality_for(size);
}

/// With other parameters than those of the law one picture is drawn to fit the size to them.
std::size_t CameraComponent::full_size() {
  if (!size_) {
    size_.emplace(params_.camera.field_of_view_deg, walls_);
    if (!is_fitted(params_)) calibrate();
  }
  return size_->bytes(*view_);
}

void CameraComponent::calibrate() {
  renderer_.emplace(params_.camera, walls_);
  size_->calibrate(*view_, draw(1).size());
  renderer_.reset();
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::CameraComponent)
