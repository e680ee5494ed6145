// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "fairway/scenario/block.hpp"

/// The tables of the scenario format. Each is built once and never changes.
namespace fairway::yaml {

/// Everything a position may be: a mission on this Earth, whose origin is nearby [m].
inline constexpr Bounds anywhere = from_to(-1e7, 1e7);

/// The most that one file may ask for.
inline constexpr std::size_t max_vehicles = 100'000;
inline constexpr std::size_t max_vertices = 10'000;

/// What a run draws from: `given`, or as the document says. Throws InputError for one that it does not
/// accept.
std::uint64_t seed_of(const Tree& document, std::optional<std::uint64_t> given);

/// The document. `vehicles` and `missions` read what they need from the Reading.
const Block<Scenario>& scenario_block();

const Block<VehicleSpec>& vehicle_block();
Form<VehicleSpec> vehicle();

Form<ObstacleSpec> obstacle();

Form<WaterSpec> water();

/// A list of legs, named missions spliced in.
Form<std::vector<Leg>> mission();
/// Where each leg of it was written, by the places that its readers have accepted.
std::vector<Location> places_of_legs(const Value& mission);
/// Checks each named mission by itself, and that none leads back to itself.
void check_missions(const Value& missions);
Tree missions_schema();

Form<std::vector<Expectation>> expectations();

/// Throws unless the vehicles can start as they are: ids, places, obstacles. `vehicles` is the list.
void check_vehicles(const Value& vehicles, const Scenario& scenario);

}  // namespace fairway::yaml
