// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces whose numbers are none leave the parts that they are in.

#include <TDF_LabelSequence.hxx>

#include "adapters/occt/documents/parts.h"
#include "adapters/occt/exchange/numbers.h"

namespace blossom::occt {

void Document::leave_out_bad_faces(const NumberSource& source, ReadingReport& report) {
  TDF_LabelSequence labels;
  shapes()->GetShapes(labels);
  for (const TDF_Label& label : labels) {
    if (!XCAFDoc_ShapeTool::IsSimpleShape(label)) continue;
    const TopoDS_Shape part = XCAFDoc_ShapeTool::GetShape(label);
    const BadShapes bad(part, source);
    if (bad.none()) continue;
    bad.list(name_of(label), report);
    bool left = bad.removals().empty() || replace_in_part(shapes(), label, bad.removals());
    if (left && bad.any_loose()) {
      const TopoDS_Shape rest = bad.without_loose(XCAFDoc_ShapeTool::GetShape(label));
      left = !rest.IsNull();
      if (left) shapes()->SetShape(label, rest);
    }
    if (!left) remove_part(shapes(), label);
  }
  shapes()->UpdateAssemblies();
}

}  // namespace blossom::occt
