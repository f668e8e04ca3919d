// SPDX-License-Identifier: Apache-2.0
#include "camera/jpeg.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include <jpeglib.h>  // needs size_t and FILE before it

namespace tocsin::camera {
namespace {

/// What a viewer sees. Ends the test program when the data are no JPEG.
Picture decode(const std::vector<std::uint8_t>& data) {
  jpeg_decompress_struct jpeg{};
  jpeg_error_mgr error{};
  jpeg.err = jpeg_std_error(&error);
  jpeg_create_decompress(&jpeg);
  jpeg_mem_src(&jpeg, data.data(), data.size());
  jpeg_read_header(&jpeg, TRUE);
  jpeg_start_decompress(&jpeg);
  Picture picture(static_cast<int>(jpeg.output_width), static_cast<int>(jpeg.output_height));
  while (jpeg.output_scanline < jpeg.output_height) {
    JSAMPROW row = picture.at(0, static_cast<int>(jpeg.output_scanline));
    jpeg_read_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_decompress(&jpeg);
  jpeg_destroy_decompress(&jpeg);
  return picture;
}

/// Red grows to the right, green downwards.
Picture ramp(int width, int height) {
  Picture picture(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      picture.at(column, row)[0] = static_cast<std::uint8_t>(255 * column / width);
      picture.at(column, row)[1] = static_cast<std::uint8_t>(255 * row / height);
    }
  }
  return picture;
}

TEST(Jpeg, ShowsThePictureThatWasEncoded) {
  const Picture picture = ramp(160, 120);
  const Picture sut = decode(encode_jpeg(picture, 95));
  ASSERT_EQ(sut.width, 160);
  ASSERT_EQ(sut.height, 120);
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
    ASSERT_NEAR(sut.rgb[i], picture.rgb[i], 12) << i;
  }
}

TEST(Jpeg, TakesSizesThatAreNoMultipleOfABlock) {
  const Picture sut = decode(encode_jpeg(ramp(67, 49), 80));
  EXPECT_EQ(sut.width, 67);
  EXPECT_EQ(sut.height, 49);
}

TEST(Jpeg, IsEmptyForAPictureThatCannotBeEncoded) {
  EXPECT_TRUE(encode_jpeg(Picture(70000, 1), 50).empty());  // JPEG ends at 65500
}

}  // namespace
}  // namespace tocsin::camera
