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

/// For a kind of exercise whose parameters hold an object: in its schema
///   "tube": {"$ref": "object_attributes.json", "default": {"object": "fallopian_tube"}, "description": "..."}
/// in a level `"tube": "ovary"` or `"tube": {"object": "ovary", "friction": 0.1}`; in the resolved document all numbers stand
/// there, so that an object edited later changes no stored session. This reads that resolved member: what is not there keeps
/// the struct's default (content stored before the key was made), an unknown key is a problem. mm, g, µm there, SI here.
simulation::ObjectAttributes readObject(const ObjectReader& json);

/// What no single key's range can say: a share without a time constant or the other way round; a micro-height too steep for
/// its wavelength. Whether a level needs a mass or a stiffness is its own check.
void checkObject(const simulation::ObjectAttributes& object, const QString& path, Problems& problems);

/// The same for a mesh: `"$ref": "mesh_source.json"`, `"default": {"mesh": "dome"}`; content/meshes.
simulation::MeshSource readMesh(const ObjectReader& json);

/// stored: whole triples, indices of vertices that are there, and then a surface as importMesh() checks it (closed, one way
/// round, each triangle with an area); others: no triangles of their own, bumps of four edges or more.
void checkMesh(const simulation::MeshSource& mesh, const QString& path, Problems& problems);

} // namespace chiron::catalogue
