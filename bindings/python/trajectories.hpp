// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "fairway/record/frame.hpp"

namespace fairway::python {

/// Keeps what moves of every frame, as columns. Needs nothing of Python; memory grows with the run.
class TrajectoryColumns final : public FrameSink {
 public:
  void write(const Frame& frame) override;

  /// The columns as `fairway.Trajectories`, whose arrays take them over. With the interpreter's lock held.
  pybind11::object take();

 private:
  std::size_t vehicles_{};
  std::vector<double> times_;
  std::vector<double> positions_;
  std::vector<double> velocities_;
  std::vector<double> quaternions_;
  std::vector<double> yaws_;
  std::vector<double> commands_;
  std::vector<double> goals_;
  std::vector<double> powers_;
  std::vector<std::uint8_t> modes_;
  std::vector<std::uint8_t> phases_;
};

/// Adds the classes `Trajectories` and `Phase`.
void bind_trajectories(pybind11::module_& m);

}  // namespace fairway::python
