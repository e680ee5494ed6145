// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <nlohmann/json.hpp>

#include "fairway/experiment/compare.hpp"

namespace fairway {
namespace {

using nlohmann::json;

json number(double value) { return std::isfinite(value) ? json(value) : json(); }

json labels_json(const Labels& labels) {
  json object = json::object();
  for (const auto& [name, value] : labels) object[name] = value;
  return object;
}

json mean_json(const MeanEstimate& e) {
  return {{"runs", e.count},
          {"mean", number(e.mean)},
          {"deviation", number(e.deviation)},
          {"low", number(e.low)},
          {"high", number(e.high)}};
}

void add_test(json& difference, const ComparedTest& test) {
  difference["test"] = test.name;
  difference["exact"] = test.result.exact;
  difference["statistic"] = test.result.statistic;
  difference["p"] = test.result.p;
  difference["p_adjusted"] = test.p_adjusted;
  difference["effect"] = test.result.effect;
  difference["effect_size"] = test.effect_size;
}

json difference_json(const ComparedMean& m) {
  if (m.difference.count == 0) return nullptr;
  json difference = mean_json(m.difference);
  difference["median"] = number(m.difference_median.median);
  difference["median_low"] = number(m.difference_median.low);
  difference["median_high"] = number(m.difference_median.high);
  if (m.test) add_test(difference, *m.test);
  return difference;
}

json difference_json(const ComparedRate& r) {
  if (!r.test) return nullptr;
  json difference{{"runs", r.difference.pairs},
                  {"share", number(r.difference.difference)},
                  {"low", number(r.difference.low)},
                  {"high", number(r.difference.high)}};
  add_test(difference, *r.test);
  return difference;
}

json censored_json(const CensoredTimes& c) {
  return {{"cut", c.cut},
          {"complete",
           {{"successes", c.complete.successes},
            {"runs", c.complete.trials},
            {"share", number(c.complete.rate)},
            {"low", number(c.complete.low)},
            {"high", number(c.complete.high)}}},
          {"median", number(c.median.median)},
          {"median_low", number(c.median.low)},
          {"median_high", number(c.median.high)},
          {"limit", c.limit},
          {"restricted_mean", number(c.restricted.mean)},
          {"restricted_error", number(c.restricted.error)},
          {"restricted_low", number(c.restricted.low)},
          {"restricted_high", number(c.restricted.high)}};
}

json cell_json(const Comparison& comparison, const ComparedCell& c) {
  json cell{
      {"group", labels_json(c.group)}, {comparison.by, c.candidate}, {"runs", c.runs}, {"failed", c.failed}};
  if (c.identical > 0) cell["identical"] = c.identical;
  return cell;
}

json mean_json(const Comparison& comparison, const ComparedMean& m) {
  json mean{{"group", labels_json(m.group)}, {comparison.by, m.candidate},      {"quantity", m.quantity},
            {"value", mean_json(m.value)},   {"median", number(m.median)},      {"left_out", m.left_out},
            {"truncated", m.truncated},      {"difference", difference_json(m)}};
  if (m.censored) mean["censored"] = censored_json(*m.censored);
  return mean;
}

json rate_json(const Comparison& comparison, const ComparedRate& r) {
  return {
      {"group", labels_json(r.group)},  {comparison.by, r.candidate},   {"rate", r.name},
      {"successes", r.value.successes}, {"runs", r.value.trials},       {"share", number(r.value.rate)},
      {"low", number(r.value.low)},     {"high", number(r.value.high)}, {"difference", difference_json(r)}};
}

}  // namespace

json to_json(const Comparison& comparison) {
  json document{
      {"by", comparison.by},       {"baseline", comparison.baseline}, {"confidence", comparison.confidence},
      {"cells", json::array()},    {"means", json::array()},          {"rates", json::array()},
      {"tests", comparison.tests}, {"family", comparison.family},     {"remarks", json::array()}};
  for (const ComparedCell& c : comparison.cells) document["cells"].push_back(cell_json(comparison, c));
  for (const ComparedMean& m : comparison.means) document["means"].push_back(mean_json(comparison, m));
  for (const ComparedRate& r : comparison.rates) document["rates"].push_back(rate_json(comparison, r));
  for (const Remark& remark : remarks(comparison)) document["remarks"].push_back(remark.text);
  return document;
}

}  // namespace fairway
