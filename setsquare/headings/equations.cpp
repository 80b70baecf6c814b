// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/headings/equations.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

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

DenseFactor::DenseFactor(std::vector<std::vector<double>> rows)
    : rows_(std::move(rows)), swapped_with_(rows_.size()) {
  const std::size_t n = rows_.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) rows_[j][i] = rows_[i][j];
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t largest = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (std::abs(rows_[i][i]) > std::abs(rows_[largest][largest])) largest = i;
    }
    swapped_with_[k] = largest;
    swap_axes(k, largest);
    reduce_column(k);
    for (std::size_t i = k + 1; i < n; ++i) rows_[i][k] /= rows_[k][k];
  }
}

void DenseFactor::swap_axes(std::size_t k, std::size_t l) {
  std::swap(rows_[k], rows_[l]);
  for (std::vector<double>& row : rows_) std::swap(row[k], row[l]);
}

void DenseFactor::reduce_column(std::size_t k) {
  for (std::size_t i = k; i < rows_.size(); ++i) {
    double explained = 0.0;
    for (std::size_t j = 0; j < k; ++j) explained += rows_[i][j] * (rows_[j][j] * rows_[k][j]);
    rows_[i][k] -= explained;
  }
}

std::vector<double> DenseFactor::solve(std::vector<double> right) const {
  const std::size_t n = rows_.size();
  assert(right.size() == n);
  for (std::size_t k = 0; k < n; ++k) std::swap(right[k], right[swapped_with_[k]]);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) right[i] -= rows_[i][j] * right[j];
  }
  for (std::size_t k = 0; k < n; ++k) right[k] /= rows_[k][k];
  for (std::size_t i = n; i-- > 0;) {
    double explained = 0.0;
    for (std::size_t j = i + 1; j < n; ++j) explained += rows_[j][i] * right[j];
    right[i] -= explained;
  }
  for (std::size_t k = n; k-- > 0;) std::swap(right[k], right[swapped_with_[k]]);
  return right;
}

HeadingEquations::HeadingEquations(std::size_t num_keyframes, std::size_t num_frames)
    : chain_(num_keyframes),
      border_(num_frames - 1, std::vector<double>(num_keyframes, 0.0)),
      offset_diagonal_(num_frames - 1, 0.0),
      offset_right_(num_frames - 1, 0.0) {
  assert(num_frames > 0);
}

void HeadingEquations::bind(std::size_t k, std::size_t frame, double value_rad, double weight) {
  chain_.bind(k, value_rad, weight);
  if (frame == 0) return;
  border_[frame - 1][k] += weight;
  bind_offset(frame, value_rad, weight);
}

void HeadingEquations::bind_offset(std::size_t frame, double value_rad, double weight) {
  offset_diagonal_[frame - 1] += weight;
  offset_right_[frame - 1] += weight * value_rad;
}

HeadingEquations::Schur HeadingEquations::eliminate() const {
  Schur schur{TridiagonalFactor(chain_), {}, {}};
  for (const std::vector<double>& column : border_)
    schur.columns.push_back(schur.chain.solve(column));
  const std::size_t num_offsets = border_.size();
  std::vector<std::vector<double>> offsets(num_offsets, std::vector<double>(num_offsets, 0.0));
  for (std::size_t a = 0; a < num_offsets; ++a) {
    offsets[a][a] = offset_diagonal_[a];
    for (std::size_t b = 0; b <= a; ++b) offsets[a][b] -= dot(border_[a], schur.columns[b]);
  }
  schur.offsets = DenseFactor(std::move(offsets));
  return schur;
}

HeadingSolution HeadingEquations::solve() const {
  const Schur schur = eliminate();
  HeadingSolution solution{schur.chain.solve(chain_.right), offset_right_};
  for (std::size_t f = 0; f < border_.size(); ++f) {
    solution.offset_rad[f] -= dot(border_[f], solution.drift_rad);
  }
  solution.offset_rad = schur.offsets.solve(std::move(solution.offset_rad));
  for (std::size_t f = 0; f < border_.size(); ++f) {
    for (std::size_t k = 0; k < solution.drift_rad.size(); ++k) {
      solution.drift_rad[k] -= schur.columns[f][k] * solution.offset_rad[f];
    }
  }
  return solution;
}

HeadingVariances HeadingEquations::variances() const {
  const Schur schur = eliminate();
  HeadingVariances variances{schur.chain.inverse_diagonal(), {}};
  const std::size_t num_offsets = border_.size();
  std::vector<std::vector<double>> inverse;
  for (std::size_t f = 0; f < num_offsets; ++f) {
    std::vector<double> unit(num_offsets, 0.0);
    unit[f] = 1.0;
    inverse.push_back(schur.offsets.solve(std::move(unit)));
    variances.offset_rad2.push_back(inverse[f][f]);
  }
  std::vector<double> row(num_offsets);
  for (std::size_t k = 0; k < variances.drift_rad2.size(); ++k) {
    for (std::size_t f = 0; f < num_offsets; ++f) row[f] = schur.columns[f][k];
    double added_rad2 = 0.0;
    for (std::size_t a = 0; a < num_offsets; ++a) {
      double bound = 0.0;
      for (std::size_t b = 0; b < num_offsets; ++b) bound += inverse[b][a] * row[b];
      added_rad2 += row[a] * bound;
    }
    variances.drift_rad2[k] += added_rad2;
  }
  return variances;
}

}  // namespace setsquare
