// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/ros/wire_reader.hpp"

namespace setsquare::ros {
namespace {

constexpr std::size_t kCdrHeaderBytes = 4;
constexpr std::size_t kMaxCdrAlignment = 8;
constexpr std::string_view kShort = "the message ends before its last field";

}  // namespace

WireReader::WireReader(std::string_view message, MessageEncoding encoding) : body_(message) {
  static_assert(std::endian::native == std::endian::little, "byte order of ROS messages");
  if (encoding == MessageEncoding::kCdr) {
    read_cdr_header();
  } else if (encoding != MessageEncoding::kRos1) {
    fail("an encoding other than ROS 1 and CDR");
  }
}

void WireReader::read_cdr_header() {
  constexpr char kBigEndian = 0;
  constexpr char kLittleEndian = 1;
  if (body_.size() < kCdrHeaderBytes) return fail("the message is shorter than the CDR header");
  const char representation = body_[1];  // The last two bytes are options, of no meaning to us.
  if (body_[0] != 0 || (representation != kBigEndian && representation != kLittleEndian)) {
    return fail("a CDR representation other than plain XCDR1 (PL_CDR or XCDR2)");
  }
  body_.remove_prefix(kCdrHeaderBytes);
  max_alignment_ = kMaxCdrAlignment;
  is_swapped_ = representation == kBigEndian;
  has_closing_zeros_ = true;
}

std::string_view WireReader::read_text() {
  const std::size_t num_bytes = read_count(sizeof(char));
  std::string_view text = take(num_bytes);
  if (has_closing_zeros_ && text.ends_with('\0')) text.remove_suffix(1);
  return text;
}

std::size_t WireReader::read_count(std::size_t min_element_bytes) {
  const std::size_t num_elements = read<std::uint32_t>();
  return has_room_for(num_elements, min_element_bytes) ? num_elements : 0;
}

bool WireReader::has_room_for(std::size_t num_elements, std::size_t min_element_bytes) {
  if (min_element_bytes == 0 || num_elements <= num_left() / min_element_bytes) {
    return !has_failed();
  }
  fail("the message ends before the last element of a sequence");
  return false;
}

std::string_view WireReader::take(std::size_t num_bytes) {
  if (num_left() < num_bytes) {
    fail(kShort);
    return {};
  }
  const std::string_view taken = body_.substr(position_, num_bytes);
  position_ += num_bytes;
  return taken;
}

void WireReader::fail(std::string_view reason) {
  if (failure_.empty()) failure_ = reason;
  position_ = body_.size();
}

}  // namespace setsquare::ros
