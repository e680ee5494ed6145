// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/film.hpp"

namespace fairway {

struct Film::Contents {
  FilmLimits limits;
};

Film::Film(const Scenario&, FilmLimits limits) : contents_{std::make_unique<Contents>(Contents{limits})} {}
Film::~Film() = default;
void Film::write(const Frame&) {}
std::size_t Film::size() const { return 0; }
std::size_t Film::stride() const { return 1; }
std::size_t Film::generation() const { return 0; }
nlohmann::json Film::part(std::size_t, std::size_t, bool) const { return {}; }
std::string Film::notice() const { return {}; }

}  // namespace fairway
