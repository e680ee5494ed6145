// SPDX-License-Identifier: Apache-2.0
// OMPL is not in the module: whoever searches a path by it is refused, and the run ends.
#include "fairway/planning/ompl_search.hpp"

#include <utility>

#include "bindings/web/absent.hpp"
#include "fairway/core/error.hpp"

namespace fairway {
namespace web {
namespace {

bool wanted = false;

}  // namespace

bool absent_library_was_wanted() { return std::exchange(wanted, false); }

}  // namespace web

SearchResult search_path(const PlanarMap&, const PathRequest&) {
  web::wanted = true;
  throw InputError("there is no OMPL here");
}

}  // namespace fairway
