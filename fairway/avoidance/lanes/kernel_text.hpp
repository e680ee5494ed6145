// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "fairway/avoidance/lanes/kernel.hpp"
#include "fairway/avoidance/orca3d/least_change.hpp"
#include "fairway/core/lanes/pack.hpp"

/// What each kernel is compiled from, with the flags of its registers. So
/// nothing in here may be a function that a file with other flags has too: all
/// are templates of `Pack<N>`, and no two files have the same N.
namespace fairway::lanes {

/// A vehicle, or in each lane one.
template <std::size_t N>
struct Self {
  VecOf<Pack<N>> position, velocity;
  Pack<N> radius;
};

template <std::size_t N>
[[gnu::always_inline]] inline HalfSpaceOf<Pack<N>> half_space_of(const Self<N> &self, const double *other,
                                                                 double time_horizon, double period) {
  using Real = Pack<N>;
  const Real radius = Real::from(other + Column::radius * N);
  const Real share = Real::from(other + Column::share * N);
  const Real zero{0.0};
  const NeighbourOf<Real> neighbour{vector_at<N>(other + Column::position * N) - self.position,
                                    self.velocity - vector_at<N>(other + Column::velocity * N),
                                    self.radius + radius,
                                    {with_sign_of(Real{1.0}, share), zero, zero}};
  const HalfSpaceOf<Real> allowed =
      half_space(least_change(neighbour, time_horizon, period), self.velocity, magnitude(share));
  return select(radius >= 0.0, allowed, HalfSpaceOf<Real>::everything());
}

template <std::size_t N>
void half_spaces_in_lanes(double time_horizon, double period, const double *own, const double *others,
                          double *answer) {
  const auto same = [&](Column c) { return VecOf<Pack<N>>{own[c], own[c + 1], own[c + 2]}; };
  const Self<N> self{same(Column::position), same(Column::velocity), own[Column::radius]};
  const HalfSpaceOf<Pack<N>> allowed = half_space_of<N>(self, others, time_horizon, period);
  write_vector<N>(allowed.normal, answer);
  allowed.offset.to(answer + 3 * N);
}

template <std::size_t N>
void decide_in_lanes(const Crowd &crowd, double *answer) {
  using Real = Pack<N>;
  const Self<N> self{vector_at<N>(crowd.own + Column::position * N),
                     vector_at<N>(crowd.own + Column::velocity * N),
                     Real::from(crowd.own + Column::radius * N)};
  HalfSpaceOf<Real> half_spaces[most_in_lanes], room[most_in_lanes];
  for (std::size_t k = 0; k < crowd.neighbours; ++k)
    half_spaces[k] = half_space_of<N>(self, crowd.others + k * columns * N, crowd.time_horizon, crowd.period);

  const Real zero{0.0};
  VecOf<Real> v;
  const Real violation =
      nearest_velocity<Real>({half_spaces, crowd.neighbours}, vector_at<N>(crowd.preferred),
                             Real::from(crowd.own + Column::speed * N), zero <= zero, room, v);
  write_vector<N>(v, answer);
  violation.to(answer + 3 * N);
}

template <std::size_t N>
void choose_in_lanes(const Programs &programs, double *answer) {
  using Real = Pack<N>;
  const std::size_t stride = programs.stride;
  HalfSpaceOf<Real> half_spaces[most_in_lanes], room[most_in_lanes];
  for (std::size_t k = 0; k < programs.half_spaces; ++k) {
    const double *at = programs.allowed + k * 4 * stride;
    half_spaces[k] = {vector_at<N>(at, stride), Real::from(at + 3 * stride)};
  }
  const Real zero{0.0};
  VecOf<Real> v;
  nearest_velocity<Real>({half_spaces, programs.half_spaces}, vector_at<N>(programs.preferred, stride),
                         Real{programs.max_speed}, zero <= zero, room, v);
  write_vector<N>(v, answer);
}

template <std::size_t N>
std::size_t within_in_lanes(const double *const *columns, std::size_t begin, std::size_t end,
                            const double *place, double reach2, const Found &found, std::size_t count) {
  using Real = Pack<N>;
  const VecOf<Real> here{place[0], place[1], place[2]};
  for (std::size_t i = begin; i < end; i += N) {
    const VecOf<Real> there{Real::from(columns[0] + i), Real::from(columns[1] + i),
                            Real::from(columns[2] + i)};
    const VecOf<Real> way = there - here;
    const Real distance2 = dot(way, way);
    const PackMask<N> near = (distance2 <= reach2) & (Real::counting() < static_cast<double>(end - i));
    write_those_in(near, distance2, found.distances2 + count);
    write_those_in(near, Real::from(columns[3] + i), found.numbers + count);
    count += static_cast<std::size_t>(__builtin_popcount(bits_of(near)));
  }
  return count;
}

/// By counting of each how many come before it: the same work whatever the order is.
template <std::size_t N>
void order_in_lanes(const Found &found, std::size_t count, std::uint32_t *ordered) {
  using Real = Pack<N>;
  const std::size_t packs = (count + N - 1) / N;
  for (std::size_t i = count; i < packs * N; ++i)
    found.distances2[i] = std::numeric_limits<double>::infinity();
  std::uint64_t taken = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t before = 0;
    for (std::size_t g = 0; g < packs; ++g) {
      const PackMask<N> nearer = Real::from(found.distances2 + g * N) < found.distances2[i];
      before += static_cast<std::size_t>(__builtin_popcount(bits_of(nearer)));
    }
    while ((taken >> before & 1) != 0) ++before;  // as far away as one before
    taken |= std::uint64_t{1} << before;
    ordered[before] = static_cast<std::uint32_t>(found.numbers[i]);
  }
}

}  // namespace fairway::lanes
