// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fairway/studies/uuv/plan.hpp"

namespace fairway::uuv {

/// Every published moment beside the measured one (the mean of both vehicles; each in the note), and what
/// else was measured of the encounters. Agreement is `reproduced_assuming`, since radii, speeds,
/// accelerations and horizon are not published. Only RVO is judged: it is the paper's method.
std::vector<StudyRow> published_rows(const std::vector<Cell>& cells);

/// Over the variations: how often something touched, who arrived and when, how often both kept right.
std::vector<StudyRow> varied_rows(const std::vector<Cell>& cells);

/// The rows of gatherings: runs with a collision, runs in which somebody never arrived, time, turning.
std::vector<StudyRow> gathering_rows(const std::vector<Cell>& cells);

/// The rows of the cubes: runs with a collision and who arrived by channel, and down to which update rate no
/// run collided.
std::vector<StudyRow> silence_rows(const std::vector<Cell>& cells);

/// Whether there are cells of the method in the cube, and all of them were run.
bool is_complete(const std::vector<Cell>& cells, std::string_view cube, std::string_view method);

/// The lowest update rate such that at it and at all higher ones no run collided; nothing if even the
/// highest had a collision or was not run.
std::optional<double> safe_down_to(const std::vector<Cell>& cells, std::string_view cube,
                                   std::string_view method, double loss_ratio);

/// How rarely messages may come, a sentence for each method; cubes that are not complete are left out.
std::vector<std::string> silence_sentences(const std::vector<Cell>& cells);

/// Runs of which some pair of vehicles collided.
std::size_t collision_runs(const Cell& cell);

}  // namespace fairway::uuv
