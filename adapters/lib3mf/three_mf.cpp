// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/lib3mf/three_mf.h"

#include <algorithm>

#include <Model/COM/NMR_DLLInterfaces.h>

namespace blossom::lib3mf {
namespace {

constexpr std::uint8_t kGrey = 204;  // of what has no colour beside something that has

void check(int result, const char* step) {
  if (result != 0)
    throw ThreeMfFailure("lib3mf cannot write 3MF: " + std::string(step) + " gives " +
                         std::to_string(result));
}

// What the library made, given back at the end.
template <class Made>
class Owned {
 public:
  Owned() = default;
  ~Owned() {
    if (made_) NMR::lib3mf_release(made_);
  }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;

  Made** out() { return &made_; }
  Made* get() const { return made_; }

 private:
  Made* made_ = nullptr;
};

void give_geometry(NMR::PLib3MFModelMeshObject* made, const ThreeMfObject& object) {
  const auto& [name, points, triangles, colours] = object;
  std::vector<NMR::MODELMESHVERTEX> vertices(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (int k = 0; k < 3; ++k) vertices[i].m_fPosition[k] = static_cast<float>(points[i][k]);
  std::vector<NMR::MODELMESHTRIANGLE> corners(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      corners[t].m_nIndices[k] = static_cast<std::uint32_t>(triangles[t][k]);
  check(NMR::lib3mf_meshobject_setgeometry(
            made, vertices.data(), static_cast<std::uint32_t>(vertices.size()), corners.data(),
            static_cast<std::uint32_t>(corners.size())),
        "setgeometry");
}

void give_colours(NMR::PLib3MFModelMeshObject* made, const ThreeMfObject& object) {
  const std::vector<ThreeMfColour>& colours = object.colours;
  if (std::ranges::none_of(colours, [](const auto& each) { return each.colour.has_value(); }))
    return;
  // Triangles may have colours only where the object has one, which those without then get.
  Owned<NMR::PLib3MFDefaultPropertyHandler> whole;
  check(NMR::lib3mf_object_createdefaultpropertyhandler(made, whole.out()),
        "defaultpropertyhandler");
  check(NMR::lib3mf_defaultpropertyhandler_setcolorrgb(whole.get(), kGrey, kGrey, kGrey),
        "setcolor");
  Owned<NMR::PLib3MFPropertyHandler> handler;
  check(NMR::lib3mf_meshobject_createpropertyhandler(made, handler.out()), "propertyhandler");
  for (std::size_t p = 0; p < colours.size(); ++p) {
    if (!colours[p].colour) continue;
    const auto [red, green, blue] = *colours[p].colour;
    const std::size_t end = p + 1 < colours.size() ? colours[p + 1].first : object.triangles.size();
    for (std::size_t t = colours[p].first; t < end; ++t)
      check(NMR::lib3mf_propertyhandler_setsinglecolorrgb(
                handler.get(), static_cast<std::uint32_t>(t), red, green, blue),
            "setsinglecolor");
  }
}

void add(NMR::PLib3MFModel* model, const ThreeMfObject& object) {
  Owned<NMR::PLib3MFModelMeshObject> made;
  check(NMR::lib3mf_model_addmeshobject(model, made.out()), "addmeshobject");
  check(NMR::lib3mf_object_setnameutf8(made.get(), object.name.c_str()), "setname");
  give_geometry(made.get(), object);
  give_colours(made.get(), object);
  Owned<NMR::PLib3MFModelBuildItem> item;
  check(NMR::lib3mf_model_addbuilditem(model, made.get(), nullptr, item.out()), "addbuilditem");
}

}  // namespace

void load_three_mf() {}

std::string three_mf_bytes(const std::vector<ThreeMfObject>& objects) {
  Owned<NMR::PLib3MFModel> model;
  check(NMR::lib3mf_createmodel(model.out()), "createmodel");
  check(NMR::lib3mf_model_setunit(model.get(), NMR::MODELUNIT_MILLIMETER), "setunit");
  for (const ThreeMfObject& object : objects) add(model.get(), object);
  Owned<NMR::PLib3MFModelWriter> writer;
  check(NMR::lib3mf_model_querywriter(model.get(), "3mf", writer.out()), "querywriter");
  unsigned long long size = 0;
  check(NMR::lib3mf_writer_getstreamsize(writer.get(), &size), "getstreamsize");
  std::string bytes(size, '\0');
  check(NMR::lib3mf_writer_writetobuffer(writer.get(),
                                         reinterpret_cast<std::uint8_t*>(bytes.data()), size),
        "writetobuffer");
  return bytes;
}

}  // namespace blossom::lib3mf
