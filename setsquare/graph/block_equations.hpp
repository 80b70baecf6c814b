// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace setsquare {

/// The rows of a matrix that belong to one block of unknowns.
struct BlockRows {
  std::size_t block = 0;
  Eigen::MatrixXd values;
};

/// A sparse symmetric matrix of square blocks and its factors, compiled once: Eigen's sparse solver
/// costs each unit of sources that includes it ten seconds.
class SparseBlocks {
 public:
  using Pair = std::pair<std::size_t, std::size_t>;

  /// Where the block of a pair begins.
  struct Place {
    std::size_t column = 0;     ///< The lower of the two blocks.
    std::ptrdiff_t offset = 0;  ///< Behind the diagonal block, in each of its columns.
    bool is_transposed = false;
  };

  /// All zero; `size` rows in each block.
  SparseBlocks(int size, std::size_t num_blocks, const std::vector<Pair>& pairs);
  ~SparseBlocks();
  SparseBlocks(SparseBlocks&&) noexcept;
  SparseBlocks& operator=(SparseBlocks&&) noexcept;

  void set_zero();
  /// The lower triangle's column, from the diagonal on.
  [[nodiscard]] double* column_values(std::size_t column) {
    return values_ + column_starts_[column];
  }
  [[nodiscard]] const Place& place(std::size_t pair) const { return places_[pair]; }

  /// As BlockEquations has them.
  [[nodiscard]] double factor();
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& column) const;
  [[nodiscard]] Eigen::MatrixXd inverse_form(std::span<const BlockRows> rows) const;

 private:
  struct Sparse;

  int size_ = 0;  ///< Rows of a block.
  std::unique_ptr<Sparse> sparse_;
  double* values_ = nullptr;            ///< Of the sparse matrix.
  const int* column_starts_ = nullptr;  ///< The same.
  std::vector<Place> places_;
};

/// Normal equations H x = b of blocks of unknowns, `size` in each, that are coupled in given pairs:
/// the sparse matrix' pattern and the order of elimination (minimum degree) are found once, its
/// values may change and be factored any number of times.
template <int size>
class BlockEquations {
 public:
  using Block = Eigen::Matrix<double, size, size>;
  using Segment = Eigen::Matrix<double, size, 1>;
  using Pair = SparseBlocks::Pair;

  /// All zero. Both ends of a pair differ; pairs may repeat.
  BlockEquations(std::size_t num_blocks, const std::vector<Pair>& pairs)
      : b(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(num_blocks) * size)),
        matrix_(size, num_blocks, pairs) {}

  Eigen::VectorXd b;  ///< The right-hand side.

  void set_zero() {
    matrix_.set_zero();
    b.setZero();
  }

  /// Adds a symmetric block to the diagonal.
  void add_diagonal(std::size_t block, const Block& H) {
    for (int column = 0; column < size; ++column) {
      double* values = matrix_.column_values(block * size + column);
      for (int row = column; row < size; ++row) values[row - column] += H(row, column);
    }
  }

  /// Adds H to the block that couples the k-th pair: rows of its first, columns of its second.
  void add_pair(std::size_t k, const Block& H) {
    const SparseBlocks::Place& place = matrix_.place(k);
    for (int column = 0; column < size; ++column) {
      double* values =
          matrix_.column_values(place.column * size + column) + (size - column) + place.offset;
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
  [[nodiscard]] double factor() { return matrix_.factor(); }

  /// H^-1 times a column, after factor().
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& column) const {
    return matrix_.solve(column);
  }

  /// C^T H^-1 C, after factor(). `rows`: those of C that are not zero, at least one block of them,
  /// each once. Reads the factor's columns on the way from these blocks to the root of the
  /// elimination tree alone, which in a large graph are few: benchmarks/scaling.
  [[nodiscard]] Eigen::MatrixXd inverse_form(std::span<const BlockRows> rows) const {
    return matrix_.inverse_form(rows);
  }

 private:
  SparseBlocks matrix_;  ///< H.
};

}  // namespace setsquare
