// SPDX-License-Identifier: Apache-2.0
// What the search sets out from: what rings go round, and how long a way may take.
#include <algorithm>

#include "fairway/avoidance/pledge/search.hpp"
#include "fairway/core/math.hpp"

namespace fairway::pledge {
namespace {

constexpr double longest_detour = 60.0;  // beyond waiting and going straight then [s]

/// First where the straight ways cross, in the mean; then the middle of where all are, to go round each other
/// there; then where each of them is, to go round it.
Vec2 centre_of(const std::array<Member, most_members>& members, const Members& participants,
               std::size_t attempt) {
  const std::size_t choice = attempt % Search::centres;
  if (choice >= 2) return members[choice - 2].anchor.head<2>();
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 0; i < most_members; ++i) {
    const Member& m = members[i];
    if (participants[i])
      sum += choice == 0 ? Vec2{0.5 * (m.anchor + m.destination).head<2>()} : Vec2{m.anchor.head<2>()};
  }
  return participants.any() ? Vec2{sum / static_cast<double>(participants.count())} : sum;
}

/// From its centre, on a level [m].
double extent_of(const Obstacle& obstacle) {
  if (obstacle.kind == Obstacle::Kind::sphere) return obstacle.radius;
  const Vec3 centre = centre_of(obstacle);
  if (obstacle.kind == Obstacle::Kind::segment) return horizontal_norm(obstacle.to - centre);
  double farthest = 0.0;
  for (const Vec3& vertex : obstacle.vertices)
    farthest = math::fmax(farthest, horizontal_norm(vertex - centre));
  return farthest;
}

}  // namespace

/// Of those who are asked, as if they went at once.
std::array<Reference, most_members> Search::straight_ways() const noexcept {
  std::array<Reference, most_members> straight{};
  for (std::size_t i = 0; i < most_members; ++i)
    if (asked_[i]) straight[i] = reference_of(members_[i], Plan{.epoch = at_zero}, Code{});
  return straight;
}

/// Beside those who are on their ways, and by the first attempt beside the others who are asked. If all need
/// long ways, they have them by the next.
void Search::find_limits(const Chart& chart) noexcept {
  latest_.fill(never);
  if (start_ == at_zero && (attempt_ > 0 || asked_.count() < 2)) return;
  const std::array<Reference, most_members> straight = straight_ways();
  const std::array<Reference, most_members>& before = start_ == at_zero ? straight : others_;
  double all_there = start_of(start_);
  for (const Reference& other : before)
    if (!other.empty()) all_there = math::fmax(all_there, other.end());
  for (const Passing& other : chart.passing()) all_there = math::fmax(all_there, other.way.end());
  for (std::size_t i = 0; i < most_members; ++i)
    if (asked_[i]) latest_[i] = all_there + longest_detour + straight[i].end();
}

/// The centre of this attempt; where something stands in straight ways also wider round that, and round what
/// stands in most ways, each attempt from another of them on.
void Search::find_hubs(const Chart& chart, const Vec2& datum) noexcept {
  hubs_[hub_count_++] = {centre_as_told(centre_of(members_, asked_, attempt_), datum), 0};
  struct Found {
    Hub hub;
    std::size_t hindered;  ///< whose straight ways it stands in
    std::size_t number;    ///< as found
  };
  const std::array<Reference, most_members> straight = straight_ways();
  std::array<Found, 16> found{};
  std::size_t count = 0;
  const auto find = [&](const Obstacle& obstacle) {
    std::size_t hindered = 0;
    double widest = 0.0;
    for (std::size_t i = 0; i < most_members; ++i) {
      const double off = berth(members_[i], tubes_);
      if (straight[i].empty() || keeps_off(straight[i], obstacle, off)) continue;
      ++hindered;
      widest = math::fmax(widest, off);
    }
    if (hindered == 0 || count == found.size()) return;
    const double radius = extent_of(obstacle) + widest;
    std::uint8_t scale = 0;
    while (scale + 1U < ring_scale.size() && ring_scale[scale] * ring_radius[ring_radius.size() - 2] < radius)
      ++scale;
    found[count] = {{centre_as_told(centre_of(obstacle).head<2>(), datum), scale}, hindered, count};
    ++count;
  };
  for (const std::span<const Obstacle> part : chart.parts()) std::ranges::for_each(part, find);
  std::ranges::sort(std::span{found}.first(count), [](const Found& a, const Found& b) {
    return a.hindered != b.hindered ? a.hindered > b.hindered : a.number < b.number;
  });
  if (count == 0) return;
  for (std::uint8_t scale = 1; scale < 3; ++scale) hubs_[hub_count_++] = {hubs_[0].centre, scale};
  const std::size_t room = most_hubs - hub_count_;
  for (std::size_t i = 0; i < std::min(count, room); ++i)
    hubs_[hub_count_++] = found[(i + attempt_ * room) % count].hub;
}

}  // namespace fairway::pledge
