// SPDX-License-Identifier: LGPL-2.1-or-later
// A document as another one.

#include <TDF_ClosureTool.hxx>
#include <TDF_CopyTool.hxx>
#include <TDF_DataSet.hxx>
#include <TDF_RelocationTable.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/exchange/detail.h"

namespace blossom::occt {

Model Model::copy() const {
  const std::lock_guard guard(exchange_lock());
  Model made;
  guarded("copying the model", [&] {
    const TDF_Label from = impl_->document.main(), to = made.impl_->document.main();
    const Handle(TDF_DataSet) all = new TDF_DataSet;
    all->AddLabel(from);
    TDF_ClosureTool::Closure(all);
    const Handle(TDF_RelocationTable) table = new TDF_RelocationTable(true);
    table->SetRelocation(from, to);
    TDF_CopyTool::Copy(all, table);
    made.impl_->document.unit = impl_->document.unit;
    made.impl_->stated = impl_->stated;
    made.impl_->refresh();
  });
  return made;
}

}  // namespace blossom::occt
