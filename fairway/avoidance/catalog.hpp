// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fairway/avoidance/avoider.hpp"

namespace fairway {

/// The algorithms a program offers, by name. An ordinary value: nothing registers itself.
///
/// A wrapper is written behind what it wraps: "orca3d+stop_and_wait". A parameter goes to every
/// layer that has one of that name, so "apf+stop_and_wait" takes one `crit_dist_m` for both.
class Catalog {
 public:
  struct Entry {
    AlgorithmInfo info;
    std::vector<ParamInfo> params;
    bool wraps = false;
    std::string version{};  ///< A::version of a method outside fairway, if it has one: raised whenever it
                            ///< decides otherwise than before, so that stores make its runs again
    std::function<Avoider(const ParamValues&, Rng)> make;                  ///< of an algorithm
    std::function<Avoider(Avoider, const ParamValues&, Rng)> make_around;  ///< of a wrapper
  };

  template <AvoidanceAlgorithm A>
  Catalog& add() {
    return add({.info = A::info,
                .params = describe_params<typename A::Params>(),
                .version = version_of<A>(),
                .make =
                    [](const ParamValues& values, Rng rng) {
                      return Avoider{A{chosen<typename A::Params>(values)}, rng};
                    },
                .make_around = {}});
  }

  /// `alone` is the algorithm wrapped when the wrapper's name stands by itself.
  template <AvoidanceWrapper W, AvoidanceAlgorithm Alone>
  Catalog& add_wrapper() {
    return add({.info = W::info,
                .params = describe_params<typename W::Params>(),
                .wraps = true,
                .version = version_of<W>(),
                .make =
                    [](const ParamValues& values, Rng rng) {
                      return Avoider{W{chosen<typename W::Params>(values)},
                                     Avoider{Alone{chosen<typename Alone::Params>(values)}, rng},
                                     rng.stream("wrapper", 1)};
                    },
                .make_around =
                    [](Avoider inner, const ParamValues& values, Rng rng) {
                      return Avoider{W{chosen<typename W::Params>(values)}, std::move(inner), rng};
                    }});
  }

  /// An algorithm whose name is known only at run time. What the views in `entry.info` are of outlives the
  /// catalog. All three throw InputError for a name that is taken, or that has a '+' or nothing in it.
  Catalog& add(Entry entry);

  /// A short name for another that is there already: "saw" for "stop_and_wait". Throws InputError for a name
  /// that is taken or that layers could not be called by, and as find() for the other.
  Catalog& alias(std::string_view name, std::string_view target);

  /// Throws InputError for a name that is not in the catalog or a parameter that none of the layers has.
  Avoider make(std::string_view name, const ParamValues& values = {}, Rng rng = Rng{0}) const;

  /// The parameters of "inner+wrapper", each name once. Throws InputError as make().
  std::vector<ParamInfo> params(std::string_view name) const;

  /// The layers of "inner+wrapper", the innermost first. Throws InputError as make(). Valid until something
  /// is added.
  std::vector<const Entry*> layers(std::string_view name) const;

  /// Whether every layer of "inner+wrapper" ignores it: what one of them sees, the whole avoids. `what` is
  /// `&AlgorithmInfo::ignores_obstacles` or `ignores_movers`. Throws InputError as make().
  bool ignores(std::string_view name, bool AlgorithmInfo::*what) const;

  /// Whether any layer of "inner+wrapper" needs it, as `&AlgorithmInfo::needs_envelope`. Likewise.
  bool needs(std::string_view name, bool AlgorithmInfo::*what) const;

  /// The words of `all_needs` for what "inner+wrapper" takes for granted: what a layer does, and no wrapper
  /// that `follows` makes up for. Likewise.
  std::vector<std::string_view> needs_of(std::string_view name) const;

  /// "inner+wrapper" with `trackable` behind the last layer that decides, inside of those that only show:
  /// the name itself where a layer `follows` already, where all of it avoids nobody, or where this catalog
  /// has no `trackable`. Likewise.
  std::string tracked(std::string_view name) const;

  /// "inner+wrapper" with `way_round` outermost: the name itself where a layer `finds_way` already, where
  /// `trackable` has been chosen by name, where all of it avoids nobody, or where this catalog has no
  /// `way_round`. Likewise.
  std::string guided(std::string_view name) const;

  /// Throws InputError with the nearest known name.
  const Entry& find(std::string_view name) const;

  /// Whether find() would.
  bool has(std::string_view name) const;

  std::span<const Entry> entries() const { return entries_; }

 private:
  template <Reflected P>
  static P chosen(const ParamValues& values) {
    return params_of(values, P{}, /*optional=*/true);
  }

  template <class A>
  static std::string version_of() {
    if constexpr (requires { std::string{A::version}; }) return std::string{A::version};
    return {};
  }

  bool avoids_nobody(std::string_view name) const;

  std::vector<Entry> entries_;
  /// Throws InputError for a name that nothing can be added by.
  void refuse_unless_free(std::string_view name) const;

  std::vector<std::pair<std::string, std::string>> aliases_;  // of names of entries
};

/// "inner" and "wrapper" of "inner+wrapper".
std::vector<std::string_view> layer_names(std::string_view name);

/// Every algorithm that comes with fairway.
Catalog builtin_avoiders();

}  // namespace fairway
