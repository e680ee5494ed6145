// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/explain/drawn_section.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fairway/view/explain/headline.hpp"

namespace fairway {
namespace {

/// Half-spaces shown one by one; whoever decides among hundreds of neighbours has as many.
constexpr std::size_t most_half_spaces = 24;

std::string velocity_group_words(const StrokeFacts& facts, const Vec3& commanded) {
  const Vec3& last = facts.strokes.back()->points[0];
  if (facts.count > 1) return fmt::format("{} velocities", facts.count);
  return fmt::format("[{:.3f}, {:.3f}, {:.3f}] m/s NED, {:.3g} m/s from the commanded one", last.x(),
                     last.y(), last.z(), (last - commanded).norm());
}

std::string group_words(const StrokeFacts& facts, const Vec3& commanded) {
  switch (facts.kind) {
    case Stroke::Kind::velocity:
      return velocity_group_words(facts, commanded);
    case Stroke::Kind::half_space:
      return fmt::format("{} without the preferred velocity, {} active at the commanded one, {} without it",
                         facts.forbids_preferred, facts.active, facts.forbids_commanded);
    case Stroke::Kind::region:
      return fmt::format("{} with the preferred velocity inside, {} with the commanded one",
                         facts.forbids_preferred, facts.forbids_commanded);
    case Stroke::Kind::path:
      return fmt::format("{} points, {:.2f} m long", facts.points, facts.length);
    case Stroke::Kind::tree:
      return fmt::format("{} edges, {:.2f} m long in all", facts.points / 2, facts.length);
    case Stroke::Kind::sphere:
      return fmt::format("radius {:.2f} m{}", facts.strokes.front()->size,
                         facts.count > 1 ? ", of the first" : "");
    case Stroke::Kind::image:
      return fmt::format("{0} x {0} pixels over velocities up to {1:.2f} m/s", facts.strokes.front()->side,
                         facts.strokes.front()->size);
  }
  return {};
}

std::string verdict_on(double preferred, double commanded) {
  if (commanded < -on_plane_mps) return "not kept";
  if (std::abs(commanded) <= on_plane_mps) return "active";
  return preferred < -on_plane_mps ? "in the way" : "slack";
}

/// The half-spaces of all meanings, tightest for the preferred velocity first.
std::vector<const Stroke*> half_spaces_of(std::span<const StrokeFacts> drawn, const Vec3& preferred) {
  std::vector<const Stroke*> all;
  for (const StrokeFacts& facts : drawn) {
    if (facts.kind == Stroke::Kind::half_space)
      all.insert(all.end(), facts.strokes.begin(), facts.strokes.end());
  }
  std::ranges::stable_sort(all, {}, [&](const Stroke* stroke) { return margin_of(*stroke, preferred); });
  return all;
}

/// Whether what the method chose last is not what is carried out.
bool was_changed(std::span<const StrokeFacts> drawn, const Vec3& commanded) {
  return std::ranges::any_of(drawn, [&](const StrokeFacts& facts) {
    return facts.kind == Stroke::Kind::velocity && facts.meaning == "chosen" &&
           (facts.strokes.back()->points[0] - commanded).norm() > on_plane_mps;
  });
}

ExplanationSection half_spaces_section(const Scenario& scenario,
                                       const std::vector<const Stroke*>& half_spaces, const Vec3& preferred,
                                       const Vec3& commanded) {
  ExplanationSection section{
      "Half-spaces of allowed velocities",
      {"How far inside each the velocities are; negative is outside. In the way: the preferred "
       "velocity is outside. Active: the commanded velocity is on its plane."},
      {}};
  const std::size_t shown = std::min(most_half_spaces, half_spaces.size());
  if (shown < half_spaces.size()) {
    section.lines.push_back(
        fmt::format("{} more, with larger margins, are left out.", half_spaces.size() - shown));
  }
  section.table.columns = {"half-space", "preferred_mps", "commanded_mps", "verdict"};
  for (std::size_t i = 0; i < shown; ++i) {
    const double at_preferred = margin_of(*half_spaces[i], preferred);
    const double at_commanded = margin_of(*half_spaces[i], commanded);
    section.table.rows.push_back({named_meaning(scenario, half_spaces[i]->meaning), at_preferred,
                                  at_commanded, verdict_on(at_preferred, at_commanded)});
  }
  return section;
}

}  // namespace

std::vector<ExplanationSection> drawn_sections(const Scenario& scenario, std::span<const StrokeFacts> drawn,
                                               const Vec3& preferred, const Vec3& commanded) {
  ExplanationSection section{"What it drew", {}, {}};
  if (drawn.empty()) {
    section.lines.emplace_back("Nothing: it had nothing to weigh, or the method draws nothing.");
    return {section};
  }
  if (was_changed(drawn, commanded)) {
    section.lines.emplace_back(
        "The command is not the velocity chosen: limits, or what is around the method, changed it.");
  }
  section.table.columns = {"drawn", "meaning", "count", "what"};
  for (const StrokeFacts& facts : drawn) {
    section.table.rows.push_back({enum_name(facts.kind), named_meaning(scenario, facts.meaning),
                                  static_cast<double>(facts.count), group_words(facts, commanded)});
  }
  std::vector<ExplanationSection> sections{std::move(section)};
  const std::vector<const Stroke*> half_spaces = half_spaces_of(drawn, preferred);
  if (!half_spaces.empty())
    sections.push_back(half_spaces_section(scenario, half_spaces, preferred, commanded));
  return sections;
}

}  // namespace fairway
