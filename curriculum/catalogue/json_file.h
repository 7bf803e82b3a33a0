// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/problems.h"
#include "core/result.h"

#include <QByteArray>
#include <QHash>
#include <QJsonObject>
#include <QString>

namespace chiron::catalogue {

/// A JSON file of the content: parsed strictly, with the place of every value, so that faults found later can
/// name line and column.
///
/// Strict beyond Qt's parser: UTF-8 only, an object at the top, no key twice in one object, numbers and
/// escapes of RFC 8259 only, at most 16 levels deep and 1 MiB long (more where a caller says so).
class JsonFile {
public:
    /// Failure (notFound, badInput): `file:line:column: ...: expected ...`.
    static core::Result<JsonFile> read(const QString& path, qsizetype mebibytes = 1);
    static core::Result<JsonFile> parse(const QByteArray& bytes, const QString& name, qsizetype mebibytes = 1);
    /// So large is a mesh of as many vertices and triangles as content may hold (simulation::kMostStoredTriangles), or a level with one.
    static constexpr qsizetype kMeshMebibytes = 8;

    const QJsonObject& root() const { return m_root; }
    const QString& name() const { return m_name; }

    /// All problems as one Error, a line each (at most 20): `file:line:column: $.path: found: expected ...`.
    /// The place of something missing is that of what should hold it.
    core::Error error(const Problems& problems) const;

private:
    QString m_name;
    QByteArray m_bytes;
    QJsonObject m_root;
    QHash<QString, qsizetype> m_offsets; ///< JSON path -> byte offset
};

} // namespace chiron::catalogue
