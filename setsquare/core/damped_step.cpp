// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// In plain loops: Eigen's LDLT costs the build five seconds. Sums in its order give the same bits.
#include "setsquare/core/damped_step.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace setsquare {
namespace {

template <int kSize>
using Square = Eigen::Matrix<double, kSize, kSize>;
template <int kSize>
using Column = Eigen::Matrix<double, kSize, 1>;

/// Rows and columns k and l > k of a symmetric matrix change places; below the diagonal.
template <int kSize>
void swap_axes(Square<kSize>& A, int k, int l) {
  for (int j = 0; j < k; ++j) std::swap(A(k, j), A(l, j));
  for (int i = l + 1; i < kSize; ++i) std::swap(A(i, k), A(i, l));
  for (int i = k + 1; i < l; ++i) std::swap(A(i, k), A(l, i));
  std::swap(A(k, k), A(l, l));
}

/// Takes from column k what the columns before it explain.
template <int kSize>
void reduce_column(Square<kSize>& A, int k) {
  for (int i = k; i < kSize && k > 0; ++i) {
    double explained = A(i, 0) * (A(0, 0) * A(k, 0));
    for (int j = 1; j < k; ++j) explained += A(i, j) * (A(j, j) * A(k, j));
    A(i, k) -= explained;
  }
}

/// P^T L D L^T P, the largest pivot first: L below the diagonal, D on it, in place of the matrix.
template <int kSize>
struct Factors {
  explicit Factors(const Square<kSize>& matrix) : A(matrix) {
    for (int k = 0; k < kSize; ++k) {
      int largest = k;
      for (int i = k + 1; i < kSize; ++i) {
        if (std::abs(A(i, i)) > std::abs(A(largest, largest))) largest = i;
      }
      swapped_with[k] = largest;
      if (largest != k) swap_axes<kSize>(A, k, largest);
      reduce_column<kSize>(A, k);
      if (!(std::abs(A(k, k)) > 0.0)) continue;
      for (int i = k + 1; i < kSize; ++i) A(i, k) /= A(k, k);
    }
  }
  Square<kSize> A;
  std::array<int, kSize> swapped_with{};
};

/// In halves.
double sum_of_terms(const double* terms, int size) {
  if (size == 1) return terms[0];
  return sum_of_terms(terms, size / 2) + sum_of_terms(terms + size / 2, size - size / 2);
}

/// By twos.
double sum_by_twos(const double* terms, int size) {
  if (size == 1) return terms[0];
  double even = terms[0];
  double odd = terms[1];
  for (int k = 2; k + 1 < size; k += 2) {
    even += terms[k];
    odd += terms[k + 1];
  }
  return size % 2 == 0 ? even + odd : even + odd + terms[size - 1];
}

template <int kSize>
Column<kSize> solution(const Factors<kSize>& factors, Column<kSize> x) {
  const Square<kSize>& A = factors.A;
  std::array<double, kSize> terms{};
  for (int k = 0; k < kSize; ++k) std::swap(x[k], x[factors.swapped_with[k]]);
  for (int i = 1; i < kSize; ++i) {
    for (int j = 0; j < i; ++j) terms[j] = A(i, j) * x[j];
    x[i] -= sum_of_terms(terms.data(), i);
  }
  // What nothing determines does not move.
  for (int k = 0; k < kSize; ++k) {
    x[k] = std::abs(A(k, k)) > std::numeric_limits<double>::min() ? x[k] / A(k, k) : 0.0;
  }
  for (int i = kSize - 2; i >= 0; --i) {
    for (int j = i + 1; j < kSize; ++j) terms[j - i - 1] = A(j, i) * x[j];
    x[i] -= sum_by_twos(terms.data(), kSize - 1 - i);
  }
  for (int k = kSize - 1; k >= 0; --k) std::swap(x[k], x[factors.swapped_with[k]]);
  return x;
}

}  // namespace

template <int kSize>
Column<kSize> damped_step(const NormalEquations<kSize>& data,
                          const Eigen::Matrix<double, kSize, 1>& damping,
                          const NormalEquations<kSize>& prior) {
  Square<kSize> hessian = data.hessian;
  hessian.diagonal() += damping;
  hessian += prior.hessian;
  const Column<kSize> gradient = data.gradient + prior.gradient;
  return solution<kSize>(Factors<kSize>(hessian), -gradient);
}

template Eigen::Vector3d damped_step<3>(const NormalEquations<3>&,
                                        const Eigen::Vector3d&,
                                        const NormalEquations<3>&);
template Eigen::Matrix<double, 5, 1> damped_step<5>(const NormalEquations<5>&,
                                                    const Eigen::Matrix<double, 5, 1>&,
                                                    const NormalEquations<5>&);

}  // namespace setsquare
