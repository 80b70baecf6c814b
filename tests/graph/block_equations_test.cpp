// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/block_equations.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

#include "tests/support/seed.hpp"

namespace setsquare::block_equations_test {

using testing::make_generator;

template <int size>
struct Equations {
  BlockEquations<size> sparse;
  Eigen::MatrixXd dense;
};

/// A chain of so many blocks, cut in its middle, with some pairs across each half; positive
/// definite.
template <int size>
Equations<size> random_equations(std::size_t num_blocks, std::mt19937_64& generator) {
  using Block = typename BlockEquations<size>::Block;
  std::vector<SparseBlocks::Pair> pairs;
  const std::size_t half = num_blocks / 2;
  for (std::size_t k = 1; k < num_blocks; ++k) {
    if (k != half) pairs.emplace_back(k - 1, k);
  }
  std::uniform_int_distribution<std::size_t> any(0, half - 1);
  for (std::size_t k = 0; k < num_blocks / 4; ++k) {
    const std::size_t first = k % 2 == 0 ? 0 : half;
    const std::size_t from = first + any(generator);
    const std::size_t to = first + any(generator);
    if (from != to) pairs.emplace_back(from, to);
  }
  Equations<size> equations{
      {num_blocks, pairs},
      Eigen::MatrixXd::Identity(static_cast<Eigen::Index>(num_blocks) * size,
                                static_cast<Eigen::Index>(num_blocks) * size)};
  std::normal_distribution<double> normal;
  const auto any_block = [&] { return Block::NullaryExpr([&] { return normal(generator); }); };
  const auto place = [](std::size_t block) { return static_cast<Eigen::Index>(block) * size; };
  for (std::size_t k = 0; k < num_blocks; ++k) {
    equations.sparse.add_diagonal(k, Block::Identity());
  }
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto [from, to] = pairs[k];
    const Block A = any_block();
    const Block B = any_block();
    equations.sparse.add_diagonal(from, A.transpose() * A);
    equations.sparse.add_diagonal(to, B.transpose() * B);
    equations.sparse.add_pair(k, A.transpose() * B);
    equations.dense.template block<size, size>(place(from), place(from)) += A.transpose() * A;
    equations.dense.template block<size, size>(place(to), place(to)) += B.transpose() * B;
    equations.dense.template block<size, size>(place(from), place(to)) += A.transpose() * B;
    equations.dense.template block<size, size>(place(to), place(from)) += B.transpose() * A;
  }
  return equations;
}

/// The plain twin: the dense inverse between dense columns.
template <int size>
void expect_form_of_dense_inverse(std::mt19937_64& generator) {
  constexpr std::size_t kNumBlocks = 60;
  Equations<size> equations = random_equations<size>(kNumBlocks, generator);
  ASSERT_GT(equations.sparse.factor(), 0.0);
  const Eigen::MatrixXd inverse = equations.dense.inverse();
  std::normal_distribution<double> normal;
  for (const std::vector<std::size_t>& blocks : std::vector<std::vector<std::size_t>>{
           {0}, {kNumBlocks - 1}, {7, 8}, {8, 7}, {3, 50}, {50, 3, 29, 31}}) {
    Eigen::MatrixXd C = Eigen::MatrixXd::Zero(inverse.rows(), 2);
    std::vector<BlockRows> rows;
    for (const std::size_t block : blocks) {
      rows.push_back(
          {block, Eigen::MatrixXd::NullaryExpr(size, 2, [&] { return normal(generator); })});
      C.middleRows<size>(static_cast<Eigen::Index>(block) * size) = rows.back().values;
    }
    const Eigen::MatrixXd expected = C.transpose() * inverse * C;
    const Eigen::MatrixXd found = equations.sparse.inverse_form(rows);
    EXPECT_LE((found - expected).norm(), 1e-9 * expected.norm())
        << size << " rows in a block, " << blocks.size() << " blocks from " << blocks.front();
    EXPECT_EQ(found, found.transpose());
  }
}

TEST(BlockEquations, FormOfTheInverseIsThatOfTheDenseOne) {
  std::mt19937_64 generator = make_generator();
  expect_form_of_dense_inverse<1>(generator);
  expect_form_of_dense_inverse<2>(generator);
  expect_form_of_dense_inverse<3>(generator);
}

/// A form of one unknown is what solving for it gives.
TEST(BlockEquations, FormOfTheInverseIsThatOfASolve) {
  std::mt19937_64 generator = make_generator();
  Equations<3> equations = random_equations<3>(200, generator);
  ASSERT_GT(equations.sparse.factor(), 0.0);
  for (std::size_t block = 0; block < 200; block += 13) {
    const Eigen::Index row = 3 * static_cast<Eigen::Index>(block) + 1;
    const Eigen::VectorXd column = Eigen::VectorXd::Unit(equations.sparse.b.size(), row);
    const double expected = equations.sparse.solve(column)[row];
    const BlockRows unit{block, Eigen::Vector3d::UnitY()};
    EXPECT_NEAR(equations.sparse.inverse_form({&unit, 1})(0, 0), expected, 1e-9 * expected);
  }
}

}  // namespace setsquare::block_equations_test
