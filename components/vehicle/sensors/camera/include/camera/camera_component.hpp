// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "camera/adaptive_stream.hpp"
#include "camera/picture_size.hpp"
#include "camera/renderer.hpp"
#include "foundation/enum_words.hpp"
#include "foundation/parameters.hpp"
#include "geometry/wall.hpp"
#include "laser_model/scene.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// What pictures are where nobody can look at them.
enum class Pictures { sized, drawn };
constexpr std::array<const char*, 2> words_of(Pictures) { return {"sized", "drawn"}; }

/// A simulated camera: pictures of the map from where the vehicle reports to be. In simulated time,
/// where drawing would take most of the computing, pictures are zeros, as many as the JPEG had. It
/// follows the budget of the link in rate and size.
class CameraComponent final : public Component {
 public:
  struct Params {
    std::string walls_file;
    std::string obstacles_file;
    double rate_hz = 8;
    int quality = 65;
    double pose_timeout_s = 2;
    Pictures in_simulated_time = Pictures::sized;
    camera::CameraParams camera;

    template <class Visitor>
    void visit(Visitor& v) {
      v("walls_file", walls_file, "wall segments of the building, map frame; required");
      v("obstacles_file", obstacles_file, "what stands and walks there besides; empty: nothing");
      v("rate_hz", rate_hz, {0.1, 30}, "[1/s] pictures");
      v("quality", quality, {1, 100}, "[1] of the JPEG; sets the size of a picture");
      v("pose_timeout_s", pose_timeout_s, {0.1, 60}, "[s] no picture from an older location");
      visit_enum(v, "in_simulated_time", in_simulated_time, Choices{"sized", "drawn"},
                 "sized: zeros of the right number, which is 100 times faster");
      camera.visit(v);
    }
  };

  /// ConfigError when one of the files cannot be used.
  CameraComponent(Context& context, const Params& params);
  void tick(Time now) override;

 private:
  void take_location(Time now);
  void take_budget(Time now);
  void publish(double size, Time now);
  using Picture = topic::CameraImage::Message;
  [[nodiscard]] std::shared_ptr<Picture> unused_picture();
  void fill(Picture& picture, double size);
  /// [B] of the view's JPEG in full quality, without drawing it.
  [[nodiscard]] std::size_t full_size();
  void calibrate();
  [[nodiscard]] std::vector<geometry::Wall> people();
  [[nodiscard]] std::vector<std::uint8_t> draw(double size);
  [[nodiscard]] int quality_for(double size, const camera::Picture& picture);

  Input<topic::Location> location_{*this};
  OptionalInput<topic::LinkBudget> budget_{*this, WakeMode::time_triggered};
  Output<topic::CameraImage> image_{*this};
  const Params params_;
  const laser::Obstacles obstacles_;
  std::vector<geometry::Wall> walls_;  ///< and what stands before them
  Duration period_;
  Duration pose_timeout_;
  std::optional<camera::Renderer> renderer_;  ///< when something is drawn
  std::optional<camera::PictureSize> size_;   ///< when they are not
  camera::AdaptiveStream stream_;
  camera::QualityLaw qualities_;
  std::optional<geometry::Pose> view_;
  Time view_time_{};
  Time next_picture_ = Time::min();
  std::vector<std::shared_ptr<Picture>> pictures_;  ///< of zeros; each may still be read
  std::uint32_t frame_ = 0;
};

}  // namespace tocsin
