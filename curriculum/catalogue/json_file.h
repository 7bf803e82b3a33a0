// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/problems.h"
#include "core/result.h"

#include <QByteArray>
#include <QHash>
#include <QJsonObject>
#include <QString>

namespace chiron::catalogue {

/// A strictly parsed JSON file of the content. It remembers the place of every value, so that faults found
/// later can name line and column.
///
/// It is stricter than Qt's parser: UTF-8 only, an object at the top, no key twice in one object, only
/// numbers and escapes of RFC 8259, at most 16 levels deep and at most 1 MiB long (more if the caller says
/// so).
class JsonFile {
public:
    /// Errors: notFound; badInput as `file:line:column: ...: expected ...`.
    static core::Result<JsonFile> read(const QString& path, qsizetype mebibytes = 1);
    static core::Result<JsonFile> parse(const QByteArray& bytes, const QString& name,
                                        qsizetype mebibytes = 1);
    /// Size limit for a mesh with as many vertices and triangles as content may hold
    /// (simulation::kMostStoredTriangles), or for a level with such a mesh.
    static constexpr qsizetype kMeshMebibytes = 8;

    const QJsonObject& root() const { return m_root; }
    const QString& name() const { return m_name; }

    /// Returns all problems as one Error, one line per problem (at most 20): `file:line:column: $.path:
    /// found: expected ...`. The place of something missing is that of the object or array that should hold
    /// it.
    core::Error error(const Problems& problems) const;

private:
    QString m_name;
    QByteArray m_bytes;
    QJsonObject m_root;
    QHash<QString, qsizetype> m_offsets; ///< JSON path -> byte offset
};

} // namespace chiron::catalogue
