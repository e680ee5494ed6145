// SPDX-License-Identifier: Apache-2.0
#include "fairway/exam/exam_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "fairway/core/math.hpp"
#include "fairway/experiment/ranks.hpp"

namespace fairway {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::vector<double> finite(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  return values;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? unknown : sum / static_cast<double>(values.size());
}

std::size_t place_in(const std::vector<std::string>& order, const std::string& name) {
  return static_cast<std::size_t>(std::ranges::find(order, name) - order.begin());
}

/// Cells in the order of the exam, each with its runs by seed and the baseline's beside them.
std::vector<ExamCell> cells_of(std::span<const ExamRun> runs, const ExamOrder& order) {
  using Key = std::tuple<std::size_t, std::size_t, std::size_t, std::string, bool>;
  std::map<Key, std::map<std::uint64_t, const ExamRun*>> sorted;
  for (const ExamRun& run : runs) {
    const Key key{place_in(order.families, run.family), place_in(order.conditions, run.condition),
                  place_in(order.methods, run.method), run.method, run.tuned};
    sorted[key].emplace(run.seed, &run);
  }
  std::vector<ExamCell> cells;
  for (const auto& [key, by_seed] : sorted) {
    const ExamRun& one = *by_seed.begin()->second;
    const auto usual = sorted.find(Key{std::get<0>(key), std::get<1>(key),
                                       place_in(order.methods, order.baseline), order.baseline, false});
    ExamCell& cell = cells.emplace_back(
        ExamCell{.family = one.family, .condition = one.condition, .method = one.method, .tuned = one.tuned});
    cell.is_baseline = one.method == order.baseline && !one.tuned;
    for (const auto& [seed, run] : by_seed) {
      const auto beside = usual == sorted.end() ? by_seed.end() : usual->second.find(seed);
      const bool known = usual != sorted.end() && beside != usual->second.end();
      cell.runs.push_back(run);
      cell.baseline.push_back(known ? beside->second : nullptr);
    }
  }
  return cells;
}

std::vector<double> values_of(const ExamCell& cell, double ExamOutcome::*member) {
  std::vector<double> values;
  for (const ExamRun* run : cell.runs) values.push_back(run->outcome.*member);
  return finite(std::move(values));
}

class Rows {
 public:
  explicit Rows(std::vector<ExamRow>& rows) : rows_{rows} {}

  void add_all(const ExamCell& cell) {
    rate(cell, "collision_free_ratio", [](const ExamOutcome& o) { return o.is_safe(); });
    rate(cell, "all_arrived_ratio", [](const ExamOutcome& o) { return o.all_arrived(); });
    rate(cell, "no_progress_ratio", [](const ExamOutcome& o) { return !(o.no_progress <= 0.5); });
    MeanEstimate arrived = estimate_mean(values_of(cell, &ExamOutcome::arrived_ratio));
    arrived.low = math::fmax(0.0, arrived.low);
    arrived.high = math::fmin(1.0, arrived.high);
    mean(cell, "arrived_ratio", arrived);
    mean(cell, "time_ratio", estimate_mean(finite(cell.ratios(&ExamOutcome::time_s))));
    mean(cell, "length_ratio", estimate_mean(finite(cell.ratios(&ExamOutcome::length_m))));
    mean(cell, "energy_ratio", estimate_mean(finite(cell.ratios(&ExamOutcome::energy_j))));
    mean(cell, "heading_change_rad", estimate_mean(values_of(cell, &ExamOutcome::turning_rad)));
    const std::vector<double> clearances = values_of(cell, &ExamOutcome::clearance_m);
    mean(cell, "clearance_m", estimate_mean(clearances));
    if (!clearances.empty())
      add(cell, "worst_clearance_m", *std::ranges::min_element(clearances), unknown, unknown,
          clearances.size());
  }

 private:
  void add(const ExamCell& cell, const char* quantity, double mean, double low, double high,
           std::size_t runs) {
    rows_.push_back({cell.family, cell.condition, cell.method, cell.tuned, quantity, mean, low, high, runs});
  }

  template <class Is>
  void rate(const ExamCell& cell, const char* quantity, const Is& is) {
    std::size_t count = 0;
    for (const ExamRun* run : cell.runs) count += is(run->outcome) ? 1 : 0;
    const RateEstimate rate = wilson_interval(count, cell.runs.size());
    add(cell, quantity, rate.rate, rate.low, rate.high, rate.trials);
  }

  void mean(const ExamCell& cell, const char* quantity, const MeanEstimate& mean) {
    if (mean.count > 0) add(cell, quantity, mean.mean, mean.low, mean.high, mean.count);
  }

  std::vector<ExamRow>& rows_;
};

/// Whether `a` came out better than `b`: safe before unsafe, then in larger part arrived, then in less time
/// by more than one in a hundred. Two that were unsafe are alike.
bool is_better(const ExamOutcome& a, const ExamOutcome& b) {
  constexpr double grain = 1.01;
  if (!a.is_safe() || !b.is_safe()) return a.is_safe() && !b.is_safe();
  if (a.arrived_ratio != b.arrived_ratio) return a.arrived_ratio > b.arrived_ratio;
  return a.time_s * grain < b.time_s;
}

/// Calls `visit(i, j)` for run i of one cell and run j of another that are under the same seed.
template <class Visit>
void for_each_pair(const ExamCell& a, const ExamCell& b, const Visit& visit) {
  for (std::size_t i = 0, j = 0; i < a.runs.size(); ++i) {
    while (j < b.runs.size() && b.runs[j]->seed < a.runs[i]->seed) ++j;
    if (j < b.runs.size() && b.runs[j]->seed == a.runs[i]->seed) visit(i, j);
  }
}

std::vector<std::pair<const ExamRun*, const ExamRun*>> pairs_of(const ExamCell& a, const ExamCell& b) {
  std::vector<std::pair<const ExamRun*, const ExamRun*>> pairs;
  for_each_pair(a, b, [&](std::size_t i, std::size_t j) { pairs.emplace_back(a.runs[i], b.runs[j]); });
  return pairs;
}

/// How two cells differ over the seeds of both; positive effects are in favour of the first.
struct Difference {
  PairedTest safety;
  PairedTest outcome;
};

PairedAnswers answers_of(std::span<const std::pair<const ExamRun*, const ExamRun*>> pairs) {
  PairedAnswers answers;
  for (const auto& [one, other] : pairs) {
    const bool first = one->outcome.is_safe(), second = other->outcome.is_safe();
    ++(first ? (second ? answers.both : answers.first) : (second ? answers.second : answers.neither));
  }
  return answers;
}

Difference difference_of(const ExamCell& a, const ExamCell& b) {
  const auto pairs = pairs_of(a, b);
  std::size_t more = 0, less = 0;
  for (const auto& [one, other] : pairs) {
    more += is_better(one->outcome, other->outcome) ? 1 : 0;
    less += is_better(other->outcome, one->outcome) ? 1 : 0;
  }
  return {mcnemar_test(answers_of(pairs)), sign_test(more, less)};
}

/// Whether `a` leads before `b`.
bool leads(const ExamCell& a, const ExamCell& b) {
  const auto rate = [](const ExamCell& cell) {
    return static_cast<double>(cell.safe_count()) / static_cast<double>(cell.runs.size());
  };
  if (rate(a) != rate(b)) return rate(a) > rate(b);
  if (a.arrived() != b.arrived()) return a.arrived() > b.arrived();
  const double x = a.time_ratio(), y = b.time_ratio();
  return std::isfinite(x) && (!std::isfinite(y) || x < y);
}

/// For ranks, less being better: the time of a run, behind every run in which more arrived, and a collision
/// behind all.
double badness(const ExamOutcome& outcome) {
  constexpr double beyond_any_time = 1e9;
  if (!outcome.is_safe()) return std::numeric_limits<double>::infinity();
  const double time = std::isfinite(outcome.time_s) ? outcome.time_s : beyond_any_time;
  return (1.0 - outcome.arrived_ratio) * 1e3 * beyond_any_time + time;
}

void add_ranks(Contest& contest) {
  std::set<std::uint64_t> common;
  for (const ExamRun* run : contest.placings.front().cell->runs) common.insert(run->seed);
  for (const Placing& placing : contest.placings) {
    std::set<std::uint64_t> seeds;
    for (const ExamRun* run : placing.cell->runs)
      if (common.contains(run->seed)) seeds.insert(run->seed);
    common = std::move(seeds);
  }
  contest.seeds = common.size();
  if (contest.placings.size() < 2 || common.empty()) return;
  std::map<std::uint64_t, std::vector<double>> blocks;
  for (const Placing& placing : contest.placings)
    for (const ExamRun* run : placing.cell->runs)
      if (common.contains(run->seed)) blocks[run->seed].push_back(badness(run->outcome));
  std::vector<std::vector<double>> values;
  for (auto& [seed, block] : blocks) values.push_back(std::move(block));
  const FriedmanTest test = friedman_test(values);
  contest.friedman_p = test.p;
  contest.critical_difference = nemenyi_difference(contest.placings.size(), values.size());
  for (std::size_t i = 0; i < contest.placings.size(); ++i)
    contest.placings[i].mean_rank = test.mean_ranks[i];
}

void mark_front(Contest& contest) {
  const auto rate = [](const Placing& p) {
    return static_cast<double>(p.cell->safe_count()) / static_cast<double>(p.cell->runs.size());
  };
  for (Placing& one : contest.placings) {
    const double time = one.cell->time_ratio();
    one.on_front = std::isfinite(time) && std::ranges::none_of(contest.placings, [&](const Placing& other) {
                     const double others = other.cell->time_ratio();
                     if (!std::isfinite(others) || rate(other) < rate(one) || others > time) return false;
                     return rate(other) > rate(one) || others < time;
                   });
  }
}

/// Every family under every condition, whoever leads first; all that is tested is judged by judge().
std::vector<Contest> contests_of(const ExamTable& table) {
  std::vector<Contest> contests;
  for (const ExamCell& cell : table.cells) {
    if (cell.is_baseline) continue;
    if (contests.empty() || contests.back().family != cell.family ||
        contests.back().condition != cell.condition)
      contests.push_back({.family = cell.family, .condition = cell.condition, .placings = {}});
    contests.back().placings.push_back({.cell = &cell});
  }
  for (Contest& contest : contests) {
    std::ranges::stable_sort(contest.placings,
                             [](const Placing& a, const Placing& b) { return leads(*a.cell, *b.cell); });
    add_ranks(contest);
    mark_front(contest);
  }
  return contests;
}

/// Holds everyone against whoever leads its contest; gives how many tests that took.
std::size_t judge(std::vector<Contest>& contests) {
  std::vector<double> p;
  std::vector<bool> is_behind;  // what each would say
  for (const Contest& contest : contests) {
    const double could_lead = 0.5 * static_cast<double>(contest.placings.size());
    for (std::size_t i = 1; i < contest.placings.size(); ++i) {
      const auto [safety, outcome] = difference_of(*contest.placings.front().cell, *contest.placings[i].cell);
      for (const PairedTest& test : {safety, outcome}) {
        p.push_back(math::fmin(1.0, test.p * math::fmax(1.0, could_lead)));
        is_behind.push_back(test.effect > 0.0);
      }
    }
  }
  const std::vector<double> adjusted = holm_adjusted(p);
  std::size_t next = 0;
  for (Contest& contest : contests) {
    bool all_behind = true;
    for (std::size_t i = 1; i < contest.placings.size(); ++i, next += 2) {
      Placing& placing = contest.placings[i];
      const std::array<std::string_view, 2> of{"safety", "outcome"};
      placing.place = Place::shared;
      placing.p_adjusted = math::fmin(adjusted[next], adjusted[next + 1]);
      for (std::size_t k = 2; k-- > 0;) {
        if (!is_behind[next + k] || adjusted[next + k] >= exam_significance) continue;
        placing.place = Place::behind;
        placing.behind_in = of[k];
      }
      all_behind = all_behind && placing.place == Place::behind;
    }
    const bool is_alone = contest.placings.size() < 2;
    contest.placings.front().place = is_alone ? Place::alone : all_behind ? Place::first : Place::shared;
  }
  return p.size();
}

std::vector<Awareness> awareness_of(const ExamTable& table) {
  std::vector<Awareness> all;
  if (table.conditions.empty()) return all;
  const auto find = [&](const ExamCell& like, const std::string& condition) -> const ExamCell* {
    const auto found = std::ranges::find_if(table.cells, [&](const ExamCell& cell) {
      return cell.condition == condition && cell.family == like.family && cell.method == like.method &&
             cell.tuned == like.tuned;
    });
    return found == table.cells.end() ? nullptr : &*found;
  };
  std::map<std::tuple<std::string, bool, std::string>, std::size_t> places;
  std::vector<PairedAnswers> answers;
  std::vector<std::vector<double>> changes;
  for (const ExamCell& cell : table.cells) {
    const ExamCell* usual = find(cell, table.conditions.front());
    if (cell.is_baseline || usual == nullptr || usual == &cell) continue;
    const auto [at, is_new] = places.try_emplace({cell.method, cell.tuned, cell.condition}, all.size());
    if (is_new) {
      all.push_back({.method = cell.method, .tuned = cell.tuned, .condition = cell.condition});
      answers.emplace_back();
      changes.emplace_back();
    }
    const PairedAnswers more = answers_of(pairs_of(cell, *usual));
    PairedAnswers& sum = answers[at->second];
    sum.both += more.both, sum.first += more.first, sum.second += more.second, sum.neither += more.neither;
    const std::vector<double> now = cell.ratios(&ExamOutcome::time_s);
    const std::vector<double> before = usual->ratios(&ExamOutcome::time_s);
    for_each_pair(cell, *usual, [&](std::size_t i, std::size_t j) {
      changes[at->second].push_back(now[i] / before[j] - 1.0);
    });
  }
  std::vector<double> p;
  for (const PairedAnswers& each : answers) p.push_back(mcnemar_test(each).p);
  const std::vector<double> adjusted = holm_adjusted(p);
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].safety = paired_rate_difference(answers[i]);
    all[i].p_adjusted = adjusted[i];
    all[i].time_ratio = estimate_mean(finite(changes[i]));
  }
  return all;
}

}  // namespace

std::string ExamCell::name() const { return tuned ? method + ", tuned" : method; }

std::size_t ExamCell::safe_count() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(runs, [](const ExamRun* run) { return run->outcome.is_safe(); }));
}

double ExamCell::arrived() const { return mean_of(values_of(*this, &ExamOutcome::arrived_ratio)); }

std::vector<double> ExamCell::ratios(double ExamOutcome::*member) const {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const bool both =
        baseline[i] != nullptr && runs[i]->outcome.all_arrived() && baseline[i]->outcome.all_arrived();
    ratios.push_back(both ? runs[i]->outcome.*member / baseline[i]->outcome.*member : unknown);
  }
  return ratios;
}

double ExamCell::time_ratio() const { return mean_of(finite(ratios(&ExamOutcome::time_s))); }

std::string_view name_of(Place place) {
  constexpr std::array names{"first", "shared", "behind", "alone"};
  return names[static_cast<std::size_t>(place)];
}

ExamTable exam_table(std::span<const ExamRun> runs, const ExamOrder& order) {
  ExamTable table{.families = order.families, .conditions = order.conditions};
  table.cells = cells_of(runs, order);
  Rows rows{table.rows};
  for (const ExamCell& cell : table.cells) rows.add_all(cell);
  table.contests = contests_of(table);
  table.tests = judge(table.contests);
  table.awareness = awareness_of(table);
  return table;
}

}  // namespace fairway
