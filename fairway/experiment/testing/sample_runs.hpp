// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "fairway/core/rng.hpp"
#include "fairway/core/testing/temporary_folder.hpp"
#include "fairway/experiment/run.hpp"
#include "fairway/experiment/store.hpp"

namespace fairway::sample {

inline std::string bytes_of(const std::string& file) {
  std::ifstream stream{file, std::ios::binary};
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline void write_bytes(const std::string& file, std::string_view bytes) {
  std::ofstream{file, std::ios::binary} << bytes;
}

inline std::string csv_of(const Store& store) {
  std::ostringstream out;
  store.export_csv(out);
  return out.str();
}

/// Two methods under the same seeds: `count` runs.
inline std::vector<RunSpec> specs(std::size_t count) {
  std::vector<RunSpec> specs;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string method = i % 2 == 0 ? "apf" : "orca3d";
    specs.push_back({.key = "run" + std::to_string(i),
                     .labels = {{"case", "cube20_8"}, {"method", method}},
                     .seed = i / 2});
  }
  return specs;
}

/// What run `index` measures: the same whenever it is made.
inline std::vector<Measure> measures(std::size_t index) {
  Rng rng = Rng{42}.stream("sample", index);
  return {{"makespan_s", Measure::fleet, rng.uniform(100.0, 200.0)},
          {"navigation_time_s", 0, rng.normal()},
          {"navigation_time_s", 1, rng.normal() * 1e-300}};
}

inline std::vector<RunRecord> records(std::size_t count) {
  std::vector<RunRecord> records;
  const auto all = specs(count);
  for (std::size_t i = 0; i < count; ++i) {
    records.push_back({.spec = all[i], .measures = measures(i), .wall_s = 0.25, .failure = {}});
  }
  return records;
}

}  // namespace fairway::sample
