// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fairway/record/output_check.hpp"

namespace fairway {

/// As write_page() writes it.
inline constexpr FileKind report_file{
    .name = "a report of fairway", .begins = "<!doctype html>", .holds = "<title>fairway report</title>"};

namespace embedded {

/// fairway/report/template.html as it was when this library was built: the page that viewer/ builds, with
/// the marker __FAIRWAY_DATA__ where the data belongs.
std::string report_template();

}  // namespace embedded

/// `page`, a built page of viewer/, with `json` in the place of its marker __FAIRWAY_DATA__: self-contained
/// HTML that needs no network and opens from file://. Characters that would end the script element that the
/// data lie in are escaped the way JSON allows, so any valid document is safe. The text is not checked here:
/// the page tells its reader what is wrong with it. Throws std::logic_error if there is no marker.
std::string filled(std::string page, const std::string& json);

/// The report that shows `json`; viewer/README.md describes its keys.
std::string render_page(const std::string& json);

/// Writes render_page(json) to `path`, whole or not at all (OutputFile). Throws InputError if it cannot be.
void write_page(const std::string& json, const std::string& path);

}  // namespace fairway
