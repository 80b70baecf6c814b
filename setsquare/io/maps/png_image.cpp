// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/maps/png_image.hpp"

#include <png.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bytes/input_buffer.hpp"

namespace setsquare {
namespace {

constexpr std::size_t kMaxPngBytes = std::size_t{1} << 28;
constexpr std::uint64_t kMaxPngPixels = 100'000'000;

/// libpng's reader, whose memory must be given back.
class PngReader {
 public:
  PngReader(std::string_view bytes, const std::string& name) : name_(name) {
    image_.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&image_, bytes.data(), bytes.size()) == 0) complain();
    image_.format = PNG_FORMAT_GRAY;
  }
  ~PngReader() { png_image_free(&image_); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  [[nodiscard]] PgmImage grey() {
    if (std::uint64_t{image_.width} * image_.height > kMaxPngPixels) {
      throw FormatError(name_, "", "more than 100 million pixels");
    }
    std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(image_));
    const png_color white{.red = 255, .green = 255, .blue = 255};
    if (png_image_finish_read(&image_, &white, pixels.data(), 0, nullptr) == 0) complain();
    return {.width = static_cast<std::int32_t>(image_.width),
            .height = static_cast<std::int32_t>(image_.height),
            .white = 255,
            .values = std::vector<std::uint16_t>(pixels.begin(), pixels.end())};
  }

 private:
  [[noreturn]] void complain() const {
    throw FormatError(name_, "", std::string("is no whole PNG image: ") + image_.message);
  }

  const std::string& name_;
  png_image image_ = {};
};

}  // namespace

bool is_png(std::string_view beginning) {
  return beginning.starts_with(std::string_view("\x89PNG\r\n\x1a\n", 8));
}

PgmImage read_png(std::unique_ptr<ByteSource> source, const std::string& name) {
  InputBuffer input(std::move(source));
  if (input.ensure(kMaxPngBytes)) throw FormatError(name, "", "too long for a map's image");
  return PngReader(input.available(), name).grey();
}

}  // namespace setsquare
