// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/search.hpp"

#include <algorithm>

#include "fairway/core/math.hpp"

namespace fairway::pledge {
namespace {

constexpr int rings = static_cast<int>(ring_radius.size());
constexpr int carousels = 2 * rings * rings;  // either way round, a ring for each class
constexpr int carousel_cost = 4;              // of one carousel, in codes
constexpr std::size_t widths = 2;             // of its rings, where headway is wanted
constexpr int pair_cost = 1;                  // of the headway of one to another, in codes
constexpr double worth = 0.5;                 // of a second of headway, in the mean time [s]
constexpr int codes = 256;
constexpr double least_gain = 0.05;  // for which a member takes another code [s]
constexpr double rounding = 1e-6;    // of times [s]

bool dives(const Member& member) { return member.destination.z() > member.anchor.z(); }

}  // namespace

Search::Search(const std::array<Member, most_members>& members, const Members& participants,
               const std::array<Reference, most_members>& others, const Terms& terms, std::size_t attempt,
               const Chart& chart, const Headway& wanted, const Epoch& start) noexcept
    : members_{members},
      asked_{participants},
      company_{participants},
      others_{others},
      tubes_{terms.tubes},
      attempt_{attempt},
      wanted_{wanted},
      start_{start} {
  find_limits(chart);
  find_hubs(chart, terms.datum);
  begin_hub();
}

void Search::begin_hub() noexcept {
  participants_ = company_;
  ways_ = others_;
  stay(asked_ & ~company_);
  of_hub_ = {};
  begin();
}

void Search::begin() noexcept {
  stage_ = participants_.any() ? Stage::carousel : Stage::done;
  number_ = 0;
}

/// Another where not all can go, and another company where nobody can.
void Search::end_hub() noexcept {
  stage_ = Stage::done;
  if (!found_all() && ++hub_ < hub_count_) return begin_hub();
  if (found() || !next_chain()) return;
  hub_ = 0;
  begin_hub();
}

bool Search::next_chain() noexcept {
  while (chain_ < most_members) {
    const std::size_t head = numbered(chain_++);
    company_ = chain_from(head);
    if (asked_[head] && company_ != asked_) return true;
  }
  return false;
}

/// Who has to go so that this member can: whoever lies at its destination, and so on.
Members Search::chain_from(std::size_t head) const noexcept {
  Members chain, before;
  chain.set(head);
  while (chain != before) {
    before = chain;
    for (std::size_t i = 0; i < most_members; ++i) {
      for (std::size_t j = 0; before[i] && j < most_members; ++j) {
        const double off = (members_[i].destination - members_[j].anchor).norm();
        const double needed = least_apart(members_[i], members_[j], tubes_) + ends_before(members_[i]);
        if (asked_[j] && off < needed) chain.set(j);
      }
    }
  }
  return chain;
}

void Search::stay(const Members& who) noexcept {
  for (std::size_t i = 0; i < most_members; ++i)
    if (who[i]) ways_[i] = Reference{members_[i].anchor};
}

/// Round the other way once all centres have been tried, and about every other hub.
Plan Search::empty_plan() const noexcept {
  return {.epoch = start_,
          .centre = hubs_[hub_].centre,
          .scale = hubs_[hub_].scale,
          .to_port = (attempt_ / centres + hub_) % 2 == 1};
}

/// Who keeps a member from going so: itself, where that is what stands; nobody if it may.
std::optional<std::size_t> Search::hindrance_to(std::size_t member, const Reference& reference,
                                                const Clearance& scene, const Chart& chart) const noexcept {
  if (!keeps_off(reference, chart, berth(members_[member], tubes_)) ||
      !scene.passes(member, reference, chart.passing()))
    return member;
  return scene.hindered_by(member, reference, suspected_);
}

bool Search::go_on(int count, const Chart& chart) noexcept {
  for (; count > 0 && stage_ != Stage::done; --count) {
    if (stage_ == Stage::carousel) {
      count -= carousel_cost - 1;
      try_carousel(number_++, chart);
      if (number_ == carousel_count()) end_carousels();
    } else if (stage_ == Stage::improve) {
      improve_next(chart);
    } else {
      try_next_code(chart);
    }
    count -= spent_;
    spent_ = 0;
  }
  return stage_ == Stage::done;
}

/// Nobody of the participants placed yet.
Clearance Search::scene_beside(const std::array<Reference, most_members>& others, const Members& participants,
                               const Epoch& start) const noexcept {
  Clearance scene{members_, participants, tubes_, start_of(start)};
  for (std::size_t i = 0; i < most_members; ++i)
    if (!participants[i] && !others[i].empty()) scene.place(i, others[i]);
  return scene;
}

bool Search::holds_from(const Epoch& start, std::span<const Passing> passing) const noexcept {
  Plan plan = best_.plan;
  plan.epoch = start;
  const Clearance scene = scene_beside(others_, plan.participants, start);
  for (std::size_t i = 0; i < most_members; ++i) {
    if (!plan.participants[i]) continue;
    const Reference reference = reference_of(members_[i], plan, plan.codes[i]);
    if (!scene.accepts(i, reference) || !scene.passes(i, reference, passing)) return false;
  }
  return true;
}

/// The participant after this one; false, and the first again, after the last.
bool Search::next_member() noexcept {
  number_ = 0;
  least_cost_ = never;
  do {
    if (++turn_ < most_members) continue;
    turn_ = 0;
    member_ = numbered(0);
    return false;
  } while (!participants_[numbered(turn_)]);
  member_ = numbered(turn_);
  return true;
}

/// With wider rings too, where headway is wanted.
int Search::carousel_count() const noexcept {
  const std::size_t wider = ring_scale.size() - hubs_[hub_].scale;
  return carousels * static_cast<int>(wanted_.aim > 0.0 ? std::min(widths, wider) : 1);
}

void Search::try_carousel(int number, const Chart& chart) noexcept {
  const auto down = static_cast<std::uint8_t>(number % rings),
             up = static_cast<std::uint8_t>(number / rings % rings);
  if (number % (rings * rings) == 0) clashes_ = {};  // of another side or width
  Clashes::Rings by{};
  for (std::size_t i = 0; i < most_members; ++i) by[i] = dives(members_[i]) ? down : up;
  if (clashes_.are_any(participants_, by)) return;
  Plan plan = empty_plan();
  plan.scale = static_cast<std::uint8_t>(plan.scale + number / carousels);
  plan.to_port = number % carousels >= rings * rings;
  plan.participants = participants_;
  Clearance scene = scene_beside(ways_, participants_, start_);
  for (std::size_t i = 0; i < most_members; ++i) {
    if (!participants_[i]) continue;
    plan.codes[i].ring = by[i];
    const Reference reference = reference_of(members_[i], plan, plan.codes[i]);
    if (reference.end() > latest_[i]) return clashes_.add(i, i, by);
    if (const auto hindrance = hindrance_to(i, reference, scene, chart))
      return clashes_.add(i, participants_[*hindrance] ? *hindrance : i, by);
    scene.place(i, reference);
  }
  keep(scene, plan);
}

/// The best carousel is improved; without one the members go one by one.
void Search::end_carousels() noexcept {
  if (of_hub_.is_any()) return begin_with(Stage::improve, of_hub_.plan);
  begin_with(Stage::one_by_one, empty_plan());
}

/// From the first member's first code on.
void Search::begin_with(Stage stage, const Plan& plan) noexcept {
  stage_ = stage;
  plan_ = plan;
  number_ = 0;
  turn_ = 0;
  member_ = numbered(0);
  least_cost_ = never;
  scene_ = scene_beside(ways_, participants_, start_);
  for (std::size_t i = 0; i < most_members; ++i)
    if (plan_.participants[i]) scene_.place(i, reference_of(members_[i], plan_, plan_.codes[i]));
}

/// What is lacking of the headway that is wanted: among those who are asked, and besides, where others are on
/// their ways, towards these [s].
template <class HeadwayTowards>
double Search::lack_of(const HeadwayTowards& headway_towards) const noexcept {
  if (start_ == at_zero) return wanted_.aim - headway_towards(Members{}.set());
  return 2.0 * wanted_.aim - headway_towards(asked_) - headway_towards(~asked_);
}

/// Of the way of the member whose turn it is.
double Search::cost_of(const Reference& reference) noexcept {
  if (wanted_.aim <= 0.0 || stage_ == Stage::on_the_spot) return reference.end();
  spent_ += 2 * pair_cost * static_cast<int>(scene_.placed().count());
  const double lacks =
      lack_of([&](const Members& others) { return headway_of(member_, reference, scene_, others, wanted_); });
  return reference.end() + worth * static_cast<double>(participants_.count()) * lacks;
}

/// The code of that number takes the member whose turn it is, if it costs less than `limit`. Of codes that
/// differ in the delay alone the later ones are so much later.
void Search::try_code(double limit, const Chart& chart) noexcept {
  const Code code = Code::of(static_cast<std::uint8_t>(number_));
  const Member& member = members_[member_];
  const bool on_the_spot = is_on_the_spot(member, code);
  if (is_first_of_ring()) passage_ = Passage{member, plan_, code.ring};
  double& undelayed = undelayed_[on_the_spot ? most_levels + code.dive : code.dive];
  const double delay = delay_of(member, code);
  if (delay > 0.0 && undelayed + delay > limit + rounding) return;
  const Reference reference = reference_of(member, plan_, code, passage_);
  if (delay <= 0.0) undelayed = reference.end();
  if (reference.end() >= limit) return;
  if (const auto hindrance = hindrance_to(member_, reference, scene_, chart)) {
    suspected_ = *hindrance;
    return;
  }
  const double cost = cost_of(reference);
  if (cost >= limit) return;
  least_cost_ = cost;
  code_ = code;
}

/// Of those who can go, as far as has been tried.
bool Search::are_any_level() const noexcept {
  for (std::size_t i = 0; i < most_members; ++i)
    if (participants_[i] && has_levels(members_[i])) return true;
  return false;
}

/// The member whose turn it is.
bool Search::goes_on_the_spot() const noexcept {
  return stage_ == Stage::on_the_spot && has_levels(members_[member_]);
}

/// The code of that number. Who goes on the spot goes straight if it can.
bool Search::is_to_be_tried() const noexcept {
  if (!goes_on_the_spot()) return true;
  const Code code = Code::of(static_cast<std::uint8_t>(number_));
  return is_on_the_spot(members_[member_], code) && (code.ring == 0 || least_cost_ == never);
}

bool Search::is_first_of_ring() const noexcept {
  const Code first = goes_on_the_spot() ? Code{.delay = 1, .dive = 1} : Code{};
  return number_ % (codes / rings) == first.packed();
}

/// One code of the member whose turn it is; when all were tried it takes the cheapest, or stays. Where not
/// all have one, those who have levels go on the spot.
void Search::try_next_code(const Chart& chart) noexcept {
  if (!participants_[member_]) number_ = codes;
  while (number_ < codes && !is_to_be_tried()) ++number_;
  if (number_ < codes) try_code(math::fmin(least_cost_, latest_[member_]), chart);
  if (++number_ < codes) return;
  if (least_cost_ < never) {
    plan_.codes[member_] = code_;
    plan_.participants.set(member_);
    scene_.place(member_, reference_of(members_[member_], plan_, code_));
  }
  if (next_member()) return;
  if (plan_.participants == participants_) {
    if (stage_ == Stage::one_by_one) keep(scene_, plan_);
    stage_ = Stage::improve;
    return;
  }
  if (stage_ == Stage::one_by_one) {
    went_ = plan_.participants;
    if (are_any_level()) return begin_with(Stage::on_the_spot, empty_plan());
  }
  if (plan_.participants.count() > went_.count()) went_ = plan_.participants;
  stay(participants_ & ~went_);
  participants_ = went_;
  begin();
  if (stage_ == Stage::done) end_hub();
}

/// The same of somebody who has a code already. Ends with the first round in which nobody found a cheaper
/// one.
void Search::improve_next(const Chart& chart) noexcept {
  if (!plan_.participants[member_]) {
    number_ = codes - 1;
  } else {
    if (number_ == 0) {
      scene_.take_away(member_);
      cost_ = cost_of(scene_.reference(member_));
    }
    try_code(math::fmin(least_cost_, cost_ - least_gain), chart);
  }
  if (++number_ < codes) return;
  if (plan_.participants[member_]) {
    if (least_cost_ < never) {
      plan_.codes[member_] = code_;
      improved_ = true;
    }
    scene_.place(member_, reference_of(members_[member_], plan_, plan_.codes[member_]));
  }
  if (next_member()) return;
  keep(scene_, plan_);
  if (!improved_) end_hub();
  improved_ = false;
}

/// More who go are better, then a lower cost.
bool Search::Option::is_better_than(const Option& other) const {
  const std::size_t has = plan.participants.count(), had = other.plan.participants.count();
  return has > had || (has == had && has > 0 && cost < other.cost);
}

void Search::keep(const Clearance& scene, const Plan& plan) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < most_members; ++i)
    if (plan.participants[i]) sum += scene.reference(i).end();
  Option option{plan, sum / static_cast<double>(plan.participants.count())};
  if (wanted_.aim > 0.0 && option.is_better_than(of_hub_)) {
    const auto placed = static_cast<int>(scene.placed().count());
    spent_ += pair_cost * placed * placed;
    option.cost += worth * lack_of([&](const Members& others) {
                     return headway_of(scene, plan.participants, others, wanted_);
                   });
  }
  if (option.is_better_than(of_hub_)) of_hub_ = option;
  if (option.is_better_than(best_)) best_ = option;
}

}  // namespace fairway::pledge
