// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/damped_step.hpp"

#include <Eigen/Cholesky>

namespace setsquare {

template <int kSize>
Eigen::Matrix<double, kSize, 1> damped_step(const NormalEquations<kSize>& data,
                                            const Eigen::Matrix<double, kSize, 1>& damping,
                                            const NormalEquations<kSize>& prior) {
  Eigen::Matrix<double, kSize, kSize> hessian = data.hessian;
  hessian.diagonal() += damping;
  hessian += prior.hessian;
  const Eigen::Matrix<double, kSize, 1> gradient = data.gradient + prior.gradient;
  return hessian.ldlt().solve(-gradient);
}

template Eigen::Vector3d damped_step<3>(const NormalEquations<3>&,
                                        const Eigen::Vector3d&,
                                        const NormalEquations<3>&);
template Eigen::Matrix<double, 5, 1> damped_step<5>(const NormalEquations<5>&,
                                                    const Eigen::Matrix<double, 5, 1>&,
                                                    const NormalEquations<5>&);

}  // namespace setsquare
