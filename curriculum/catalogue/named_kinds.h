// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <array>

namespace chiron::catalogue {

/// One kind of content that parameters can name: its files, and how a parameter refers to one of them.
struct NamedKind {
    const char* key;           ///< with which parameters name it; also the name of its file's schema
    const char* folder;        ///< in the content folder
    const char* member;        ///< member of its file that holds the numbers
    const char* contentSchema; ///< schema of those numbers
    QByteArray (*schema)();    ///< returns the bytes of its file, made from the rows of the numbers
};

QByteArray objectAttributesSchema(); ///< object_content.cpp
QByteArray meshSourceSchema();       ///< mesh_content.cpp
QByteArray tissuePropertiesSchema(); ///< tissue_content.cpp

inline constexpr NamedKind kNamedObject{"object", "objects", "attributes", "object_attributes",
                                        &objectAttributesSchema};
inline constexpr NamedKind kNamedMesh{"mesh", "meshes", "shape", "mesh_source", &meshSourceSchema};
inline constexpr NamedKind kNamedTissue{"tissue", "tissues", "properties", "tissue_properties",
                                        &tissuePropertiesSchema};
inline constexpr std::array kNamedKinds{kNamedObject, kNamedMesh, kNamedTissue};

} // namespace chiron::catalogue
