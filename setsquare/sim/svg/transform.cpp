// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/svg/transform.hpp"

#include <fmt/core.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/sim/svg/scanner.hpp"

namespace setsquare {
namespace {

/// SVG's order: x' = a x + c y + e, y' = b x + d y + f.
Eigen::Affine2d affine(double a, double b, double c, double d, double e, double f) {
  Eigen::Affine2d map = Eigen::Affine2d::Identity();
  map.matrix().topRows<2>() << a, c, e, b, d, f;
  return map;
}

Eigen::Affine2d rotation(const std::vector<double>& values) {
  const double cos = std::cos(rad_from_deg(values[0]));
  const double sin = std::sin(rad_from_deg(values[0]));
  const Eigen::Affine2d turn = affine(cos, sin, -sin, cos, 0.0, 0.0);
  if (values.size() == 1) return turn;
  const Eigen::Translation2d to_center(values[1], values[2]);
  return to_center * turn * to_center.inverse();
}

Eigen::Affine2d function_from(std::string_view name, const std::vector<double>& values) {
  const std::size_t count = values.size();
  if (name == "matrix" && count == 6) {
    return affine(values[0], values[1], values[2], values[3], values[4], values[5]);
  }
  if (name == "translate" && (count == 1 || count == 2)) {
    return affine(1.0, 0.0, 0.0, 1.0, values[0], count == 2 ? values[1] : 0.0);
  }
  if (name == "scale" && (count == 1 || count == 2)) {
    return affine(values[0], 0.0, 0.0, values[count - 1], 0.0, 0.0);
  }
  if (name == "rotate" && (count == 1 || count == 3)) return rotation(values);
  if (name == "skewX" && count == 1) {
    return affine(1.0, 0.0, std::tan(rad_from_deg(values[0])), 1.0, 0.0, 0.0);
  }
  if (name == "skewY" && count == 1) {
    return affine(1.0, std::tan(rad_from_deg(values[0])), 0.0, 1.0, 0.0, 0.0);
  }
  throw SvgFault(fmt::format("transform {} with {} numbers is not known", name, count));
}

}  // namespace

Eigen::Affine2d affine_from_svg_transform(std::string_view text) {
  Eigen::Affine2d all = Eigen::Affine2d::Identity();
  SvgScanner scanner(text);
  while (!scanner.is_at_end()) {
    const std::string_view name = scanner.word();
    if (name.empty() || scanner.take() != '(') throw SvgFault("a transform is \"name(numbers)\"");
    constexpr std::size_t kMaxValues = 6;
    std::vector<double> values;
    while (scanner.is_at_number() && values.size() <= kMaxValues) {
      values.push_back(scanner.number());
    }
    if (scanner.take() != ')') throw SvgFault("a transform is \"name(numbers)\"");
    all = all * function_from(name, values);
  }
  return all;
}

}  // namespace setsquare
