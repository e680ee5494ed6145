// SPDX-License-Identifier: Apache-2.0
#include "fairway/scenario/fleet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "fairway/core/cell_index.hpp"
#include "fairway/core/math.hpp"
#include "fairway/core/text.hpp"
#include "fairway/scenario/tagged.hpp"

namespace fairway::yaml {
namespace {

/// Where the vehicles of a fleet are [m, NED].
struct Places {
  enum class Kind { lattice, sphere, box, draw } kind{};
  Vec3 centre = Vec3::Zero();
  double spacing{};
  double radius{};
  Vec3 size = Vec3::Zero();
};

struct FleetSpec {
  std::int32_t count{};
  Places places;
  bool shuffled{false};  ///< who goes to whose place
  double speed{0.5};
  double arrival{1.0};
};

const Kinds<Places>& place_kinds() {
  const auto centre =
      key("centre_m", &Places::centre, vector(anywhere), "Its middle [n, e, d]. Default [0, 0, 0].");
  const auto spacing =
      key("spacing_m", &Places::spacing, number(above_to(0.0, 1e6)), "From each to the next.", Needed::yes);
  const auto size = key("size_m", &Places::size, vector(from_to(0.0, 1e7)),
                        "Along n, e and d; 0 along d for vessels.", Needed::yes);
  static const Kinds<Places> table{
      {"lattice", "A cube of cubes, its last layer perhaps in part.", {spacing, centre}, {}},
      {"sphere",
       "Evenly on a sphere.",
       {key("radius_m", &Places::radius, number(above_to(0.0, 1e6)), "Of that sphere.", Needed::yes), centre},
       {}},
      {"box", "Evenly in a box.", {size, centre}, {}},
      {"draw",
       "Anywhere in a box, by the seed.",
       {size, key("spacing_m", &Places::spacing, number(from_to(0.0, 1e6)), "Nobody nearer. Default 0."),
        centre},
       {}}};
  return table;
}

Form<Places> places() {
  return {
      .read = [](const Value& value) { return read_tagged(value, place_kinds()); },
      .write = [](const Places& given) -> std::optional<Tree> { return write_tagged(given, place_kinds()); },
      .schema = Tree::map({{"oneOf", Tree::list(tagged_schemas(place_kinds()))}})};
}

Form<bool> goals() {
  return {.read =
              [](const Value& value) {
                const std::string word = value.tree().is_scalar() ? value.tree().text : "";
                if (word != "opposite" && word != "shuffled") value.expected("opposite or shuffled");
                return word == "shuffled";
              },
          .write = [](const bool& shuffled) -> std::optional<Tree> {
            return Tree::quote(shuffled ? "shuffled" : "opposite");
          },
          .schema = Tree::map({{"enum", Tree::list({Tree::quote("opposite"), Tree::quote("shuffled")})}})};
}

const Block<FleetSpec>& fleet_block() {
  static const Block<FleetSpec> block{
      key("count", &FleetSpec::count, integer(1, max_vehicles), "How many.", Needed::yes),
      key("places", &FleetSpec::places, places(), "Where they start.", Needed::yes),
      key("goals", &FleetSpec::shuffled, goals(),
          "Where they go: opposite, each to the place opposite the middle, or shuffled, each to the start of "
          "one that is drawn. Default opposite."),
      key("speed_mps", &FleetSpec::speed, number(above_to(0.0, 100.0)), "On the way. Default 0.5."),
      key("arrival_m", &FleetSpec::arrival, number(from_to(0.0, 1e6)),
          "They have arrived this near to it. Default 1."),
  };
  return block;
}

FleetSpec fleet_of(const Value& value) {
  FleetSpec spec;
  read_block(value, fleet_block(), spec);
  return spec;
}

/// How many cells there are along n, e and d.
using Cells = std::array<std::size_t, 3>;

/// Where a cell is, from the middle of all, in cells.
Vec3 cell(std::size_t i, const Cells& n) {
  const auto from_middle = [](std::size_t place, std::size_t of) {
    return static_cast<double>(place) - 0.5 * static_cast<double>(of - 1);
  };
  return {from_middle(i % n[0], n[0]), from_middle(i / n[0] % n[1], n[1]),
          from_middle(i / (n[0] * n[1]), n[2])};
}

std::vector<Vec3> lattice(std::size_t count, double spacing) {
  std::size_t side = 1;
  while (side * side * side < count) ++side;
  const Cells n{side, std::min(side, (count + side - 1) / side), (count + side * side - 1) / (side * side)};
  std::vector<Vec3> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back(spacing * cell(i, n));
  return all;
}

/// By the golden angle, each for the same share of the surface.
std::vector<Vec3> sphere(std::size_t count, double radius) {
  std::vector<Vec3> all;
  const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (std::size_t i = 0; i < count; ++i) {
    const double down = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(count);
    const double angle = golden_angle * static_cast<double>(i);
    const double across = std::sqrt(1.0 - down * down);
    all.push_back(radius * Vec3{across * math::cos(angle), across * math::sin(angle), down});
  }
  return all;
}

/// On the widest lattice that the box has room for. Where that has more cells than are needed, those that are
/// left empty are spread over all of it, and one for one they face each other across the middle.
std::vector<Vec3> box(std::size_t count, const Vec3& size) {
  Cells n{1, 1, 1};
  for (double spacing = size.maxCoeff(); spacing > 0.0 && n[0] * n[1] * n[2] < count; spacing *= 0.995) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      n[axis] = 1 + static_cast<std::size_t>(size[static_cast<Eigen::Index>(axis)] / spacing * (1.0 + 1e-12));
  }
  Vec3 spacings;
  for (std::size_t axis = 0; axis < 3; ++axis)
    spacings[static_cast<Eigen::Index>(axis)] =
        size[static_cast<Eigen::Index>(axis)] / static_cast<double>(std::max<std::size_t>(n[axis] - 1, 1));
  const std::size_t of = n[0] * n[1] * n[2];
  std::vector<Vec3> all;
  for (std::size_t i = 0; i < count; ++i)
    all.push_back(cell((2 * i + 1) * of / (2 * count), n).cwiseProduct(spacings));
  return all;
}

/// Whoever is too near to one before it is drawn again, for so many rounds.
std::vector<Vec3> drawn(const Value& value, std::size_t count, const Places& given, Rng rng) {
  constexpr int rounds = 200;
  std::vector<Vec3> all(count);
  std::vector<std::size_t> again(count);
  std::iota(again.begin(), again.end(), std::size_t{0});
  CellIndex index;
  for (int round = 0; round < rounds && !again.empty(); ++round) {
    for (const std::size_t i : again) {
      for (double& x : all[i]) x = rng.uniform(-0.5, 0.5);
      all[i] = all[i].cwiseProduct(given.size);
    }
    again.clear();
    if (given.spacing == 0.0) continue;
    index.rebuild(count, given.spacing, [&](std::size_t i) { return all[i]; });
    for (std::size_t i = 0; i < count; ++i) {
      bool near_one_before = false;
      index.visit(all[i], given.spacing, [&](std::size_t j, double) { near_one_before |= j < i; });
      if (near_one_before) again.push_back(i);
    }
  }
  if (!again.empty()) {
    value.refuse(fmt::format("no room was found for {} vehicles {} m apart; {} are left over", count,
                             number_text(given.spacing), again.size()));
  }
  return all;
}

std::vector<Vec3> places_of(const Value& value, const FleetSpec& fleet) {
  const auto count = static_cast<std::size_t>(fleet.count);
  std::vector<Vec3> all;
  switch (fleet.places.kind) {
    case Places::Kind::lattice:
      all = lattice(count, fleet.places.spacing);
      break;
    case Places::Kind::sphere:
      all = sphere(count, fleet.places.radius);
      break;
    case Places::Kind::box:
      if (count > 1 && fleet.places.size.isZero(0.0)) value.refuse("a box without any size has one place");
      all = box(count, fleet.places.size);
      break;
    case Places::Kind::draw:
      all = drawn(value, count, fleet.places, value.reading().rng->stream("fleet_places"));
  }
  return all;
}

/// The place that each goes to, of those round the middle.
std::vector<Vec3> goals_of(const std::vector<Vec3>& starts, bool shuffled, Rng rng) {
  std::vector<Vec3> all = starts;
  if (!shuffled) {
    for (Vec3& goal : all) goal = -goal;
    return all;
  }
  for (std::size_t i = all.size(); i > 1; --i) std::swap(all[i - 1], all[rng.index(i)]);
  return all;
}

/// Throws where the sphere of one of the fleet overlaps another's.
void refuse_overlaps(const Value& value, const Scenario& scenario) {
  const std::vector<VehicleSpec>& all = scenario.vehicles;
  double largest = 0.0;
  for (const VehicleSpec& vehicle : all) largest = std::max(largest, vehicle.radius_m);
  CellIndex index;
  index.rebuild(all.size(), 2.0 * largest, [&](std::size_t i) { return all[i].position; });
  for (std::size_t i = all.size() - static_cast<std::size_t>(fleet_of(value).count); i < all.size(); ++i) {
    std::size_t with = all.size();
    index.visit(all[i].position, 2.0 * largest, [&](std::size_t j, double distance2) {
      const double apart = all[i].radius_m + all[j].radius_m;
      if (j != i && distance2 < apart * apart) with = std::min(with, j);
    });
    if (with == all.size()) continue;
    const VehicleSpec& one = all[std::min(i, with)];
    const VehicleSpec& other = all[std::max(i, with)];
    value.refuse(
        fmt::format("{} and {} start {} m apart, and their spheres of radius_m {} and {} overlap; "
                    "give them room, or write coincident_start: true",
                    one.name, other.name, number_text((one.position - other.position).norm()),
                    number_text(one.radius_m), number_text(other.radius_m)));
  }
}

}  // namespace

void write_out_fleet(Tree& document, std::optional<std::uint64_t> seed) {
  const Tree* written = document.find("fleet");
  if (written == nullptr) return;
  Reading reading{seed_of(document, seed)};
  const Value value{*written, "fleet", reading};
  const FleetSpec fleet = fleet_of(value);
  const std::vector<Vec3> starts = places_of(value, fleet);
  const std::vector<Vec3> goals = goals_of(starts, fleet.shuffled, reading.rng->stream("fleet_goals"));

  const Where where = written->where;
  const Tree* defaults = document.find("defaults");
  const bool has_mission = defaults != nullptr && defaults->find("mission") != nullptr;
  const Tree* usual_start = defaults != nullptr ? defaults->find("start") : nullptr;
  const bool has_heading = usual_start != nullptr && (usual_start->find("yaw_deg") != nullptr ||
                                                      usual_start->find("yaw_rad") != nullptr);

  Tree* vehicles = document.find("vehicles");
  if (vehicles == nullptr)
    vehicles = &document.set("vehicles", Tree{.kind = Tree::Kind::list, .where = where}, where);
  if (!vehicles->is_list()) return;  // for the reader to refuse
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const Vec3 way = goals[i] - starts[i];
    Tree start = Tree::map({{"position_m", vector_tree(fleet.places.centre + starts[i])}});
    if (!has_heading) start.set("yaw_rad", Tree::number(math::atan2(way.y(), way.x())));
    Tree vehicle = Tree::map({{"start", std::move(start)}});
    if (!has_mission) {
      const Tree transit = Tree::map({{"position_m", vector_tree(fleet.places.centre + goals[i])},
                                      {"speed_mps", Tree::number(fleet.speed)},
                                      {"arrival_m", Tree::number(fleet.arrival)}});
      vehicle.set("mission", Tree::list({Tree::map({{"transit", transit}})}));
    }
    vehicle.where = where;
    vehicles->items.push_back(std::move(vehicle));
  }
}

Key<Scenario> fleet() {
  return {.name = "fleet",
          .meaning = "Vehicles that are alike but for their places, after those listed.",
          .read =
              [](const Value& value, Scenario& scenario) {
                if (!scenario.coincident_start) refuse_overlaps(value, scenario);
              },
          .write = [](const Scenario&) -> std::optional<Tree> { return {}; },
          .schema = schema_of(fleet_block())};
}

}  // namespace fairway::yaml
