// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/convert/kept_forms.h"

#include <utility>

#include "adapters/occt/convert/surfaces.h"

namespace blossom::occt {

void KeptForms::make(const TopoDS_Face& face) {
  BezierSurface form = bezier_surface(face, kFineForm);
  if (form.error == 0) return;
  const std::scoped_lock lock(mutex_);
  forms_.Bind(face, std::move(form));
}

BezierSurface KeptForms::take(const TopoDS_Face& face) {
  {
    const std::scoped_lock lock(mutex_);
    if (BezierSurface* const kept = forms_.ChangeSeek(face)) {
      BezierSurface form = std::move(*kept);
      forms_.UnBind(face);
      return form;
    }
  }
  return bezier_surface(face, kFineForm);
}

}  // namespace blossom::occt
