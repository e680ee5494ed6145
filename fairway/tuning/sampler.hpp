// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "fairway/core/rng.hpp"
#include "fairway/tuning/cma_es.hpp"
#include "fairway/tuning/parameter_space.hpp"

namespace fairway {

/// Proposes settings, and learns from the order in which they came out: numbers by CmaEs, integers by a
/// truncated normal distribution, choices by frequencies, both around the better half of each generation.
/// A value; the same seed and the same orders give the same settings.
class Sampler {
 public:
  Sampler(std::vector<TunedParameter> parameters, Rng rng);

  /// Of a generation.
  std::size_t population() const { return population_; }

  Setting ask();

  /// A generation, best first; its numbers are those that were asked for. At least four where there are
  /// numbers; of integers and choices alone any, where one by itself teaches nothing.
  void tell(std::span<const Setting> best_first);

  /// Begins again with the first distributions around `setting`.
  void restart(const Setting& setting);

  /// Whether another generation would hardly propose anything new.
  bool has_converged() const;

 private:
  /// The distribution of one integer or choice.
  struct Discrete {
    double mean{};
    double deviation{};
    std::vector<double> shares;  ///< of choices
  };

  double draw(const TunedParameter& parameter, const Discrete& discrete);
  void learn(const TunedParameter& parameter, Discrete& discrete, std::size_t i,
             std::span<const Setting> better);

  std::vector<TunedParameter> parameters_;
  Rng rng_;
  std::vector<std::size_t> numbers_;  ///< indices of those that CmaEs searches
  std::optional<CmaEs> cma_;
  std::vector<Discrete> discrete_;  ///< one for every parameter; of numbers it is not used
  std::size_t population_;
};

}  // namespace fairway
