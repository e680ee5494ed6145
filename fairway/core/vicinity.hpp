// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "fairway/core/cell_index.hpp"
#include "fairway/core/crew.hpp"
#include "fairway/core/math.hpp"
#include "fairway/core/vec.hpp"

namespace fairway {

/// How far a list reaches: as far as about `usual_count` others are on average, but not less than `least`
/// and not more than `most` [m]. What of that is added as a margin decides how often all are sorted again,
/// and how long lists are.
struct VicinityLists {
  double least{};
  double most{std::numeric_limits<double>::infinity()};
  double usual_count{8.0};
  double margin_ratio{0.1};
};

/// Who is near, of points that move a little at a time (Verlet, Physical Review 159, 1967: lists of
/// neighbours with a margin). Each point has a list of who was within some distance when all were last sorted
/// by cells, nearest first; it holds for as long as nobody has gone half of its margin, and then all are
/// sorted again. Whoever looks less far than the list reaches looks at its beginning alone. It
/// finds exactly what comparing with every point finds: cells and lists decide about the cost alone. A value;
/// looking round changes nothing.
class Vicinity {
 public:
  using Lists = VicinityLists;

  explicit Vicinity(const Lists& lists = {}) : lists_{lists} {}

  /// Takes the points `point_of(i)` [m], i from 0 to `count` - 1, in place of those before; one that is not
  /// finite is nowhere. A `crew` shares the work, and calls `point_of` from all its threads. Allocates only
  /// where there are more points than ever before. O(count).
  template <class PointOf>
  void update(std::size_t count, const PointOf& point_of, Crew* crew = nullptr) {
    const bool is_new = count != now_.size();
    now_.resize(count);
    if (is_new) room_ = 0;
    if (count <= handful) {
      for (std::size_t i = 0; i < count; ++i) now_[i] = point_of(i);
      return;
    }
    const bool was_sorted = !is_new && !then_.empty();
    then_.resize(count);
    sheets_.resize(std::max(sheets_.size(), crew != nullptr ? crew->hands() : 1));
    for (Sheet& sheet : sheets_) sheet.way2 = was_sorted ? 0.0 : std::numeric_limits<double>::infinity();
    const double enough = 0.25 * margin_ * margin_;
    for_each(crew, count, [&](std::size_t i, std::size_t hand) {
      Sheet& sheet = sheets_[hand];
      now_[i] = point_of(i);
      const double d2 = (now_[i] - then_[i]).squaredNorm();
      if (d2 <= enough) {
        sheet.way2 = math::fmax(sheet.way2, d2);
      } else if (is_finite(now_[i])) {  // too far, or it was nowhere
        sheet.way2 = std::numeric_limits<double>::infinity();
      }
    });
    double way2 = std::ranges::max_element(sheets_, {}, &Sheet::way2)->way2;
    if (!(way2 <= enough)) {
      sort(crew);
      way2 = 0.0;
    }
    moved_ = longer(std::sqrt(way2));
  }

  /// Calls `visit(index, distance2)` for each point whose squared distance from `place` [m2] is at most that
  /// of `reach` [m], in no certain order; whoever is at `place` itself is among them.
  template <class Visit>
  void visit(const Vec3& place, double reach, const Visit& visit) const {
    const double reach2 = reach * reach;
    const auto compare = [&](std::size_t i) {
      const double distance2 = (now_[i] - place).squaredNorm();
      if (distance2 <= reach2) visit(i, distance2);
    };
    if (now_.size() <= handful) {
      for (std::size_t i = 0; i < now_.size(); ++i) compare(i);
    } else {
      index_.visit(place, longer(reach + moved_), [&](std::size_t i, double) { compare(i); });
    }
  }

  /// The same of all but point `index`, which looks round from `place`, usually its own.
  template <class Visit>
  void visit_others(std::size_t index, const Vec3& place, double reach, const Visit& visit) const {
    if (!(reach <= sure_reach(index, place))) {
      this->visit(place, reach, [&](std::size_t i, double distance2) {
        if (i != index) visit(i, distance2);
      });
      return;
    }
    const double reach2 = reach * reach;
    const double then_within = longer(reach + moved_ + gone(index, place));
    for (std::uint32_t k = spans_[index].begin; k < spans_[index].end; ++k) {
      const Listed& other = listed_[k];
      if (other.distance > then_within) return;
      const double distance2 = (now_[other.index] - place).squaredNorm();
      if (distance2 <= reach2) visit(std::size_t{other.index}, distance2);
    }
  }

  /// Where point `index` is [m].
  const Vec3& place(std::size_t index) const { return now_[index]; }
  /// How many there are, nowhere or not.
  std::size_t size() const { return now_.size(); }

  /// Everyone within this distance of `place` [m] is on the list of point `index`; negative where no list
  /// serves.
  double sure_reach(std::size_t index, const Vec3& place) const {
    if (!has_lists_ || now_.size() <= handful) return -1.0;
    const double reach = list_reach_ - moved_ - gone(index, place);
    return reach >= 0.0 ? reach : -1.0;
  }

  /// A distance within which there are at least `count` others than point `index`, not much larger than it
  /// has to be; infinite if there are fewer.
  double reach_of(std::size_t count, std::size_t index, const Vec3& place) const {
    const auto found_within = [&](double reach) {
      std::size_t found = 0;
      visit_others(index, place, reach, [&](std::size_t, double) { ++found; });
      return found;
    };
    const double sure = sure_reach(index, place);
    if (sure > 0.0 && found_within(sure) >= count) return sure;
    if (now_.size() <= handful) return std::numeric_limits<double>::infinity();
    const double reach =
        index_.reach_of(count, place, [&](std::size_t i) { return i != index && is_finite(now_[i]); });
    return longer(reach + moved_);
  }

 private:
  static constexpr std::size_t handful = 24;     // so few are compared faster than lists are kept
  static constexpr double most_on_lists = 32.0;  // on average
  static constexpr std::size_t most_on_one = 1024;

  /// Whoever was near when all were last sorted.
  struct Listed {
    float distance;  ///< then, or a little less [m]
    std::uint32_t index;
  };

  /// Of `listed_`.
  struct Span {
    std::uint32_t begin;
    std::uint32_t end;
  };

  /// What one hand has to work with.
  struct Sheet {
    double way2{};  ///< the farthest that anyone has gone whom it has looked at [m2]
    std::vector<Listed> listed;
  };

  /// From where it was when all were last sorted [m].
  double gone(std::size_t index, const Vec3& place) const { return longer((place - then_[index]).norm()); }

  /// More than `distance`, by more than all that is rounded on the way.
  static double longer(double distance) { return distance * (1.0 + 1e-9); }

  static double cube_root(double x) { return math::exp(math::log(x) / 3.0); }

  /// How many are meant to be on one, the margin included.
  double usual_on_a_list() const {
    const double grown = 1.0 + lists_.margin_ratio;
    return lists_.usual_count * grown * grown * grown;
  }

  void sort(Crew* crew) {
    index_.rebuild(now_.size(), lists_.least > 0.0 ? lists_.least : lists_.most,
                   [&](std::size_t i) { return now_[i]; });
    if (usual_reach_ == 0.0) {
      const double in_sphere = 4.19 * index_.crowd();  // of the radius of a cell's edge, where it is crowded
      usual_reach_ = index_.edge() * cube_root(lists_.usual_count / in_sphere);
    }
    moved_ = 0.0;
    bool enough = false;
    while (!enough) enough = list_enough(crew);
    if (room_ == 0) {
      room_ = std::min(of_all(most_on_lists),
                       std::max(of_all(1.25 * usual_on_a_list()), listed_count_ + listed_count_ / 4));
      listed_.resize(room_);
      listed_.shrink_to_fit();
    }
  }

  std::size_t of_all(double on_a_list) const {
    return static_cast<std::size_t>(on_a_list * static_cast<double>(now_.size()));
  }

  /// Lists that reach as far as is usual, which from then on is as far as as many as are meant to be on them
  /// are. False where they were much too short for that.
  bool list_enough(Crew* crew) {
    constexpr double much = 1.4;
    const double farthest = std::max(lists_.least, std::min(lists_.most, 2.0 * index_.extent()));
    const double reach = std::clamp(usual_reach_, lists_.least, farthest);
    margin_ = lists_.margin_ratio * reach;
    list_reach_ = reach + margin_;
    list(crew);
    const double found = math::fmax(1.0, static_cast<double>(listed_count_));
    const double wanted = usual_on_a_list() * static_cast<double>(now_.size());
    const double longer_by = std::clamp(cube_root(wanted / found), 1.0 / much, much);
    usual_reach_ = longer_by * reach;
    return longer_by < much || reach == farthest;
  }

  /// Everyone's list, or none at all where there would be too much on them.
  void list(Crew* crew) {
    if (room_ == 0) listed_.resize(of_all(most_on_lists));
    spans_.resize(now_.size());
    for (Sheet& sheet : sheets_) sheet.listed.reserve(std::min(now_.size(), most_on_one));
    listed_count_ = 0;
    for_each(crew, now_.size(), [&](std::size_t i, std::size_t hand) { list(i, sheets_[hand].listed); });
    has_lists_ = listed_count_ <= listed_.size();
    listed_count_ = std::min(listed_count_, listed_.size());
  }

  /// Makes the list of point `i` on a sheet, nearest first, and copies it to where there is room.
  void list(std::size_t i, std::vector<Listed>& sheet) {
    then_[i] = now_[i];
    sheet.clear();
    std::size_t count = 0;
    index_.visit(then_[i], longer(list_reach_), [&](std::size_t j, double distance2) {
      if (j == i || ++count > most_on_one) return;
      const double a_little_less = (1.0 - 1e-6) * std::sqrt(distance2);
      sheet.push_back({static_cast<float>(a_little_less), static_cast<std::uint32_t>(j)});
    });
    if (count > most_on_one) count = listed_.size() + 1;
    const std::size_t begin = std::atomic_ref{listed_count_}.fetch_add(count);
    if (begin + count > listed_.size()) return;
    std::ranges::sort(sheet, {}, &Listed::distance);
    std::ranges::copy(sheet, listed_.begin() + static_cast<std::ptrdiff_t>(begin));
    spans_[i] = {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(begin + count)};
  }

  Lists lists_;
  CellIndex index_;         // of where they were when they were last sorted
  std::vector<Vec3> then_;  // likewise
  std::vector<Vec3> now_;
  double moved_{};                        // since then, nobody farther [m]
  double margin_{};                       // [m]
  double list_reach_{};                   // with it [m]
  double usual_reach_{};                  // of the lists to come, without it [m]; 0 before the first
  std::size_t room_{};                    // of all lists, for more than are on the first ones; 0 before these
  std::vector<Listed> listed_;            // all lists, in the order in which they were made
  std::size_t listed_count_{};            // of what there is room for in `listed_`
  std::vector<Span> spans_;               // of each point's list there
  bool has_lists_{};                      // they hold; there may be too much for them
  std::vector<OfOneHand<Sheet>> sheets_;  // one for each hand
};

}  // namespace fairway
