// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <ostream>

namespace fairway::cli {
namespace {

using nlohmann::json;

json finite(double value) { return std::isfinite(value) ? json(value) : json(); }

/// One line a quantity, one column a vehicle; for many vehicles their least, mean and greatest.
void print_vehicles(const Scenario& scenario, const std::vector<Measure>& measures, std::ostream& out) {
  constexpr std::size_t most_columns = 8;
  const bool each = scenario.vehicles.size() <= most_columns;
  out << fmt::format("  {:<24}", each ? "of each vehicle" : "of the vehicles");
  if (each) {
    for (const VehicleSpec& vehicle : scenario.vehicles) out << fmt::format(" {:>12}", vehicle.name);
  } else {
    out << fmt::format(" {:>12} {:>12} {:>12}", "least", "mean", "greatest");
  }
  out << "\n";

  std::vector<std::string> quantities;
  for (const Measure& m : measures) {
    if (m.vehicle == 0) quantities.push_back(m.quantity);
  }
  for (const std::string& quantity : quantities) {
    std::vector<double> values;
    for (const Measure& m : measures) {
      if (m.vehicle != Measure::fleet && m.quantity == quantity) values.push_back(m.value);
    }
    if (!each) {
      const auto [least, greatest] = std::ranges::minmax(values);
      values = {least,
                std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size()),
                greatest};
    }
    out << fmt::format("  {:<24}", quantity);
    for (const double value : values) out << fmt::format(" {:>12.6g}", value);
    out << "\n";
  }
}

json known(const std::string& name) { return name.empty() ? json() : json(name); }

}  // namespace

json document_of(const Judgement& judgement) {
  return {{"metric", judgement.expectation.metric},
          {"worst", finite(judgement.worst)},
          {"kept", judgement.kept},
          {"vehicle", known(judgement.vehicle)},
          {"with", known(judgement.with)},
          {"time_s", judgement.time ? json(*judgement.time) : json()}};
}

json document_of(const Scenario& scenario, const RunOutcome& outcome,
                 const std::vector<Judgement>& judgements) {
  json document{{"scenario", scenario.name},
                {"seed", scenario.seed},
                {"simulated_s", outcome.simulated_s},
                {"outcome", outcome.divergence ? "diverged" : "finished"}};
  if (const auto& broke = outcome.divergence) {
    document["diverged"] = {
        {"vehicle", scenario.vehicles[broke->vehicle].name}, {"time_s", broke->time}, {"why", broke->why}};
  }
  for (const VehicleSpec& vehicle : scenario.vehicles)
    document["vehicles"].push_back({{"name", vehicle.name}});
  for (const Measure& measure : outcome.measures) {
    if (measure.vehicle == Measure::fleet) {
      document["fleet"][measure.quantity] = finite(measure.value);
    } else {
      document["vehicles"][static_cast<std::size_t>(measure.vehicle)][measure.quantity] =
          finite(measure.value);
    }
  }
  for (const auto& [vehicle, note] : outcome.notes) document["notes"][vehicle] = note;
  if (outcome.messages) {
    for_each_member<AcousticCounts>(
        [&](const auto& m) { document["messages"][std::string(m.name)] = *outcome.messages.*m.at; });
  }
  document["no_progress"] = json::array();
  for (const NoProgress& one : outcome.no_progress) {
    document["no_progress"].push_back({{"vehicle", one.name},
                                       {"progress", enum_name(one.report.state)},
                                       {"last_progress_s", one.report.last_progress},
                                       {"with", known(one.with)}});
  }
  document["expect"] = json::array();
  for (const Judgement& judgement : judgements) document["expect"].push_back(document_of(judgement));
  return document;
}

void print(const Scenario& scenario, const RunOutcome& outcome, const std::vector<Judgement>& judgements,
           std::ostream& out) {
  out << fmt::format("{}: {} vehicles, {:.1f} s simulated in {:.2f} s\n", scenario.name,
                     scenario.vehicles.size(), outcome.simulated_s, outcome.wall_s);
  for (const Measure& m : outcome.measures) {
    if (m.vehicle == Measure::fleet) out << fmt::format("  {:<24} {:.6g}\n", m.quantity, m.value);
  }
  if (outcome.divergence) {
    out << "  " << divergence_text(scenario, outcome) << "\n";
  } else {
    print_vehicles(scenario, outcome.measures, out);
  }
  for (const auto& [vehicle, note] : outcome.notes) out << "  " << vehicle << ": " << note << "\n";
  for (const auto& [name, report, with] : outcome.no_progress)
    out << "  " << name << ": " << text_of(report, with) << "\n";
  if (const auto& messages = outcome.messages) {
    out << fmt::format(
        "  messages: {} sent; {} received, {} lost, {} out of range, {} drowned, {} collided\n",
        messages->sent, messages->received, messages->lost, messages->out_of_range, messages->drowned,
        messages->collided);
  }
  if (outcome.decisions.count > 0) {
    out << fmt::format("  decisions: {}, mean {:.2f} us, worst {:.1f} us (on this machine)\n",
                       outcome.decisions.count,
                       1e6 * outcome.decisions.total_s / static_cast<double>(outcome.decisions.count),
                       1e6 * outcome.decisions.worst_s);
  }
  for (const Judgement& judgement : judgements) {
    out << "  " << (judgement.kept ? "kept    " : "FAILED  ") << text_of(judgement) << "\n";
  }
}

}  // namespace fairway::cli
