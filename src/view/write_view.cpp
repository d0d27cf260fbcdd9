// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../algorithms/patches.h"
#include "../differential/vector.h"
#include "../io/Text_file.h"
#include "view_data.h"
#include "viewer.h"

#include <cmath>
#include <stdexcept>

namespace CGAL::Extremal_mesh_3 {

void write_view(const std::string& file, const Extremal_mesh& mesh, const Cell_patches& patches,
                const View_options& options) {
  const double sine = norm(cross(options.view, options.up));
  if (!std::isfinite(sine) || !(sine > 1e-6 * norm(options.view) * norm(options.up)))
    throw std::invalid_argument("the direction of sight and what points upwards must be two different directions");
  require_patches_of(mesh, patches);
  Text_file out(file);
  out << viewer_page << view_data(mesh, patches, options) << "</script>\n<script>\n"
      << viewer_script << "</script>\n</body>\n</html>\n";
  out.commit();
}

} // namespace CGAL::Extremal_mesh_3
