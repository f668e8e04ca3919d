// SPDX-License-Identifier: Apache-2.0
#include "navigation/map_loader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <utility>

#include "foundation/error.hpp"

namespace tocsin::navigation {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

GrayImage parse(const std::string& bytes) { return parse_pgm(bytes, "a.pgm"); }
std::string pgm_error(const std::string& bytes) {
  return error_of([&] { (void)parse(bytes); });
}

TEST(Pgm, ReadsBinaryAndTextPixels) {
  const GrayImage image = parse("P5\n# by hand\n3 2\n255\n\x01\x02\x03\x04\x05\x06");
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 2);
  EXPECT_THAT(image.pixels, ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(parse("P5 2 1 255\n\n#").pixels, ElementsAre('\n', '#'));
  EXPECT_THAT(parse("P2 2 2 9\n0 9 # white\n 3\n4").pixels, ElementsAre(0, 9, 3, 4));
}

TEST(Pgm, SaysWhatIsWrong) {
  const std::pair<const char*, const char*> rows[] = {
      {"P6 1 1 255\nabc", "a.pgm: is not a PGM image (P5 or P2)"},
      {"", "not a PGM"},
      {"P5\n0 2\n255\n", "width is not in [1, 100000]"},
      {"P5\n2 -2\n255\n", "height"},
      {"P5\n2 2\n65535\n", "maximum is not in [1, 255]"},
      {"P5\n99999999999999999999 2\n255\n", "width"},
      {"P5\n2", "height"},
      {"P5\n# only a comment", "width"},
      {"P5 99999 99999 255\n", "more than 25 million"},
      {"P5 3 2 255\n12345", "a.pgm: is truncated: 5 pixels of 6"},
      {"P5 3 2 255", "a.pgm: is truncated: 0 pixels of 6"},
      {"P2 3 2 255\n1 2 3", "a.pgm: is truncated: 3 pixels of 6"},
      {"P5 1 1 9\n\x0a", "pixel 10 is above"},
      {"P2 1 1 9\n10", "pixel 10 is above"}};
  for (const auto& [bytes, error] : rows) EXPECT_THAT(pgm_error(bytes), HasSubstr(error)) << bytes;
}

TEST(MapFromImage, ReadsGreysByTheThresholdsOfMapServer) {
  // 90: black share 0.647; 88: 0.655; 205: 0.1961; 206: 0.192.
  MapScale scale;
  const auto sut = map_from_image({4, 1, 255, {88, 90, 205, 206}}, scale);
  EXPECT_THAT(sut.cells(), ElementsAre(Cell::occupied, Cell::unknown, Cell::unknown, Cell::free));
  scale.negate = true;
  EXPECT_THAT(map_from_image({2, 1, 255, {0, 255}}, scale).cells(),
              ElementsAre(Cell::free, Cell::occupied));
}

TEST(MapFromImage, PutsTheLastImageRowAtTheOrigin) {
  const auto sut = map_from_image({1, 2, 255, {0, 254}}, {1.0, {10, 20}});
  EXPECT_EQ(sut.at(geometry::Point{10.5, 20.5}), Cell::free);
  EXPECT_EQ(sut.at(geometry::Point{10.5, 21.5}), Cell::occupied);
}

class LoadMap : public ::testing::Test {
 protected:
  LoadMap() {
    std::filesystem::create_directories(folder_);
    write("m.pgm", "P5 2 1 255\n\xfe" + std::string(1, '\0'));
  }
  ~LoadMap() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  std::string error_with(const std::string& yaml) const {
    write("m.yaml", yaml);
    return error_of([&] { (void)load_map(path()); });
  }
  std::string path() const { return (folder_ / "m.yaml").string(); }

  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("tocsin_map_loader_" + std::to_string(::getpid()));
  const std::string good_ = "image: m.pgm\nresolution: 0.1\norigin: [-1, 2, 0]\n";
};

TEST_F(LoadMap, ReadsYamlAndImage) {
  write("m.yaml", good_ + "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const auto sut = load_map(path());
  EXPECT_DOUBLE_EQ(sut.grid().resolution_m, 0.1);
  EXPECT_EQ(sut.at(geometry::Point{-0.95, 2.05}), Cell::free);
  EXPECT_EQ(sut.at(geometry::Point{-0.85, 2.05}), Cell::occupied);
}

TEST_F(LoadMap, CostsAreThoseOfTheMapWithTheParametersAskedFor) {
  std::string pixels(400, '\xfe');
  pixels[210] = '\0';
  write("m.pgm", "P5 20 20 255\n" + pixels);
  write("m.yaml", good_);
  const auto an_hour_ago = std::filesystem::file_time_type::clock::now() - std::chrono::hours(1);
  std::filesystem::last_write_time(path(), an_hour_ago);  // old enough to be remembered
  const OccupancyMap map = load_map(path());
  for (const double radius_m : {0.05, 0.3, 0.05}) {
    InflationParams params;
    params.robot_radius_m = radius_m;
    const CostMap expected(map, params);
    const auto sut = load_costs(path(), params);
    ASSERT_EQ(sut->grid().size(), expected.grid().size());
    for (std::size_t i = 0; i < expected.grid().size(); ++i) {
      EXPECT_EQ(sut->cost(i), expected.cost(i)) << radius_m << " m, cell " << i;
    }
    if (radius_m < 0.1) {
      EXPECT_EQ(load_costs(path(), params), load_costs(path(), params));
    }
  }
}

TEST_F(LoadMap, NamesFileAndKeyOfWhatIsWrong) {
  EXPECT_THAT(error_of([] { (void)load_map("/nowhere/m.yaml"); }), HasSubstr("/nowhere/m.yaml"));
  EXPECT_EQ(error_of([] { (void)load_map(""); }),
            "map_file: is empty; it is the path of a map's .yaml");
  const std::pair<std::string, const char*> rows[] = {
      {"image: no.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n", "no.pgm"},
      {good_ + "orgin: 3\n", "orgin"},
      {"resolution: 0.1\norigin: [0, 0, 0]\n", "map.image: missing"},
      {"image: m.pgm\norigin: [0, 0, 0]\n", "map.resolution"},
      {"image: m.pgm\nresolution: 0.1\n", "map.origin: missing"},
      {"image: m.pgm\nresolution: 0\norigin: [0, 0, 0]\n", "map.resolution"},
      {good_ + "free_thresh: 0.7\n", "above occupied_thresh"},
      {good_ + "negate: 2\n", "map.negate"},
      {good_ + "mode: raw\n", "trinary"},
      {"image: m.pgm\nresolution: 0.1\norigin: [0, 0, 0.1]\n", "rotated"},
      {"image: m.pgm\nresolution: 0.1\norigin: [0, 0]\n", "map.origin"}};
  for (const auto& [yaml, error] : rows) EXPECT_THAT(error_with(yaml), HasSubstr(error)) << yaml;
}

}  // namespace
}  // namespace tocsin::navigation
