// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/catalog.hpp"

#include <algorithm>
#include <ranges>

namespace fairway {
namespace {

/// The wrapper by which a vehicle that must turn follows any method.
constexpr std::string_view follower = "trackable";

}  // namespace

std::vector<std::string_view> layer_names(std::string_view name) {
  std::vector<std::string_view> layers;
  for (std::size_t from = 0;;) {
    const std::size_t plus = name.find('+', from);
    layers.push_back(name.substr(from, plus == std::string_view::npos ? plus : plus - from));
    if (plus == std::string_view::npos) return layers;
    from = plus + 1;
  }
}

Catalog& Catalog::add(Entry entry) {
  refuse_unless_free(entry.info.name);
  entries_.push_back(std::move(entry));
  return *this;
}

Catalog& Catalog::alias(std::string_view name, std::string_view target) {
  refuse_unless_free(name);
  aliases_.emplace_back(name, find(target).info.name);
  return *this;
}

void Catalog::refuse_unless_free(std::string_view name) const {
  if (has(name))
    throw InputError("the algorithm \"" + std::string(name) + "\" is there already: choose another name");
  if (name.empty() || name.find('+') != std::string_view::npos)
    throw InputError("an algorithm cannot be called \"" + std::string(name) +
                     "\": a '+' stands between layers, and each has a name");
}

bool Catalog::has(std::string_view name) const {
  return std::ranges::any_of(entries_, [&](const Entry& entry) { return entry.info.name == name; }) ||
         std::ranges::any_of(aliases_, [&](const auto& alias) { return alias.first == name; });
}

const Catalog::Entry& Catalog::find(std::string_view name) const {
  const auto alias =
      std::ranges::find(aliases_, name, [](const auto& a) -> std::string_view { return a.first; });
  const std::string_view own_name = alias != aliases_.end() ? alias->second : name;
  std::vector<std::string_view> known;
  for (const Entry& entry : entries_) {
    if (entry.info.name == own_name) return entry;
    known.push_back(entry.info.name);
  }
  throw InputError("unknown algorithm \"" + std::string(name) + "\"" + suggestion(name, known));
}

std::vector<const Catalog::Entry*> Catalog::layers(std::string_view name) const {
  std::vector<const Entry*> found;
  for (const std::string_view layer : layer_names(name)) {
    const Entry& entry = find(layer);
    if (!found.empty() && !entry.wraps) {
      throw InputError("algorithm \"" + std::string(entry.info.name) +
                       "\" cannot stand behind a '+': it wraps nothing");
    }
    found.push_back(&entry);
  }
  return found;
}

std::vector<ParamInfo> Catalog::params(std::string_view name) const {
  std::vector<ParamInfo> all;
  for (const Entry* layer : layers(name)) {
    for (const ParamInfo& param : layer->params) {
      if (std::ranges::none_of(all, [&](const ParamInfo& p) { return p.name == param.name; }))
        all.push_back(param);
    }
  }
  return all;
}

bool Catalog::ignores(std::string_view name, bool AlgorithmInfo::*what) const {
  return std::ranges::all_of(layers(name), [&](const Entry* layer) { return layer->info.*what; });
}

bool Catalog::needs(std::string_view name, bool AlgorithmInfo::*what) const {
  return std::ranges::any_of(layers(name), [&](const Entry* layer) { return layer->info.*what; });
}

std::vector<std::string_view> Catalog::needs_of(std::string_view name) const {
  std::vector<std::string_view> words;
  for (const Need& need : all_needs) {
    const bool is_sway = need.member == &AlgorithmInfo::needs_sway;
    if (needs(name, need.member) && !(is_sway && needs(name, &AlgorithmInfo::follows)))
      words.push_back(need.word);
  }
  return words;
}

bool Catalog::avoids_nobody(std::string_view name) const {
  return ignores(name, &AlgorithmInfo::ignores_obstacles) && ignores(name, &AlgorithmInfo::ignores_movers);
}

std::string Catalog::guided(std::string_view name) const {
  constexpr std::string_view wrapper = "way_round";
  const bool has_chosen =
      std::ranges::any_of(layers(name), [](const Entry* layer) { return layer->info.name == follower; });
  if (!has(wrapper) || has_chosen || avoids_nobody(name) || needs(name, &AlgorithmInfo::finds_way))
    return std::string(name);
  return std::string(name) + "+" + std::string(wrapper);
}

std::string Catalog::tracked(std::string_view name) const {
  const std::vector<const Entry*> stack = layers(name);
  if (!has(follower) || avoids_nobody(name) || needs(name, &AlgorithmInfo::follows)) return std::string(name);
  const auto last = std::ranges::find_if(stack | std::views::reverse,
                                         [](const Entry* layer) { return !layer->info.shows_only; });
  std::vector<std::string_view> names = layer_names(name);
  names.insert(names.begin() + (stack.rend() - last), follower);
  std::string all;
  for (const std::string_view layer : names) all += (all.empty() ? "" : "+") + std::string(layer);
  return all;
}

Avoider Catalog::make(std::string_view name, const ParamValues& values, Rng rng) const {
  const std::vector<ParamInfo> accepted = params(name);
  std::vector<std::string_view> known;
  for (const ParamInfo& param : accepted) known.push_back(param.name);
  for (const auto& [param, value] : values) {
    if (std::ranges::find(known, list_of_param(param)) == known.end()) {
      throw InputError({}, param, "unknown parameter of " + std::string(name) + suggestion(param, known));
    }
  }

  const std::vector<const Entry*> stack = layers(name);
  Avoider avoider = stack.front()->make(values, rng);
  for (std::size_t i = 1; i < stack.size(); ++i) {
    avoider = stack[i]->make_around(std::move(avoider), values, rng.stream("wrapper", i));
  }
  return avoider;
}

}  // namespace fairway
