// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/object_reader.h"
#include "simulation/attributes/object_attributes.h"
#include "simulation/geometry/mesh/mesh_source.h"

namespace chiron::catalogue {

/// An object of content/objects.
struct ContentObject {
    std::string id; ///< file name without .json
    Translated title;
    std::string source; ///< where its numbers come from, or that they are assumptions
    simulation::ObjectAttributes attributes;
};

/// A mesh of content/meshes.
struct ContentMesh {
    std::string id;
    Translated title;
    std::string source;
    simulation::MeshSource mesh;
};

/// Reads an object from the parameters of an exercise. The exercise's schema declares the member as
///   "tube": {"$ref": "object_attributes.json", "default": {"object": "fallopian_tube"}, "description":
///   "..."}
/// and a level gives `"tube": "ovary"` or `"tube": {"object": "ovary", "friction": 0.1}`. The resolved
/// document contains all the numbers, so that editing an object later changes no stored session. This
/// function reads that resolved member. A key that is absent keeps the struct's default (the content was
/// stored before the key existed); an unknown key is a problem.
/// Unit: mm, g and µm in the JSON; SI in the result.
simulation::ObjectAttributes readObject(const ObjectReader& json);

/// Checks what the range of a single key cannot express: a recovery share without a time constant or the
/// reverse, and roughness that is too steep for its wavelength. Whether a level needs a mass or a stiffness
/// is for the level's own check.
void checkObject(const simulation::ObjectAttributes& object, const QString& path, Problems& problems);

/// Reads a mesh (content/meshes) in the same way: `"$ref": "mesh_source.json"`, `"default": {"mesh":
/// "dome"}`.
simulation::MeshSource readMesh(const ObjectReader& json);

/// Checks a mesh. A stored mesh must have whole triples and indices of vertices that exist, and then form a
/// surface that importMesh() accepts (closed, consistently oriented, no triangle without area). Other shapes
/// must have no triangles of their own, and bumps of at least four edge lengths.
void checkMesh(const simulation::MeshSource& mesh, const QString& path, Problems& problems);

} // namespace chiron::catalogue
