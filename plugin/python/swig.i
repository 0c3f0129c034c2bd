// SPDX-License-Identifier: LGPL-2.1-or-later
// Enters the type TopoDS_Shape into the table that all modules made by SWIG share.
%module(package="blossom") swig_shapes
%{
#include <TopoDS_Shape.hxx>
%}
class TopoDS_Shape {
 public:
  TopoDS_Shape();
  TopoDS_Shape(const TopoDS_Shape& other);
  ~TopoDS_Shape();
  bool IsNull() const;
};
