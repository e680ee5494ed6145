// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace fairway::web {

/// Whether anybody has asked, since this was last asked, for what only OMPL finds. A method answers that as
/// it answers a failed search, so whatever it decides then is not what it decides elsewhere.
bool absent_library_was_wanted();

}  // namespace fairway::web
