// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/content_texts.h"
#include "catalogue/named_kinds.h"
#include "catalogue/object_content.h"
#include "catalogue/schema.h"
#include "catalogue/tissue_content.h"
#include "core/result.h"

#include <QJsonObject>
#include <QString>
#include <map>
#include <vector>

namespace chiron::catalogue {

/// The content that parameters may name: the objects of content/objects, the meshes of content/meshes and the
/// tissues of content/tissues. Each file is read once and checked by itself. A missing folder counts as
/// empty.
class NamedContent {
public:
    /// Errors: badInput for a fault in one of the files, with its place.
    static core::Result<NamedContent> read(const QString& directory,
                                           const std::vector<std::string>& languages = core::languageIds());

    /// Returns `parameters` with every named item filled in. A member whose schema has a key "object"
    /// ("mesh", "tissue") may be given as a name or as an object with that key; it becomes the numbers of the
    /// named item, overridden by the numbers given. A member that is not given takes its schema's default,
    /// which is filled in the same way. Paths in `problems` are below `path`.
    QJsonObject filledIn(const QJsonObject& parameters, const Schema& schema, const QString& path,
                         Problems& problems) const;

    const std::vector<ContentObject>& objects() const { return m_objects; }
    const std::vector<ContentMesh>& meshes() const { return m_meshes; }
    const std::vector<ContentTissue>& tissues() const { return m_tissues; }
    const std::vector<MissingText>& missing() const { return m_missing; }

private:
    using Named = std::map<QString, QJsonObject>;

    core::Result<void> readFolder(const QString& directory, const std::vector<std::string>& languages,
                                  const NamedKind& kind);
    core::Result<void> readNamed(const QString& path, const NamedKind& kind, const Schema& file,
                                 const Schema& content, ContentTexts& texts);

    std::map<QString, Named> m_named; ///< "object", "mesh", "tissue" → name → its numbers as given
    std::vector<ContentObject> m_objects;
    std::vector<ContentMesh> m_meshes;
    std::vector<ContentTissue> m_tissues;
    std::vector<MissingText> m_missing;
};

} // namespace chiron::catalogue
