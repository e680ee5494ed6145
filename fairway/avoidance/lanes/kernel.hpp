// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace fairway::trackable {
struct Fan;
}
namespace fairway::velocity_obstacle {
struct Discs;
struct Tried;
}  // namespace fairway::velocity_obstacle

/// ORCA in space in the lanes of a processor's registers: the half-spaces of
/// several neighbours at once, or the decisions of several vehicles. Whatever
/// lane a number is in, it comes to the bits that it comes to alone.
///
/// What is asked and answered are columns of as many numbers as there are
/// lanes, one for each neighbour or vehicle. SI units, NED.
namespace fairway::lanes {

inline constexpr std::size_t most_lanes = 8;
inline constexpr std::size_t most_in_lanes = 64;  ///< neighbours of one vehicle that `decide` has room for

/// The columns that tell of a vehicle or of a neighbour.
enum Column : std::size_t {
  position = 0,  ///< and the two after it [m]
  velocity = 3,  ///< and the two after it [m/s]
  radius = 6,    ///< [m]; below zero: there is no such neighbour
  share = 7,     ///< of a neighbour: our share of avoiding it, with the sign of the
                 ///< way to part, north or south
  speed = 7,     ///< of a vehicle: its limit [m/s]
  columns = 8,
};

/// Several vehicles that decide at once.
struct Crowd {
  double time_horizon{}, period{};                                  ///< [s]
  std::size_t neighbours{};                                         ///< of the vehicle that has most
  alignas(64) double own[columns * most_lanes];                     ///< `columns` columns
  alignas(64) double preferred[3 * most_lanes];                     ///< three columns [m/s]
  alignas(64) double others[most_in_lanes * columns * most_lanes];  ///< `columns` for each neighbour
};

/// Velocity programs side by side.
struct Programs {
  /// The offset of a half-space without a normal that forbids nothing.
  static constexpr double nothing = -std::numeric_limits<double>::infinity();

  std::size_t half_spaces{};  ///< at most `most_in_lanes`; of a program with fewer, some forbid nothing
  std::size_t stride{};       ///< from column to column
  const double* allowed{};    ///< four columns for each half-space: normal and offset [m/s]
  const double* preferred{};  ///< three columns [m/s]
  double max_speed{};         ///< [m/s]
};

/// Points that are near: two columns with room for `most_lanes` more than there can be.
struct Found {
  double* distances2;  ///< [m2]
  double* numbers;     ///< whole
};

inline constexpr std::size_t most_found = 64;  ///< that can be put in order

/// What is compiled for one kind of registers.
struct Kernel {
  const char* name;   ///< "AVX2"
  std::size_t lanes;  ///< a power of two, at most `most_lanes`

  /// The half-spaces that `lanes` neighbours (`columns` columns) leave a
  /// vehicle (`columns` numbers): the columns of their normals and of their
  /// offsets [m/s]; `everything()` where there is no neighbour.
  void (*half_spaces)(double time_horizon, double period, const double* own, const double* others,
                      double* answer);

  /// The velocities that `lanes` vehicles choose, in three columns, and in a
  /// fourth by how much they violate the worst half-space [m/s], zero if none.
  void (*decide)(const Crowd& crowd, double* answer);

  /// The velocities that `lanes` programs come to, as `nearest_velocity` does, in three columns.
  void (*choose)(const Programs& programs, double* answer);

  /// Of the points `begin` to `end` - 1 of four columns, place and number, those within the distance whose
  /// square is `reach2` [m2] from `place`: adds them to `found`, which has `count`, in their order, and
  /// returns how many it has then. The columns are readable `most_lanes` numbers beyond `end`.
  std::size_t (*within)(const double* const* columns, std::size_t begin, std::size_t end, const double* place,
                        double reach2, const Found& found, std::size_t count);

  /// Writes their numbers nearest first; of equal distances what was found first. At most `most_found`.
  void (*order)(const Found& found, std::size_t count, std::uint32_t* ordered);

  /// Rolls out `lanes` plans of a vehicle that must turn (trackable/fan.hpp).
  void (*roll)(trackable::Fan& fan);

  /// Makes the velocity obstacles of discs (velocity_obstacle/cone.hpp).
  void (*cones)(velocity_obstacle::Discs& discs);

  /// Of `lanes` velocities those that are in no velocity obstacle (velocity_obstacle/cone.hpp): a bit for
  /// each.
  unsigned (*outside)(const velocity_obstacle::Tried& tried);
};

/// Those that this processor can run, the widest last: two lanes always, four
/// with AVX2, eight with AVX-512.
std::span<const Kernel* const> kernels() noexcept;

/// The narrowest with so many lanes, or else the widest.
const Kernel& kernel_for(std::size_t count) noexcept;

}  // namespace fairway::lanes
