// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/headings/equations.hpp"

#include <cassert>
#include <numeric>

namespace setsquare {
namespace {

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

TridiagonalSystem::TridiagonalSystem(std::size_t n)
    : diagonal(n, 0.0), next(n > 0 ? n - 1 : 0, 0.0), right(n, 0.0) {}

void TridiagonalSystem::bind(std::size_t i, double value, double weight) {
  diagonal[i] += weight;
  right[i] += weight * value;
}

void TridiagonalSystem::bind_step(std::size_t i, double value, double weight) {
  diagonal[i] += weight;
  diagonal[i + 1] += weight;
  next[i] -= weight;
  right[i] -= weight * value;
  right[i + 1] += weight * value;
}

TridiagonalFactor::TridiagonalFactor(const TridiagonalSystem& system)
    : pivot_(system.diagonal), diagonal_(system.diagonal), next_(system.next) {
  for (std::size_t i = 1; i < pivot_.size(); ++i) {
    assert(pivot_[i - 1] > 0.0);
    pivot_[i] -= next_[i - 1] * next_[i - 1] / pivot_[i - 1];
  }
}

std::vector<double> TridiagonalFactor::solve(std::vector<double> right) const {
  const std::size_t n = pivot_.size();
  assert(right.size() == n);
  for (std::size_t i = 1; i < n; ++i) right[i] -= next_[i - 1] / pivot_[i - 1] * right[i - 1];
  for (std::size_t i = n; i-- > 0;) {
    const double after = i + 1 < n ? next_[i] * right[i + 1] : 0.0;
    right[i] = (right[i] - after) / pivot_[i];
  }
  return right;
}

std::vector<double> TridiagonalFactor::inverse_diagonal() const {
  const std::size_t n = pivot_.size();
  std::vector<double> variance(n);
  // What eliminating all unknowns before i, and all after it, leaves of its diagonal entry.
  double from_behind = 0.0;
  for (std::size_t i = n; i-- > 0;) {
    const double taken_by_later = i + 1 < n ? next_[i] * next_[i] / from_behind : 0.0;
    from_behind = diagonal_[i] - taken_by_later;
    variance[i] = 1.0 / (pivot_[i] - taken_by_later);
  }
  return variance;
}

std::vector<double> solve(const TridiagonalSystem& system) {
  return TridiagonalFactor(system).solve(system.right);
}

HeadingEquations::HeadingEquations(std::size_t num_keyframes, std::size_t num_frames)
    : chain_(num_keyframes),
      border_(num_frames - 1, std::vector<double>(num_keyframes, 0.0)),
      offset_diagonal_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(num_frames - 1))),
      offset_right_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(num_frames - 1))) {
  assert(num_frames > 0);
}

void HeadingEquations::bind(std::size_t k, std::size_t frame, double value_rad, double weight) {
  chain_.bind(k, value_rad, weight);
  if (frame == 0) return;
  border_[frame - 1][k] += weight;
  bind_offset(frame, value_rad, weight);
}

void HeadingEquations::bind_offset(std::size_t frame, double value_rad, double weight) {
  const auto f = static_cast<Eigen::Index>(frame - 1);
  offset_diagonal_(f) += weight;
  offset_right_(f) += weight * value_rad;
}

HeadingEquations::Schur HeadingEquations::eliminate() const {
  Schur schur{TridiagonalFactor(chain_), {}, {}};
  Eigen::MatrixXd offsets = offset_diagonal_.asDiagonal();
  for (const std::vector<double>& column : border_)
    schur.columns.push_back(schur.chain.solve(column));
  for (std::size_t a = 0; a < border_.size(); ++a) {
    for (std::size_t b = 0; b < border_.size(); ++b) {
      offsets(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) -=
          dot(border_[a], schur.columns[b]);
    }
  }
  if (!border_.empty()) schur.offsets.compute(offsets);
  return schur;
}

HeadingSolution HeadingEquations::solve() const {
  const Schur schur = eliminate();
  HeadingSolution solution{schur.chain.solve(chain_.right), offset_right_};
  for (std::size_t f = 0; f < border_.size(); ++f) {
    solution.offset_rad(static_cast<Eigen::Index>(f)) -= dot(border_[f], solution.drift_rad);
  }
  if (border_.empty()) return solution;
  solution.offset_rad = schur.offsets.solve(solution.offset_rad).eval();
  for (std::size_t f = 0; f < border_.size(); ++f) {
    const double offset_rad = solution.offset_rad(static_cast<Eigen::Index>(f));
    for (std::size_t k = 0; k < solution.drift_rad.size(); ++k) {
      solution.drift_rad[k] -= schur.columns[f][k] * offset_rad;
    }
  }
  return solution;
}

HeadingVariances HeadingEquations::variances() const {
  const Schur schur = eliminate();
  HeadingVariances variances{schur.chain.inverse_diagonal(), {}};
  const auto num_offsets = static_cast<Eigen::Index>(border_.size());
  if (num_offsets == 0) return variances;
  // A column at a time: the solution for a whole matrix costs the build many seconds.
  variances.offset_rad2.resize(num_offsets);
  Eigen::VectorXd row(num_offsets);
  for (Eigen::Index f = 0; f < num_offsets; ++f) {
    row.setZero();
    row(f) = 1.0;
    variances.offset_rad2(f) = schur.offsets.solve(row).eval()(f);
  }
  for (std::size_t k = 0; k < variances.drift_rad2.size(); ++k) {
    for (Eigen::Index f = 0; f < num_offsets; ++f)
      row(f) = schur.columns[static_cast<std::size_t>(f)][k];
    variances.drift_rad2[k] += row.dot(schur.offsets.solve(row).eval());
  }
  return variances;
}

}  // namespace setsquare
