// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <Eigen/Core>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <utility>
#include <vector>

namespace setsquare {

/// Eigen's minimum degree ordering of a symmetric matrix that is stored in full. Eigen's own makes
/// the sum with the transposed matrix first, values and all: several times the memory for the same
/// order.
class SymmetricOrdering {
 public:
  using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;
  using PermutationType = Permutation;

  void operator()(const Eigen::SparseMatrix<double>& full, Permutation& order) const {
    const Eigen::SparseMatrix<signed char> pattern = full.cast<signed char>();
    Eigen::AMDOrdering<int>()(pattern.selfadjointView<Eigen::Lower>(), order);
  }
};

/// Normal equations H x = b of blocks of unknowns, `size` in each, that are coupled in given pairs:
/// the sparse matrix' pattern and the order of elimination (minimum degree) are found once, its
/// values may change and be factored any number of times.
template <int size>
class BlockEquations {
 public:
  using Block = Eigen::Matrix<double, size, size>;
  using Segment = Eigen::Matrix<double, size, 1>;
  using Pair = std::pair<std::size_t, std::size_t>;

  /// All zero. Both ends of a pair differ; pairs may repeat.
  BlockEquations(std::size_t num_blocks, const std::vector<Pair>& pairs) {
    const auto n = static_cast<Eigen::Index>(num_blocks) * size;
    b = Eigen::VectorXd::Zero(n);
    matrix_.resize(n, n);
    lay_out(num_blocks, pairs);
    solver_.analyzePattern(matrix_);
  }

  Eigen::VectorXd b;  ///< The right-hand side.

  void set_zero() {
    std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
    b.setZero();
  }

  /// Adds a symmetric block to the diagonal.
  void add_diagonal(std::size_t block, const Block& H) {
    for (int column = 0; column < size; ++column) {
      double* values = column_values(block, column);
      for (int row = column; row < size; ++row) values[row - column] += H(row, column);
    }
  }

  /// Adds H to the block that couples the k-th pair: rows of its first, columns of its second.
  void add_pair(std::size_t k, const Block& H) {
    const Place& place = places_[k];
    for (int column = 0; column < size; ++column) {
      double* values = column_values(place.column, column) + (size - column) + place.offset;
      for (int row = 0; row < size; ++row) {
        values[row] += place.is_transposed ? H(column, row) : H(row, column);
      }
    }
  }

  void add_to_b(std::size_t block, const Segment& values) {
    b.template segment<size>(static_cast<Eigen::Index>(block) * size) += values;
  }

  /// Factors H = P^T L D L^T P. Returns the smallest pivot in D as a share of the diagonal entry it
  /// came from: 1 where nothing is coupled, hardly above rounding or below where H is singular.
  [[nodiscard]] double factor() {
    solver_.factorize(matrix_);
    if (solver_.info() != Eigen::Success) return 0.0;
    const Eigen::VectorXd diagonal = solver_.permutationP() * Eigen::VectorXd(matrix_.diagonal());
    return (solver_.vectorD().array() / diagonal.array()).minCoeff();
  }

  /// H^-1 times one or more columns, after factor().
  template <typename Columns>
  [[nodiscard]] Columns solve(const Columns& columns) const {
    return solver_.solve(columns);
  }

 private:
  /// Where the block of a pair begins.
  struct Place {
    std::size_t column = 0;     ///< The lower of the two blocks.
    std::ptrdiff_t offset = 0;  ///< Behind the diagonal block, in each of its columns.
    bool is_transposed = false;
  };

  double* column_values(std::size_t block, int column) {
    return matrix_.valuePtr() + matrix_.outerIndexPtr()[block * size + column];
  }

  void lay_out(std::size_t num_blocks, const std::vector<Pair>& pairs);

  Eigen::SparseMatrix<double> matrix_;  ///< Lower triangle.
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, SymmetricOrdering> solver_;
  std::vector<Place> places_;
};

template <int size>
void BlockEquations<size>::lay_out(std::size_t num_blocks, const std::vector<Pair>& pairs) {
  // The lower triangle's blocks, diagonal included, each once, column by column.
  std::vector<Pair> blocks;
  blocks.reserve(num_blocks + pairs.size());
  for (std::size_t k = 0; k < num_blocks; ++k) blocks.emplace_back(k, k);
  for (const auto& [first, second] : pairs) blocks.push_back(std::minmax(first, second));
  std::sort(blocks.begin(), blocks.end());
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());

  std::vector<std::size_t> block_start(num_blocks + 1, blocks.size());
  for (std::size_t k = blocks.size(); k-- > 0;) block_start[blocks[k].first] = k;

  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(blocks.size() * size * size);
  for (const auto& [column_block, row_block] : blocks) {
    for (int column = 0; column < size; ++column) {
      for (int row = row_block == column_block ? column : 0; row < size; ++row) {
        entries.emplace_back(static_cast<int>(row_block) * size + row,
                             static_cast<int>(column_block) * size + column,
                             0.0);
      }
    }
  }
  matrix_.setFromTriplets(entries.begin(), entries.end());

  places_.reserve(pairs.size());
  for (const auto& [first, second] : pairs) {
    const Pair block = std::minmax(first, second);
    const auto found = std::lower_bound(blocks.begin(), blocks.end(), block);
    const auto index = static_cast<std::size_t>(found - blocks.begin());
    const auto num_before = static_cast<std::ptrdiff_t>(index - block_start[block.first]) - 1;
    places_.push_back({block.first, num_before * size, first < second});
  }
}

}  // namespace setsquare
