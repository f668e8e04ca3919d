// SPDX-License-Identifier: Apache-2.0
#include "camera/renderer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "camera/jpeg.hpp"
#include "geometry/wall_file.hpp"

namespace tocsin::camera {
namespace {

constexpr double wall_loss_db = 6.9;
constexpr double furniture_loss_db = 0;

/// A room of 8 m x 6 m around the origin.
std::vector<geometry::Wall> room() {
  return {{-4, -3, 4, -3, wall_loss_db},
          {4, -3, 4, 3, wall_loss_db},
          {4, 3, -4, 3, wall_loss_db},
          {-4, 3, -4, -3, wall_loss_db}};
}

CameraParams small() {
  CameraParams params;
  params.width = 160;
  params.height = 120;
  params.sensor_noise = 0;
  return params;
}

using Mean = std::array<double, 3>;

/// Mean colour of a block of pixels.
Mean mean_of(const Picture& picture, int column, int row, int side = 8) {
  Mean mean{};
  for (int k = 0; k < side * side; ++k) {
    const auto* pixel = picture.at(column + k % side, row + k / side);
    for (std::size_t i = 0; i < 3; ++i) mean[i] += pixel[i] / static_cast<double>(side * side);
  }
  return mean;
}

/// The first row, from the top, in which the middle column shows the wall: there it is no longer
/// the ceiling of a picture without any walls.
int wall_top(const CameraParams& params, double distance_m) {
  Renderer empty(params, {});
  Renderer sut(params, {{distance_m, -50, distance_m, 50, wall_loss_db}});
  const Picture ceiling = empty.render({}, 0);
  const Picture& picture = sut.render({}, 0);
  const int middle = params.width / 2;
  for (int row = 0; row < params.height; ++row) {
    if (!std::equal(picture.at(middle, row), picture.at(middle, row) + 3, ceiling.at(middle, row)))
      return row;
  }
  return params.height;
}

/// Rows of the middle column that differ between two pictures.
int rows_that_differ(const Picture& a, const Picture& b, int column) {
  int rows = 0;
  for (int row = 0; row < a.height; ++row) {
    if (!std::equal(a.at(column, row), a.at(column, row) + 3, b.at(column, row))) ++rows;
  }
  return rows;
}

TEST(Renderer, DrawsAPersonBeforeWhatIsFartherAndBehindWhatIsNearer) {
  auto walls = room();
  const std::vector<geometry::Wall> person{{2, -0.3, 2, 0.3, 0}};
  Renderer sut(small(), walls);
  const Picture empty = sut.render({}, 0);
  const int middle = small().width / 2;
  // From the floor up 1.7 m at 2 m, where a metre is 69 rows, cut by the edge of the picture.
  EXPECT_NEAR(rows_that_differ(sut.render({}, 0, person), empty, middle), 60 + 0.3 * 69, 8);
  EXPECT_EQ(rows_that_differ(sut.render({}, 0, person), empty, 5), 0) << "beside the person";
  walls.push_back({1, -3, 1, 3, wall_loss_db});
  Renderer behind(small(), walls);
  const Picture wall = behind.render({}, 0);
  EXPECT_EQ(rows_that_differ(behind.render({}, 0, person), wall, middle), 0);
}

TEST(Renderer, GivesTheSamePictureForTheSameArguments) {
  CameraParams params = small();
  params.sensor_noise = 4;
  Renderer a(params, room()), b(params, room());
  (void)b.render({1, 1, 1}, 3);  // what came before does not matter
  EXPECT_EQ(a.render({0, 0, 0.5}, 7).rgb, b.render({0, 0, 0.5}, 7).rgb);
}

TEST(Renderer, HasNewNoiseOfTheStatedStrengthInEachFrame) {
  CameraParams params = small();
  Renderer clean(params, room());
  params.sensor_noise = 4;
  Renderer noisy(params, room());
  const Picture a = clean.render({}, 0);
  EXPECT_EQ(a.rgb, clean.render({}, 1).rgb);
  const Picture b = noisy.render({}, 0);
  EXPECT_NE(b.rgb, noisy.render({}, 1).rgb);
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::pow(b.rgb[i] - a.rgb[i], 2);
  EXPECT_NEAR(std::sqrt(sum / static_cast<double>(a.rgb.size())), 4.0, 0.2);
}

TEST(Renderer, ShowsTheWallAsHighAsPerspectiveSays) {
  // Focal length 80 px / tan(30 deg) = 138.6 px; the wall's top is 2.5 m above the lens.
  EXPECT_NEAR(wall_top(small(), 8.0), 60 - 138.6 * 2.5 / 8.0, 1.0);
  EXPECT_NEAR(wall_top(small(), 16.0), 60 - 138.6 * 2.5 / 16.0, 1.0);
  EXPECT_EQ(wall_top(small(), 1.0), 0) << "it fills the picture";
  CameraParams wide = small();
  wide.field_of_view_deg = 90;
  EXPECT_NEAR(wall_top(wide, 8.0), 60 - 80 * 2.5 / 8.0, 1.0);
}

TEST(Renderer, GetsDarkerWithDistance) {
  Renderer near(small(), {{3, -50, 3, 50, wall_loss_db}});
  Renderer far(small(), {{20, -50, 20, 50, wall_loss_db}});
  EXPECT_GT(mean_of(near.render({}, 0), 76, 40)[0], 1.3 * mean_of(far.render({}, 0), 76, 48, 2)[0]);
}

TEST(Renderer, ShowsFurnitureBeforeTheWallAndTheWallAboveIt) {
  auto walls = room();
  walls.push_back({2, -1, 2, 1, furniture_loss_db});
  Renderer sut(small(), walls);
  const Picture& picture = sut.render({}, 0);
  const Mean brown = mean_of(picture, 76, 60), plaster = mean_of(picture, 76, 2);
  EXPECT_GT(brown[0], 1.8 * brown[2]);
  EXPECT_LT(plaster[0], 1.3 * plaster[2]);
}

TEST(Renderer, ShowsTheLeftOnTheLeft) {
  auto walls = room();
  walls.push_back({3, 0.5, 3, 1.5, furniture_loss_db});
  Renderer sut(small(), walls);
  const Picture& picture = sut.render({}, 0);
  const Mean left = mean_of(picture, 30, 60), right = mean_of(picture, 122, 60);
  EXPECT_GT(left[0], 1.8 * left[2]);
  EXPECT_LT(right[0], 1.5 * right[2]);
}

/// Share of the bytes that are the same.
double likeness(const Picture& a, const Picture& b) {
  int same = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) same += a.rgb[i] == b.rgb[i] ? 1 : 0;
  return same / static_cast<double>(a.rgb.size());
}

TEST(Renderer, HoldsSurfacesStillWhileTheCameraMoves) {
  // 8.4 m is three times the pattern of the wall, and seven times that of floor and ceiling.
  Renderer sut(small(), {{3, -100, 3, 100, wall_loss_db}});
  const Picture here = sut.render({0, 0, 0}, 0);
  EXPECT_GT(likeness(here, sut.render({0, 8.4, 0}, 0)), 0.98);
  EXPECT_LT(likeness(here, sut.render({0, 8.0, 0}, 0)), 0.5);
}

TEST(Renderer, ShowsAPictureInEachSizeThatIsAllowed) {
  for (const auto& [width, height] :
       {std::pair(64, 48), std::pair(320, 240), std::pair(65, 1080)}) {
    CameraParams params;
    params.width = width;
    params.height = height;
    Renderer sut(params, room());
    const Picture& picture = sut.render({}, 0);
    EXPECT_EQ(picture.width, width);
    EXPECT_EQ(picture.height, height);
    EXPECT_GT(picture.at(width / 2, height - 1)[0], 20) << "the floor is lit";
  }
}

TEST(Renderer, DrawsTheClassroomOfTheRepository) {
  const auto walls = geometry::load_walls(TOCSIN_REPOSITORY "/config/maps/classroom.walls.yaml");
  Renderer sut(small(), walls);
  // From the start of the missions, looking along x, the teacher's desk is ahead on the left.
  const Picture& picture = sut.render({}, 0);
  const Mean desk = mean_of(picture, 20, 60), floor = mean_of(picture, 76, 110);
  EXPECT_GT(desk[0], 1.8 * desk[2]);
  EXPECT_LT(floor[0], 1.4 * floor[2]);
}

TEST(Renderer, SurvivesEveryPlaceAndDirection) {
  Renderer sut(small(), room());
  for (const double far : {0.0, 4.0, 3.999, 1e6, -1e9}) {
    for (int i = 0; i < 16; ++i) (void)sut.render({far, -far, i * 0.4}, 0);
  }
  (void)sut.render({1e300, -1e300, 1e300}, 0);
}

TEST(Renderer, MakesAStreamOfTwoToThreeMegabitAtItsDefaults) {
  // 640 x 480, quality 65, 8 pictures a second: 31 to 47 kB each.
  Renderer sut(CameraParams{}, room());
  double bytes = 0;
  for (unsigned i = 0; i < 8; ++i) {
    bytes += static_cast<double>(encode_jpeg(sut.render({i * 0.2 - 1, 0, i * 0.8}, i), 65).size());
  }
  EXPECT_GT(bytes * 8, 2.0e6);
  EXPECT_LT(bytes * 8, 3.0e6);
}

}  // namespace
}  // namespace tocsin::camera
