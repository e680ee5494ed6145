// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "fairway/core/params.hpp"
#include "fairway/core/rng.hpp"
#include "fairway/core/vec.hpp"
#include "fairway/scenario/tree.hpp"

namespace fairway::yaml {

/// The numbers that are accepted: [lo, hi], or (lo, hi].
struct Bounds {
  double lo{};
  double hi{};
  bool above{};  ///< lo itself is not accepted

  bool holds(double value) const { return (above ? value > lo : value >= lo) && value <= hi; }
  std::string text() const;
};

constexpr Bounds from_to(double lo, double hi) { return {lo, hi, false}; }
constexpr Bounds above_to(double lo, double hi) { return {lo, hi, true}; }

/// What is common to all values of one document while it is read.
struct Reading {
  Reading() = default;
  explicit Reading(std::uint64_t seed) : rng{seed} {}

  std::optional<Rng> rng;  ///< each distribution draws from the stream of its path; none is read without
  std::unordered_map<std::string_view, const Tree*> missions;  ///< named ones
  bool partial{};                                              ///< reading defaults: no key is missing
  std::size_t steps_left{200'000};  ///< legs that the vehicles' missions may have in all
};

/// A cursor: one value of a tree, the path that led to it and what it may be read as. Every reader
/// throws InputError with the place, the path, what was expected and what is there.
class Value {
 public:
  Value(const Tree& tree, std::string path, Reading& reading)
      : tree_{&tree}, path_{std::move(path)}, reading_{&reading} {}

  const Tree& tree() const { return *tree_; }
  const std::string& path() const { return path_; }
  Reading& reading() const { return *reading_; }

  /// A map's i-th entry, a list's i-th item.
  Value entry(std::size_t i) const;
  /// The value of a map's key. O(keys).
  std::optional<Value> find(std::string_view key) const;
  /// The same; throws if the key is missing.
  Value at(std::string_view key) const;

  double number(Bounds bounds) const;  ///< or a distribution, drawn
  Vec3 vector(Bounds each) const;      ///< [n, e, d]
  Vec3 vertex(Bounds each) const;      ///< [n, e] or [n, e, d]
  bool flag() const;
  std::string text() const;
  ParamValue param() const;

  template <std::integral T>
  T whole(T lo = std::numeric_limits<T>::min(), T hi = std::numeric_limits<T>::max()) const;

  /// These throw unless the value is a list or a mapping; nothing written counts as an empty one.
  void expect_list(std::string_view of) const;
  void expect_map(std::string_view of) const;
  /// Throws unless the value is a mapping of no other keys than these.
  void expect_keys(const std::vector<std::string_view>& known) const;

  /// `what` replaces the path of the message for an entry's key, as in "unknown key".
  [[noreturn]] void refuse(const std::string& message) const;
  [[noreturn]] void refuse_key(std::size_t i, const std::string& message) const;
  /// "expected `what`, got …".
  [[noreturn]] void expected(const std::string& what) const;

 private:
  double draw(Bounds bounds) const;
  double item(std::size_t i, Bounds bounds) const;

  const Tree* tree_;
  std::string path_;
  Reading* reading_;
};

/// Throws InputError about `path`, written at `where`. A value from the command line names its own
/// path, which is then not said twice.
[[noreturn]] void refuse_at(const Where& where, const std::string& path, const std::string& message);

/// How the place of an override begins: "--set vehicles[0].radius_m".
inline constexpr std::string_view override_prefix = "--set ";

}  // namespace fairway::yaml
