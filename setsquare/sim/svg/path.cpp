// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/svg/path.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "setsquare/core/angle.hpp"
#include "setsquare/sim/svg/scanner.hpp"

namespace setsquare {
namespace {

using Eigen::Vector2d;

/// More than any plan has: a few bytes may ask for thousands of chords.
constexpr std::size_t kMaxCorners = 2'000'000;

/// Follows the commands of a path; points are in user units until they become corners.
class Pen {
 public:
  Pen(const Eigen::Affine2d& T_map_user, double tolerance_m)
      : T_map_user_(T_map_user), tolerance_m_(tolerance_m) {}

  void follow(SvgScanner& d);
  [[nodiscard]] std::vector<SvgStroke> take_strokes();

 private:
  void draw(char command, SvgScanner& d);
  void move_to(const Vector2d& point);
  void line_to(const Vector2d& point);
  void cubic_to(const Vector2d& first, const Vector2d& second, const Vector2d& point);
  void quadratic_to(const Vector2d& control, const Vector2d& point);
  void arc_to(SvgScanner& d);
  void close();
  void end_stroke(bool is_closed);

  /// The next point of the current command, in absolute user units.
  [[nodiscard]] Vector2d point(SvgScanner& d) const {
    const double x = d.number();
    const double y = d.number();
    return origin_ + Vector2d(x, y);
  }
  /// The last control point mirrored, where the last command was of the same family.
  [[nodiscard]] Vector2d mirrored(std::string_view family) const {
    const bool is_smooth = family.find(last_command_) != std::string_view::npos;
    return is_smooth ? Vector2d(2.0 * here_ - control_) : here_;
  }

  Eigen::Affine2d T_map_user_;
  double tolerance_m_;
  std::vector<SvgStroke> strokes_;
  std::size_t num_corners_ = 0;  ///< Of the strokes that have ended.
  Corners corners_m_;
  Vector2d here_ = Vector2d::Zero();
  Vector2d stroke_start_ = Vector2d::Zero();
  Vector2d control_ = Vector2d::Zero();
  Vector2d origin_ = Vector2d::Zero();  ///< Of the current command: here, or zero.
  char last_command_ = ' ';             ///< In capitals.
};

void Pen::end_stroke(bool is_closed) {
  if (is_closed && corners_m_.size() > 1 &&
      (corners_m_.back() - corners_m_.front()).norm() < 1e-9) {
    corners_m_.pop_back();
  }
  num_corners_ += corners_m_.size();
  if (corners_m_.size() > 1) strokes_.push_back({std::move(corners_m_), is_closed});
  corners_m_.clear();
}

std::vector<SvgStroke> Pen::take_strokes() {
  end_stroke(false);
  return std::move(strokes_);
}

void Pen::move_to(const Vector2d& point) {
  end_stroke(false);
  here_ = stroke_start_ = point;
  corners_m_.emplace_back(T_map_user_ * point);
}

void Pen::line_to(const Vector2d& point) {
  here_ = point;
  corners_m_.emplace_back(T_map_user_ * point);
}

void Pen::cubic_to(const Vector2d& first, const Vector2d& second, const Vector2d& point) {
  append_cubic(
      corners_m_, T_map_user_ * first, T_map_user_ * second, T_map_user_ * point, tolerance_m_);
  control_ = second;
  here_ = point;
}

void Pen::quadratic_to(const Vector2d& control, const Vector2d& point) {
  append_quadratic(corners_m_, T_map_user_ * control, T_map_user_ * point, tolerance_m_);
  control_ = control;
  here_ = point;
}

/// From two ends to the center: SVG 1.1, appendix F.6.5 and F.6.6.
void Pen::arc_to(SvgScanner& d) {
  double rx = std::abs(d.number());
  double ry = std::abs(d.number());
  const Eigen::Rotation2Dd tilt(rad_from_deg(d.number()));
  const bool is_large = d.flag();
  const bool is_positive = d.flag();
  const Vector2d end = point(d);
  if (rx == 0.0 || ry == 0.0) return line_to(end);
  const Vector2d half = tilt.inverse() * (0.5 * (here_ - end));
  const double stretch = std::hypot(half.x() / rx, half.y() / ry);
  if (stretch == 0.0) return;
  rx *= std::max(1.0, stretch);
  ry *= std::max(1.0, stretch);
  const Vector2d unit_half(half.x() / rx, half.y() / ry);
  const double square = unit_half.squaredNorm();
  const double length = std::sqrt(std::max(0.0, (1.0 - square) / square));
  const double side = is_large == is_positive ? -length : length;
  const Vector2d unit_center(side * unit_half.y(), -side * unit_half.x());
  const Vector2d from = unit_half - unit_center;
  const Vector2d to = -unit_half - unit_center;
  const double start_rad = std::atan2(from.y(), from.x());
  double sweep_rad = std::atan2(to.y(), to.x()) - start_rad;
  if (is_positive && sweep_rad < 0.0) sweep_rad += kTwoPi;
  if (!is_positive && sweep_rad > 0.0) sweep_rad -= kTwoPi;
  const Vector2d center =
      0.5 * (here_ + end) + tilt * Vector2d(rx * unit_center.x(), ry * unit_center.y());
  append_arc(corners_m_,
             {T_map_user_ * center,
              T_map_user_.linear() * (tilt * Vector2d(rx, 0.0)),
              T_map_user_.linear() * (tilt * Vector2d(0.0, ry)),
              start_rad,
              sweep_rad},
             tolerance_m_);
  here_ = end;
}

void Pen::close() {
  end_stroke(true);
  here_ = stroke_start_;
}

void Pen::draw(char command, SvgScanner& d) {
  switch (command) {
    case 'L':
      return line_to(point(d));
    case 'H':
      return line_to({origin_.x() + d.number(), here_.y()});
    case 'V':
      return line_to({here_.x(), origin_.y() + d.number()});
    case 'C': {
      const Vector2d first = point(d);
      const Vector2d second = point(d);
      return cubic_to(first, second, point(d));
    }
    case 'S': {
      const Vector2d second = point(d);
      return cubic_to(mirrored("CS"), second, point(d));
    }
    case 'Q': {
      const Vector2d control = point(d);
      return quadratic_to(control, point(d));
    }
    case 'T':
      return quadratic_to(mirrored("QT"), point(d));
    case 'A':
      return arc_to(d);
    default:
      throw SvgFault(fmt::format("path command '{}' is not known", command));
  }
}

void Pen::follow(SvgScanner& d) {
  while (!d.is_at_end()) {
    const char letter = d.take();
    const bool is_relative = letter >= 'a' && letter <= 'z';
    char command = is_relative ? static_cast<char>(letter - 'a' + 'A') : letter;
    if (command != 'M' && last_command_ == ' ') throw SvgFault("a path begins with M or m");
    do {
      origin_ = is_relative ? here_ : Vector2d(0.0, 0.0);
      if (command == 'M') {
        move_to(point(d));
      } else if (command == 'Z') {
        close();
      } else {
        if (corners_m_.empty()) corners_m_.emplace_back(T_map_user_ * here_);
        draw(command, d);
      }
      if (num_corners_ + corners_m_.size() > kMaxCorners) {
        throw SvgFault("a path of more than 2 million corners");
      }
      last_command_ = command;
      if (command == 'M') command = 'L';  // further pairs are lines
    } while (command != 'Z' && d.is_at_number());
  }
}

}  // namespace

std::vector<SvgStroke> strokes_from_svg_path(std::string_view d,
                                             const Eigen::Affine2d& T_map_user,
                                             double tolerance_m) {
  Pen pen(T_map_user, tolerance_m);
  SvgScanner scanner(d);
  pen.follow(scanner);
  return pen.take_strokes();
}

SvgStroke stroke_from_ellipse(const Vector2d& center,
                              const Vector2d& radii,
                              const Eigen::Affine2d& T_map_user,
                              double tolerance_m) {
  SvgStroke stroke{{}, true};
  append_arc(stroke.corners_m,
             {T_map_user * center,
              T_map_user.linear() * Vector2d(radii.x(), 0.0),
              T_map_user.linear() * Vector2d(0.0, radii.y()),
              0.0,
              kTwoPi},
             tolerance_m);
  return stroke;
}

}  // namespace setsquare
