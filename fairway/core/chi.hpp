// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace fairway {

/// The length that the norm of a vector of `dimensions` (1 to 10) standard Gaussians does not exceed with
/// `probability`, in [0, 1): the quantile of the chi distribution; its square is that of chi-square.
double chi_quantile(double probability, int dimensions);

}  // namespace fairway
