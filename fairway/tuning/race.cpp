// SPDX-License-Identifier: Apache-2.0
#include "fairway/tuning/race.hpp"

#include <algorithm>

namespace fairway {
namespace {

std::vector<std::size_t> those_in(const std::vector<Contender>& contenders) {
  std::vector<std::size_t> in;
  for (std::size_t i = 0; i < contenders.size(); ++i)
    if (!contenders[i].is_out) in.push_back(i);
  return in;
}

void put_out_the_beaten(std::vector<Contender>& contenders, std::span<const Outcome> champion,
                        std::span<const Outcome> usual, std::size_t scenarios) {
  const std::vector<std::size_t> in = those_in(contenders);
  const auto score = [&](std::size_t i) { return score_of(contenders[i].outcomes, usual); };
  const std::size_t best = *std::ranges::min_element(
      in, [&](std::size_t a, std::size_t b) { return is_better(score(a), score(b)); });
  const std::size_t bearable = score_of(champion, usual).unsafe;
  for (const std::size_t i : in) {
    const Outcomes& outcomes = contenders[i].outcomes;
    contenders[i].is_out = score(i).unsafe > bearable || is_beaten(outcomes, champion, scenarios) ||
                           (i != best && is_beaten(outcomes, contenders[best].outcomes, scenarios));
  }
}

}  // namespace

std::vector<Contender> race(std::vector<Contender> contenders, std::span<const Outcome> champion,
                            std::span<const Outcome> usual, const RaceCourse& course, const RunBlocks& run,
                            std::size_t& budget) {
  std::size_t done = 0;
  while (done < course.blocks) {
    const std::size_t blocks = std::min(course.step, course.blocks - done);
    const std::vector<std::size_t> in = those_in(contenders);
    const std::size_t cost = in.size() * blocks * course.scenarios;
    if (in.empty() || cost > budget) break;
    std::vector<Setting> settings;
    for (const std::size_t i : in) settings.push_back(contenders[i].setting);
    const std::vector<Outcomes> more = run(settings, done, blocks);
    for (std::size_t k = 0; k < in.size(); ++k) {
      Outcomes& outcomes = contenders[in[k]].outcomes;
      outcomes.insert(outcomes.end(), more[k].begin(), more[k].end());
    }
    budget -= cost;
    done += blocks;
    if (done < course.blocks) put_out_the_beaten(contenders, champion, usual, course.scenarios);
  }
  std::ranges::stable_sort(contenders, [&](const Contender& a, const Contender& b) {
    if (a.is_out != b.is_out && a.outcomes.size() == b.outcomes.size()) return b.is_out;
    if (a.outcomes.size() != b.outcomes.size()) return a.outcomes.size() > b.outcomes.size();
    return is_better(score_of(a.outcomes, usual), score_of(b.outcomes, usual));
  });
  return contenders;
}

}  // namespace fairway
