// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace fairway::web {

/// The bytes of the file that was last committed; it is gone from here then.
std::string taken_file();

}  // namespace fairway::web
