// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/block_equations.hpp"

#include <algorithm>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <functional>
#include <utility>

namespace setsquare {
namespace {

/// Columns of a factor whose solution a right-hand side with these entries reaches, ascending: from
/// each its way up the elimination tree, in which a column's parent is the first row below it.
std::vector<int> columns_reached(const Eigen::SparseMatrix<double>& L, std::vector<int> entries) {
  std::vector<int> reached;
  std::sort(entries.begin(), entries.end(), std::greater<>());
  while (!entries.empty()) {
    const int column = entries.back();
    entries.pop_back();
    reached.push_back(column);
    const int begin = L.outerIndexPtr()[column];
    if (begin == L.outerIndexPtr()[column + 1]) continue;
    const int parent = L.innerIndexPtr()[begin];
    const auto place = std::lower_bound(entries.begin(), entries.end(), parent, std::greater<>());
    if (place == entries.end() || *place != parent) entries.insert(place, parent);
  }
  return reached;
}

}  // namespace

struct SparseBlocks::Sparse {
  /// Eigen's minimum degree ordering of a symmetric matrix that is stored in full. Eigen's own
  /// makes the sum with the transposed matrix first, values and all: several times the memory for
  /// the same order.
  struct Ordering {
    using PermutationType = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

    void operator()(const Eigen::SparseMatrix<double>& full, PermutationType& order) const {
      const Eigen::SparseMatrix<signed char> pattern = full.cast<signed char>();
      Eigen::AMDOrdering<int>()(pattern.selfadjointView<Eigen::Lower>(), order);
    }
  };

  Eigen::SparseMatrix<double> matrix;  ///< Lower triangle.
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Ordering> solver;
};

SparseBlocks::SparseBlocks(int size, std::size_t num_blocks, const std::vector<Pair>& pairs)
    : size_(size), sparse_(std::make_unique<Sparse>()) {
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
  entries.reserve(blocks.size() * static_cast<std::size_t>(size * size));
  for (const auto& [column_block, row_block] : blocks) {
    for (int column = 0; column < size; ++column) {
      for (int row = row_block == column_block ? column : 0; row < size; ++row) {
        entries.emplace_back(static_cast<int>(row_block) * size + row,
                             static_cast<int>(column_block) * size + column,
                             0.0);
      }
    }
  }
  const auto n = static_cast<Eigen::Index>(num_blocks) * size;
  sparse_->matrix.resize(n, n);
  sparse_->matrix.setFromTriplets(entries.begin(), entries.end());
  sparse_->solver.analyzePattern(sparse_->matrix);
  values_ = sparse_->matrix.valuePtr();
  column_starts_ = sparse_->matrix.outerIndexPtr();

  places_.reserve(pairs.size());
  for (const auto& [first, second] : pairs) {
    const Pair block = std::minmax(first, second);
    const auto found = std::lower_bound(blocks.begin(), blocks.end(), block);
    const auto index = static_cast<std::size_t>(found - blocks.begin());
    const auto num_before = static_cast<std::ptrdiff_t>(index - block_start[block.first]) - 1;
    places_.push_back({block.first, num_before * size, first < second});
  }
}

SparseBlocks::~SparseBlocks() = default;
SparseBlocks::SparseBlocks(SparseBlocks&&) noexcept = default;
SparseBlocks& SparseBlocks::operator=(SparseBlocks&&) noexcept = default;

void SparseBlocks::set_zero() { std::fill_n(values_, sparse_->matrix.nonZeros(), 0.0); }

double SparseBlocks::factor() {
  auto& [matrix, solver] = *sparse_;
  solver.factorize(matrix);
  if (solver.info() != Eigen::Success) return 0.0;
  const Eigen::VectorXd diagonal = solver.permutationP() * Eigen::VectorXd(matrix.diagonal());
  return (solver.vectorD().array() / diagonal.array()).minCoeff();
}

Eigen::VectorXd SparseBlocks::solve(const Eigen::VectorXd& column) const {
  return sparse_->solver.solve(column);
}

Eigen::MatrixXd SparseBlocks::inverse_form(std::span<const BlockRows> rows) const {
  const auto& solver = sparse_->solver;
  const Eigen::SparseMatrix<double>& L = solver.matrixL().nestedExpression();
  const auto place_of = [&](const BlockRows& of_block, int row) {
    return solver.permutationP().indices()[static_cast<int>(of_block.block) * size_ + row];
  };
  std::vector<int> entries;
  for (const BlockRows& of_block : rows) {
    for (int row = 0; row < size_; ++row) entries.push_back(place_of(of_block, row));
  }
  const std::vector<int> reached = columns_reached(L, std::move(entries));
  const auto num_reached = static_cast<Eigen::Index>(reached.size());
  // Nothing but what is reached is read or written.
  const auto x = std::make_unique_for_overwrite<double[]>(static_cast<std::size_t>(L.cols()));
  Eigen::MatrixXd Y(num_reached, rows.front().values.cols());  // L Y = C.
  for (Eigen::Index column = 0; column < Y.cols(); ++column) {
    for (const int k : reached) x[k] = 0.0;
    for (const BlockRows& of_block : rows) {
      for (int row = 0; row < size_; ++row) {
        x[place_of(of_block, row)] = of_block.values(row, column);
      }
    }
    for (Eigen::Index k = 0; k < num_reached; ++k) {
      const double value = Y(k, column) = x[reached[k]];
      if (value == 0.0) continue;
      const int end = L.outerIndexPtr()[reached[k] + 1];
      for (int entry = L.outerIndexPtr()[reached[k]]; entry < end; ++entry) {
        x[L.innerIndexPtr()[entry]] -= L.valuePtr()[entry] * value;
      }
    }
  }
  const Eigen::VectorXd all_pivots = solver.vectorD();
  Eigen::VectorXd pivots(num_reached);
  for (Eigen::Index k = 0; k < num_reached; ++k) pivots[k] = all_pivots[reached[k]];
  const Eigen::MatrixXd form = Y.transpose() * pivots.cwiseInverse().asDiagonal() * Y;
  return 0.5 * (form + form.transpose());
}

}  // namespace setsquare
