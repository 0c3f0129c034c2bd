// SPDX-License-Identifier: LGPL-2.1-or-later
// Assemblies as the parts that they are made of.

#include <string>
#include <vector>

#include <TDF_LabelSequence.hxx>
#include <XCAFDoc_GraphNode.hxx>

#include "adapters/occt/documents/document.h"
#include "adapters/occt/documents/parts.h"

namespace blossom::occt {
namespace {

// Colours that instances have, or that they give to one of those within: what is said farther
// outside goes before, and among that what names more of the way.
void paint_as_instance(const Document& from, const Usage& usage, const Document& to,
                       const TDF_Label& label) {
  const std::vector<TDF_Label>& way = usage.instances;
  for (std::size_t first = way.size(); first-- > 0;) {
    TDF_LabelSequence part_of_way;
    for (std::size_t last = first; last < way.size(); ++last) {
      part_of_way.Append(way[last]);
      Handle(XCAFDoc_GraphNode) style;
      if (last == first)
        paint(to, label, {{}, colours_of(from, way[first])});
      else if (from.shapes()->FindSHUO(part_of_way, style))
        paint(to, label, {{}, colours_of(from, style->Label())});
    }
  }
}

}  // namespace

void add_instances(const Document& from, const Document& to) {
  TDF_LabelSequence roots;
  from.shapes()->GetFreeShapes(roots);
  for (const Usage& usage : all_usages(from)) {
    const auto placed = [&](const TDF_Label& label) {
      TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
      shape.Location(usage.location * shape.Location(), false);
      return shape;
    };
    const TDF_Label label = to.shapes()->NewShape();
    to.shapes()->SetShape(label, placed(usage.part));
    copy_looks(usage.part, label);
    const std::string root = name_of(usage.root);
    const bool name_root = roots.Length() > 1 && usage.root != usage.part && !root.empty();
    set_name(label, (name_root ? root + "/" : "") + part_path(usage));
    paint_as_instance(from, usage, to, label);
    TDF_LabelSequence subs;
    XCAFDoc_ShapeTool::GetSubShapes(usage.part, subs);
    for (const TDF_Label& sub : subs)
      if (const TDF_Label added = to.shapes()->AddSubShape(label, placed(sub)); !added.IsNull())
        copy_looks(sub, added);
  }
}

}  // namespace blossom::occt
