// SPDX-License-Identifier: LGPL-2.1-or-later
// Models in files: STEP with names, colours, layers and assembly, IGES and BREP.

#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>

#include "adapters/occt/reading.h"
#include "adapters/occt/repairs.h"
#include "adapters/occt/sewing.h"

namespace blossom::occt {

class Model;

/// Where a face of a new part comes from.
struct FaceOrigin {
  TopoDS_Face face;              ///< of the new part
  const Model* model = nullptr;  ///< the face is one of this model's, or a piece of it
  int number = 0;                ///< of that face there
};

/// A solid made of faces of models and of pieces of them.
struct CombinedSolid {
  TopoDS_Solid solid;             ///< in model space
  std::vector<FaceOrigin> faces;  ///< all of its faces
};

/// A part of a model, or an assembly of such, at its place.
struct AssemblyNode {
  std::string name;                 ///< of the instance; that of the part where it has none
  std::string product;              ///< what it is an instance of
  std::string path;                 ///< as `Model::part_paths` has it, of an assembly up to it
  std::vector<int> solids;          ///< of a part: their numbers, in the order of TopExp::MapShapes
  std::vector<int> faces;           ///< likewise
  std::vector<AssemblyNode> parts;  ///< of an assembly
};

/// Faces that two parts have in common, such as the cut between the parts of a split solid.
enum class CommonFaces {
  Keep,
  Copy,  ///< for files that tell names and colours by the shape, see `keeps_names`
};

/// What a user may want to know of a file that was written, in words.
struct WriteNote {
  std::string text;
  bool within_tolerance = false;  ///< a change of shapes that is no more than their tolerances
  bool shapes_lost = false;       ///< faces that the format has no way to say are left out
};

struct Contents;  // of this folder's own

/// A shape with the names, colours, layers, units and assembly that it came with.
class Model {
 public:
  /// An empty model, to which shapes are added.
  Model();
  Model(Model&&) noexcept;
  Model& operator=(Model&&) noexcept;
  ~Model();

  /// A model of the same shapes, so that it shares all faces and edges, with the same names, looks,
  /// layers, unit and assembly; to be changed. It is of no file.
  Model copy() const;

  /// The shape of all parts, in one compound when there are several. Millimetres.
  const TopoDS_Shape& shape() const;

  int face_count() const;

  /// A face by its number, 1-based in the order of TopExp::MapShapes.
  /// throws   BadModel, naming the file and the number, if there is none
  TopoDS_Face face(int number) const;

  /// The file it was read from; empty otherwise.
  const std::filesystem::path& file() const;

  /// The length unit of that file, "MM", "INCH", ...; in memory all is millimetre.
  const std::string& file_unit() const;

  /// What reading its file lost; nothing for a model made in memory.
  const ReadingReport& reading() const;

  /// For each face, by number - 1, its name, or that of its part; empty when neither has one.
  std::vector<std::string> face_names() const;

  /// For each face, by number - 1, where its part is used: the names of instances from the outside
  /// in, as "machine:2/bolt:1"; the part's own name if it is in no assembly.
  std::vector<std::string> part_paths() const;

  /// The parts and assemblies that are in no other one.
  std::vector<AssemblyNode> assembly() const;

  /// The name of the part that a face belongs to; empty if it has none.
  /// throws   BadModel if there is no such face
  std::string part_name(int number) const;

  /// Repairs faces, by number, that were not repaired yet: raises tolerances of edges and vertices
  /// that are less than the distances of curves, where the file states none; makes curves in the
  /// parameters of faces anew that are far off those in space, and those that are missing. Whatever
  /// has to change with them changes, too; what a face becomes does not depend on which were
  /// repaired before. Faces that were replaced or added since count as not repaired.
  /// stop      asked often; ends the work by an exception
  /// returns   what was changed by this call
  /// throws    BadModel if there is no such face
  Repairs repair(const std::vector<int>& faces, const std::function<void()>& stop = {});

  /// The same for all faces, and for edges and vertices of no face.
  Repairs repair(const std::function<void()>& stop = {});

  /// Sews loose faces, which bound no closed solid, into the solids that they close: those of each
  /// part, then all that are still loose (repair/sewn_faces.h). Numbers, names and looks of faces
  /// stay; of parts that become one solid together the part is called like the file. What does not
  /// close, or what Open CASCADE fails on, stays as it is: the answer says so. A model is sewn
  /// once; later calls do nothing and answer the same, unless they ask for more.
  ///
  /// within   the widest gap that is one, model units; without it as the borders' tolerances and
  ///          lengths allow (repair/border_gaps.h)
  /// stop     asked often; ends the work by an exception
  Sewing sew(std::optional<double> within = {}, const std::function<void()>& stop = {},
             Sewable which = Sewable::All);

  /// Whether that was done.
  bool is_sewn() const;

  /// Adds a shape as a part of its own.
  /// colour   red, green, blue in [0, 1], sRGB; empty for none
  void add(const TopoDS_Shape& shape, const std::string& name,
           const std::vector<double>& colour = {});

  /// Adds an assembly of shapes, each a part of it with a name.
  /// throws   BadModel if there is none, or a shape is null
  void add_assembly(const std::vector<std::pair<std::string, TopoDS_Shape>>& parts,
                    const std::string& name);

  /// Adds a shape that was made of other models' faces as a part of its own. Its faces have the
  /// names and colours of those that they come from, names numbered ("Top.1", "Top.2") where a face
  /// is in several pieces; a colour may be that of the face's solid or part.
  /// throws   BadModel if there is no such face
  void add_combined(const TopoDS_Shape& shape, const std::string& name,
                    const std::vector<FaceOrigin>& origins);

  /// Puts pieces in the place of faces, by face number; no pieces takes the face out. All other
  /// faces keep their edges, names and colours; pieces take the face's colour and its name,
  /// numbered ("TopFace.1", "TopFace.2") if there are several. A part that is used several times
  /// is cut only where the face was named, and gets a copy of its own for that.
  ///
  /// Pieces lie in model space and are oriented beside `face(number)`. A solid stays a solid when
  /// its shells stay closed, so when pieces make up their face and keep its border edges; else it
  /// becomes its open shells, one for each connected group of faces. A part without faces goes.
  /// Faces have new numbers afterwards. Areas and volumes that the file gave for changed parts
  /// are dropped.
  /// throws   BadModel if there is no such face or a piece is null; nothing is changed then
  void replace_faces(const std::map<int, std::vector<TopoDS_Face>>& pieces);

  /// Puts solids in the place of all solids of the model. Each goes to the part of its first face
  /// that is this model's; a part that comes out as it was is not touched, nor are its instances,
  /// and one of which nothing comes is taken out. A part that was one solid and falls apart becomes
  /// several at the same place, which share its looks and have its name and those of its instance,
  /// numbered ("Plate.1", "plate:1.1"); a part of several solids stays one part. Names, colours and
  /// layers of faces, shells and solids follow; faces of other models bring their names and
  /// colours. Solids without any face of this model are added as parts of their own. For parts that
  /// are used several times and for areas and volumes see replace_faces.
  /// throws   BadModel if a solid has no faces or an origin is no face
  void replace_solids(const std::vector<CombinedSolid>& solids,
                      CommonFaces common = CommonFaces::Copy);

 private:
  friend class ModelFiles;
  friend std::vector<WriteNote> write_model(const Model& model, const std::filesystem::path& file,
                                            const std::function<void()>& stop);
  friend Contents& contents_of(const Model& model);
  friend class ModelBytes;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Reads STEP, IGES and BREP, in text or binary form, by the content: .step .stp .iges .igs .brep
/// .brp .bin in any case, packed by gzip or zip (.stpZ, .stp.gz, ...), and other endings.
///
/// A STEP or IGES file's length unit is kept for writing. What of a damaged file cannot be read is
/// left out and listed in `reading()`: entities, faces whose surface, curves or points have numbers
/// that are none or weights that are not positive, and what comes after the place where a file is
/// cut off. Nothing is repaired before `Model::repair`. Parts that a STEP file has in other files
/// are read from its own folder; see ReadOptions::other.
/// throws   BadModel if the file is missing, no regular file, empty, of no known format, or holds
///          nothing that can be used; the message names the file, the step and the cause
/// Safe to call from several threads; they wait for each other.
Model read_model(const std::filesystem::path& file, const ReadOptions& options = {});

/// The same for programs that must outlive any file: a child process reads it, and hands over the
/// model as it is there, to the last bit. Names, or faces of damaged entities, are left out if it
/// is these that crash or take more than `reading_allowance`. What a child has read to its end, but
/// cannot hand over, is read here once more. It is read here alone where no process can be made, or
/// where the child uses no processor time for 3 s: it then waits for a lock that another thread of
/// the program held when it was made, which tells nothing of the file.
///
/// options  their `step` is told in the child process
/// stop     asked often; ends the work by an exception
/// throws   as `read_model`; BadModel with the step if nothing can be left out that would help;
///          std::bad_alloc if the child lacks memory, or is killed, as systems do that have none
///          left
Model read_model_in_child(const std::filesystem::path& file, const ReadOptions& options = {},
                          const std::function<void()>& stop = {});

/// Writes by the file's ending, beside the target, and renames when all is on the disk: an
/// interrupted or failed write leaves what was there before, and nothing else if the file system
/// has files without names (most on Linux have). `stop` is asked between steps and before the
/// target is touched; it ends the writing by an exception. Numbers keep 16 digits. Names, colours,
/// layers, dimensions and the assembly go into STEP. IGES has no assemblies: each instance becomes
/// a part, called by the names of instances that lead to it; layers have numbers. BREP has shapes
/// only. A link stays a link, and a device is written to directly.
/// Faces of which an edge has no curve in their parameters are left out of STEP and IGES.
/// returns  what the file that the model was read from has beside shapes and this one has not, and
///          what of shapes had to be written otherwise, or is left out
/// throws   Failure if the file cannot be written, or no face is left; BadModel if the ending is
///          not known
std::vector<WriteNote> write_model(const Model& model, const std::filesystem::path& file,
                                   const std::function<void()>& stop = {});

/// Whether the format of a file, by its ending, has internal edges of faces. Open CASCADE loses
/// them on the way to STEP, and cannot write IGES with them.
/// throws   BadModel if the ending is not known
bool keeps_internal_edges(const std::filesystem::path& file);

/// Whether the format of a file, by its ending, has names and colours. It gives them to shapes, so
/// a face that two parts have in common would carry them in one part only.
/// throws   BadModel if the ending is not known
bool keeps_names(const std::filesystem::path& file);

/// Writes `text` in the same safe way.
void write_text(const std::string& text, const std::filesystem::path& file,
                const std::function<void()>& stop = {});

/// Sends Open CASCADE's messages to stderr, warnings and worse only. Call it once, first.
void quiet_messages();

}  // namespace blossom::occt
