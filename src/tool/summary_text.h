// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXTREMAL_MESH_3_SRC_TOOL_SUMMARY_TEXT_H
#define EXTREMAL_MESH_3_SRC_TOOL_SUMMARY_TEXT_H

#include "Result.h"

#include <string>
#include <vector>

namespace CGAL::Extremal_mesh_3::tool {

/// the counts by kind and type, the surface and the outcome of the checks in a few lines.
/// \param report  may be null
std::string summary_text(const Extremal_mesh& mesh, const std::vector<Check>& checks, const Extraction_report* report);

/// all that `extract` prints: what was repaired and how shapes were fitted, then `summary_text()`.
std::string result_text(const Result& result);

/// the object of `extract --report`: that of `to_json()`, with the objects "repairs" and "fit" if the input is a mesh.
std::string report_json(const Result& result);

/// one line per check: name, outcome, detail.
std::string checks_text(const std::vector<Check>& checks);

} // namespace CGAL::Extremal_mesh_3::tool

#endif // EXTREMAL_MESH_3_SRC_TOOL_SUMMARY_TEXT_H
