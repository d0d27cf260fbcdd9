// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_EXTREMAL_MESH_3_FORMULA_H
#define CGAL_EXTREMAL_MESH_3_FORMULA_H

#include <CGAL/Extremal_mesh_3/Function_3.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace CGAL::Extremal_mesh_3 {

/// A formula that cannot be understood. The message gives the position and what was expected there.
class Formula_error : public std::invalid_argument {
public:
  Formula_error(const std::string& message, std::size_t position)
      : std::invalid_argument(message), position_(position) {}
  std::size_t position() const { return position_; } ///< offset in characters from the start of the text, from 0

private:
  std::size_t position_;
};

/// A function of x, y and z given as text, differentiated exactly.
class Formula : public Function_3 {
public:
  /// \throws Formula_error
  explicit Formula(std::string_view text);
  ~Formula() override;
  Formula(Formula&&) noexcept;

  double value(const Point& p) const override;
  void derivatives(const Point& p, int order, Derivatives& d) const override;
  void lattice_values(const Lattice& lattice, std::size_t k, double* out) const override;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace CGAL::Extremal_mesh_3

#endif // CGAL_EXTREMAL_MESH_3_FORMULA_H
