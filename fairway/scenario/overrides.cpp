// SPDX-License-Identifier: Apache-2.0
#include "fairway/scenario/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <variant>

#include "fairway/scenario/fleet.hpp"
#include "fairway/scenario/value.hpp"

namespace fairway::yaml {
namespace {

/// What a choice written as one word is short for: `avoider: orca3d` is `{algorithm: orca3d}`.
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> shorthands{{{"model", "name"},
                                                                                   {"avoider", "algorithm"},
                                                                                   {"steering", "kind"},
                                                                                   {"allocation", "method"},
                                                                                   {"autopilot", "kind"},
                                                                                   {"perception", "kind"},
                                                                                   {"exchange", "kind"},
                                                                                   {"navigation", "kind"}}};

std::string_view name_key_of(std::string_view key) {
  const auto found =
      std::ranges::find(shorthands, key, &std::pair<std::string_view, std::string_view>::first);
  return found == shorthands.end() ? std::string_view{} : found->second;
}

void grow(Tree& scalar, std::string_view name_key) {
  Tree map{.kind = Tree::Kind::map, .where = scalar.where};
  const Where where = scalar.where;
  map.set(name_key, std::move(scalar), where);
  scalar = std::move(map);
}

/// One step of a path: a key, an index, or every index.
struct Every {};
using Step = std::variant<std::string, std::size_t, Every>;

class Override {
 public:
  Override(const std::string& path, const std::string& value)
      : path_{path},
        where_{.source = std::make_shared<const std::string>(std::string(override_prefix) + path)} {
    parse_path();
    value_ = parse_tree(value, *where_.source, /*located=*/false);
  }

  /// True if it changes what a vehicle says, rather than what the document says of all.
  bool is_of_a_vehicle() const { return steps_.size() > 1 && std::get<std::string>(steps_[0]) == "vehicles"; }

  void apply(Tree& document) const { descend(document, 0, {}); }

 private:
  [[noreturn]] void refuse(const std::string& message) const {
    throw InputError(where_.location(), "", message);
  }

  void parse_path() {
    std::string_view rest = path_;
    const auto refuse_syntax = [&] {
      refuse("write a path such as vehicles[0].limits.max_speed_mps or vehicles[*].avoider");
    };
    while (!rest.empty()) {
      if (rest.front() == '[') {
        const std::size_t end = rest.find(']');
        if (end == std::string_view::npos || steps_.empty()) refuse_syntax();
        const std::string_view inside = rest.substr(1, end - 1);
        std::size_t index{};
        const auto [stop, error] = std::from_chars(inside.data(), inside.data() + inside.size(), index);
        if (inside == "*") {
          steps_.emplace_back(Every{});
        } else if (error == std::errc{} && stop == inside.data() + inside.size()) {
          steps_.emplace_back(index);
        } else {
          refuse_syntax();
        }
        rest.remove_prefix(end + 1);
      } else {
        if (!steps_.empty()) {
          if (rest.front() != '.') refuse_syntax();
          rest.remove_prefix(1);
        }
        const std::string_view key = rest.substr(0, rest.find_first_of(".["));
        if (key.empty() || key.size() > max_key_bytes) refuse_syntax();
        steps_.emplace_back(std::string(key));
        rest.remove_prefix(key.size());
      }
    }
    if (steps_.empty() || steps_.size() > max_tree_depth) refuse_syntax();
  }

  void descend(Tree& tree, std::size_t depth, std::string_view key) const {
    if (depth == steps_.size()) {
      tree = value_;
      return;
    }
    if (const std::string* next = std::get_if<std::string>(&steps_[depth])) {
      const std::string_view name_key = name_key_of(key);
      if (tree.is_scalar() && !name_key.empty()) grow(tree, name_key);
      if (tree.is_null()) tree = {.kind = Tree::Kind::map, .where = where_};
      if (!tree.is_map())
        refuse(shown(*next) + " cannot be set: what holds it is a " + (tree.is_list() ? "list" : "value"));
      Tree* there = tree.find(*next);
      descend(there != nullptr ? *there : tree.set(*next, {.where = where_}, where_), depth + 1, *next);
      return;
    }

    if (!tree.is_list() || tree.items.empty()) {
      refuse(std::string(key.empty() ? "what is indexed" : key) +
             (tree.is_list() || tree.is_null() ? " is empty" : " is not a list"));
    }
    if (const std::size_t* index = std::get_if<std::size_t>(&steps_[depth])) {
      if (*index >= tree.items.size()) {
        refuse(fmt::format("[{}] does not exist; the last one is [{}]", *index, tree.items.size() - 1));
      }
      descend(tree.items[*index], depth + 1, {});
    } else {
      for (Tree& item : tree.items) descend(item, depth + 1, {});
    }
  }

  std::string path_;
  Where where_;
  std::vector<Step> steps_;
  Tree value_;
};

std::string_view stem_of(std::string_view name) { return name.substr(0, name.rfind('_')); }

/// Fills `map` from `defaults`, mapping by mapping. A quantity that is given in another unit is given.
/// A choice that names itself stands as it is: its parameters are not another's.
void fill(Tree& map, const Tree& defaults) {
  for (std::size_t i = 0; i < defaults.keys.size(); ++i) {
    const std::string& key = defaults.keys[i];
    const Tree& value = defaults.items[i];
    Tree* there = map.find(key);
    if (there == nullptr) {
      const auto same = [&](const std::string& k) { return stem_of(k) == stem_of(key); };
      if (std::ranges::none_of(map.keys, same)) map.set(key, value, defaults.where_of(i));
      continue;
    }
    if (!there->is_map()) continue;
    const std::string_view name_key = name_key_of(key);
    if (name_key.empty()) {
      if (value.is_map()) fill(*there, value);
    } else if (there->find(name_key) == nullptr) {
      Tree choice = value;
      if (choice.is_scalar()) grow(choice, name_key);
      if (choice.is_map()) fill(*there, choice);
    }
  }
}

/// Whatever has not the shape it should have is left for the reader to refuse.
void fill_vehicles(Tree& document) {
  const Tree* defaults = document.find("defaults");
  Tree* vehicles = document.find("vehicles");
  if (defaults == nullptr || !defaults->is_map() || vehicles == nullptr || !vehicles->is_list()) return;
  if (vehicles->items.size() * defaults->size() > max_filled_nodes) {
    throw InputError(defaults->where.location(), "defaults", "too long for so many vehicles");
  }
  for (Tree& vehicle : vehicles->items) {
    if (vehicle.is_null()) vehicle = {.kind = Tree::Kind::map, .where = vehicle.where};
    if (vehicle.is_map()) fill(vehicle, *defaults);
  }
}

}  // namespace

void apply(Tree& document, const Overrides& overrides, std::optional<std::uint64_t> seed) {
  std::vector<Override> of_vehicles;
  for (const auto& [path, value] : overrides) {
    Override override{path, value};
    if (override.is_of_a_vehicle()) {
      of_vehicles.push_back(std::move(override));
    } else {
      override.apply(document);
    }
  }
  write_out_fleet(document, seed);
  fill_vehicles(document);

  // a vehicle that was replaced as a whole takes what it does not say from the defaults as well
  for (const Override& override : of_vehicles) override.apply(document);
  if (!of_vehicles.empty()) fill_vehicles(document);
}

}  // namespace fairway::yaml
