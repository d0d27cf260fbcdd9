// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_SRC_FORMULA_PARSER_H
#define CGAL_EXTREMAL_MESH_3_SRC_FORMULA_PARSER_H

#include "Expression.h"

#include <string_view>

namespace CGAL::Extremal_mesh_3::internal {

/// adds a formula to an expression. The grammar is in the documentation of Formula.
/// \return the node that is its value
/// \throws Formula_error
Expression::Id parse_formula(std::string_view text, Expression& expression);

} // namespace CGAL::Extremal_mesh_3::internal

#endif // CGAL_EXTREMAL_MESH_3_SRC_FORMULA_PARSER_H
