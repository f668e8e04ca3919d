// SPDX-License-Identifier: Apache-2.0
#include "camera/jpeg.hpp"

#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

#include <jpeglib.h>  // needs size_t and FILE before it

namespace tocsin::camera {
namespace {

/// libjpeg ends the process on an error unless it is led away.
struct Escape {
  jpeg_error_mgr base;
  std::jmp_buf to;
};

void escape(j_common_ptr info) { std::longjmp(reinterpret_cast<Escape*>(info->err)->to, 1); }

void write_rows(jpeg_compress_struct& jpeg, const Picture& picture) {
  while (jpeg.next_scanline < jpeg.image_height) {
    JSAMPROW row = const_cast<JSAMPROW>(picture.at(0, static_cast<int>(jpeg.next_scanline)));
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
}

/// Only plain data in here: a jump runs no destructor. False on an error.
bool compress(const Picture& picture, int quality, unsigned char** data, unsigned long* size) {
  jpeg_compress_struct jpeg{};
  Escape error{};
  jpeg.err = jpeg_std_error(&error.base);
  error.base.error_exit = escape;
  if (setjmp(error.to) != 0) {
    jpeg_destroy_compress(&jpeg);
    return false;
  }
  jpeg_create_compress(&jpeg);
  jpeg_mem_dest(&jpeg, data, size);
  jpeg.image_width = static_cast<JDIMENSION>(picture.width);
  jpeg.image_height = static_cast<JDIMENSION>(picture.height);
  jpeg.input_components = 3;
  jpeg.in_color_space = JCS_RGB;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, quality, TRUE);
  jpeg.dct_method = JDCT_IFAST;
  jpeg_start_compress(&jpeg, TRUE);
  write_rows(jpeg, picture);
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  return true;
}

}  // namespace

std::vector<std::uint8_t> encode_jpeg(const Picture& picture, int quality) {
  unsigned char* data = nullptr;
  unsigned long size = 0;
  std::vector<std::uint8_t> bytes;
  if (compress(picture, quality, &data, &size)) bytes.assign(data, data + size);
  std::free(data);
  return bytes;
}

}  // namespace tocsin::camera
