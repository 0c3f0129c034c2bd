// SPDX-License-Identifier: LGPL-2.1-or-later
// A file of nets in JSON is read, cut into pieces, brought into other forms and written.
#include "adapters/occt/base/errors.h"
#include "core/base/errors.h"
#include "plugin/nets/conversion.h"
#include "plugin/nets/net_json.h"
#include "plugin/nets/net_models.h"
#include "tests/fuzz/support/files.h"

namespace blossom::fuzz {
namespace {

// What an input does not break must be there again after it was written.
template <class Work>
void unless_refused(const Work& work) try {
  work();
} catch (const occt::BadModel&) {
} catch (const occt::Failure&) {
} catch (const InvalidInput&) {
}

}  // namespace

void try_input(Bytes input) {
  unless_refused([&] {
    const std::vector<nets::Net> read = nets::read_nets(file_of(input, ".json"));
    require(!read.empty(), "a file is read and has no net");
    for (const auto form : {nets::TargetForm::AsItIs, nets::TargetForm::Bezier,
                            nets::TargetForm::Monomial, nets::TargetForm::Triangles})
      unless_refused([&] {
        const nets::Conversion made = nets::converted(read, form, {});
        const std::string text = nets::nets_json(made.nets).dump();
        require(!text.empty(), "nets are written as nothing");
      });
    unless_refused([&] { nets::model_of_nets(read); });
  });
}

}  // namespace blossom::fuzz
