// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace fairway {

namespace embedded {

/// fairway/report/template.html as it was when this library was built: the page that viewer/ builds, with
/// the marker __FAIRWAY_DATA__ where the data belongs.
std::string report_template();

}  // namespace embedded

/// One self-contained HTML page that shows `json`, a report document; viewer/README.md describes its keys.
/// The page needs no network and opens from file://. Characters that would end the <script> element the data
/// lie in are escaped the way JSON allows, so any valid document is safe. The text is not checked here: the
/// page tells its reader what is wrong with it.
std::string render_page(const std::string& json);

/// Writes render_page(json) to `path`, through a temporary file beside it and a rename, so that a reader
/// never meets half a page. Throws InputError when it cannot be written; then no temporary file remains and
/// what was at `path` before is untouched.
void write_page(const std::string& json, const std::string& path);

}  // namespace fairway
