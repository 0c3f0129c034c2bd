// SPDX-License-Identifier: LGPL-2.1-or-later
// Shapes side by side in one.

#pragma once

#include <concepts>
#include <ranges>

#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>

namespace blossom::occt {

/// A compound of the shapes, in their order.
template <std::ranges::input_range Shapes>
requires std::derived_from<std::ranges::range_value_t<Shapes>, TopoDS_Shape> TopoDS_Compound
compound_of(const Shapes& shapes) {
  TopoDS_Compound compound;
  const BRep_Builder builder;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& shape : shapes) builder.Add(compound, shape);
  return compound;
}

}  // namespace blossom::occt
