// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/maps/pgm_image.hpp"

#include <fmt/core.h>

#include <string_view>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bytes/input_buffer.hpp"

namespace setsquare {
namespace {

constexpr std::uint32_t kMaxSide = 1'000'000;
constexpr std::uint64_t kMaxPixels = 100'000'000;
constexpr std::uint32_t kMaxWhite = 65535;

bool is_blank(int byte) { return byte == ' ' || (byte >= '\t' && byte <= '\r'); }

/// Reads the image byte by byte and knows where it is.
class PgmReader {
 public:
  PgmReader(std::unique_ptr<ByteSource> source, std::string name)
      : input_(std::move(source)), name_(std::move(name)) {}

  [[nodiscard]] PgmImage read();

 private:
  [[noreturn]] void complain(const std::string& reason) const {
    throw FormatError(name_, fmt::format("offset {}", input_.offset()), reason);
  }
  /// The next byte without taking it, -1 at the end.
  [[nodiscard]] int peek() {
    if (input_.available().empty() && !input_.fill()) return -1;
    return static_cast<unsigned char>(input_.available().front());
  }
  int take() {
    const int byte = peek();
    if (byte < 0) complain("the image ends too early");
    input_.consume(1);
    return byte;
  }
  /// A number behind blanks and comments.
  [[nodiscard]] std::uint32_t number(std::string_view what,
                                     std::uint32_t least,
                                     std::uint32_t most);
  void skip_blanks_and_comments();
  [[nodiscard]] bool read_magic();
  /// The one blank between the header and the pixels; both of CR LF where the header's lines end
  /// so.
  void skip_blank_before_pixels();
  [[nodiscard]] std::uint16_t binary_value(std::uint16_t white);

  InputBuffer input_;
  std::string name_;
  bool has_windows_lines_ = false;  ///< A line of the header ended in CR LF.
};

void PgmReader::skip_blanks_and_comments() {
  for (int byte = peek(); is_blank(byte) || byte == '#'; byte = peek()) {
    const bool is_comment = byte == '#';
    while (is_comment && peek() >= 0 && peek() != '\n') input_.consume(1);
    if (peek() < 0) return;
    const bool is_behind_return = byte == '\r';
    input_.consume(1);
    has_windows_lines_ = has_windows_lines_ || (is_behind_return && peek() == '\n');
  }
}

std::uint32_t PgmReader::number(std::string_view what, std::uint32_t least, std::uint32_t most) {
  skip_blanks_and_comments();
  std::uint64_t value = 0;
  bool has_digits = false;
  for (int byte = peek(); byte >= '0' && byte <= '9' && value <= most; byte = peek()) {
    value = 10 * value + static_cast<std::uint64_t>(byte - '0');
    has_digits = true;
    input_.consume(1);
  }
  if (!has_digits && peek() < 0) complain("the image ends too early");
  const bool is_end_clear = peek() < 0 || is_blank(peek()) || peek() == '#';
  if (!has_digits || !is_end_clear || value < least || value > most) {
    complain(fmt::format("{} is not a number from {} to {}", what, least, most));
  }
  return static_cast<std::uint32_t>(value);
}

/// Whether the image is binary.
bool PgmReader::read_magic() {
  constexpr const char* kWhatWeRead = "not a PGM image (P5 or P2)";
  if (peek() != 'P') complain(kWhatWeRead);
  input_.consume(1);
  const int kind = peek();
  if (kind != '5' && kind != '2') complain(kWhatWeRead);
  input_.consume(1);
  if (!is_blank(peek()) && peek() != '#') complain(kWhatWeRead);
  return kind == '5';
}

void PgmReader::skip_blank_before_pixels() {
  const int blank = take();
  if (blank == '\r' && peek() == '\n' && has_windows_lines_) input_.consume(1);
}

std::uint16_t PgmReader::binary_value(std::uint16_t white) {
  int value = take();
  if (white > 255) value = 256 * value + take();
  if (value > white) complain("a pixel is brighter than white");
  return static_cast<std::uint16_t>(value);
}

PgmImage PgmReader::read() {
  const bool is_binary = read_magic();
  PgmImage image;
  image.width = static_cast<std::int32_t>(number("the width", 1, kMaxSide));
  image.height = static_cast<std::int32_t>(number("the height", 1, kMaxSide));
  const std::uint64_t num_pixels =
      static_cast<std::uint64_t>(image.width) * static_cast<std::uint64_t>(image.height);
  if (num_pixels > kMaxPixels) complain("more than 100 million pixels");
  image.white = static_cast<std::uint16_t>(number("the maximum value", 1, kMaxWhite));
  if (is_binary) skip_blank_before_pixels();
  for (std::uint64_t i = 0; i < num_pixels; ++i) {
    image.values.push_back(is_binary
                               ? binary_value(image.white)
                               : static_cast<std::uint16_t>(number("a pixel", 0, image.white)));
  }
  return image;
}

}  // namespace

PgmImage read_pgm(std::unique_ptr<ByteSource> source, const std::string& name) {
  return PgmReader(std::move(source), name).read();
}

std::string pgm_from_image(const PgmImage& image) {
  if (image.width < 1 || image.height < 1) throw ParameterError("width", "must be positive");
  const std::uint64_t num_pixels =
      static_cast<std::uint64_t>(image.width) * static_cast<std::uint64_t>(image.height);
  if (image.values.size() != num_pixels)
    throw ParameterError("values", "must hold one value per pixel");
  if (image.white < 1) throw ParameterError("white", "must be positive");
  std::string bytes = fmt::format("P5\n{} {}\n{}\n", image.width, image.height, image.white);
  const bool is_wide = image.white > 255;
  bytes.reserve(bytes.size() + (is_wide ? 2 : 1) * image.values.size());
  for (const std::uint16_t value : image.values) {
    if (value > image.white) throw ParameterError("values", "must not be brighter than white");
    if (is_wide) bytes.push_back(static_cast<char>(value >> 8));
    bytes.push_back(static_cast<char>(value & 0xff));
  }
  return bytes;
}

}  // namespace setsquare
