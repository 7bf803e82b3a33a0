// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QSet>
#include <QString>
#include <QStringList>

namespace chiron::test {

/// The headings of a Markdown document, and what may be asked of them.
class Document {
public:
    explicit Document(const QString& markdown);

    /// "2.2" has a heading of its own ("### 2.2 Attributes").
    bool hasSection(const QString& number) const;
    /// A heading begins with these words, or the words begin with a heading. Numbers of sections are ignored.
    bool hasHeading(const QString& words) const;
    /// The anchor that GitHub gives one of the headings.
    bool hasAnchor(const QString& anchor) const;
    bool isEmpty() const { return m_headings.isEmpty(); }

private:
    QStringList m_headings; ///< without the marks
};

/// What a text says of the project's documents: "models.md §2.2 and §2.4" or "data.md, Writing".
struct Citation {
    QString document; ///< "models"
    QString section;  ///< "2.2"; empty: none
    QString heading;  ///< "Writing"; empty: none
};
QList<Citation> citationsIn(const QString& text);

/// Targets of the links of a Markdown document that lead into the repository, with their anchor; code is left
/// out.
QStringList relativeLinks(const QString& markdown);

/// How many words a document has, with its code and its tables.
qsizetype wordCount(const QString& markdown);

/// The headings of tables in which more than half of the cells beside the first column are figures: results,
/// which have pages of their own.
QStringList resultTables(const QString& markdown);

/// Paths that a Markdown document names in backticks: with a slash, or with the ending of a file. `<id>` and
/// `*` stand for any name. Left out is what is not in the repository by its nature: build/…, files beside a
/// database (`<file>.lock`), the end of a name (`_setup.cpp`) and what continues a link (`/<id>/scene`).
QStringList pathsNamed(const QString& markdown);

/// The folders and files of the repository.
class PathTree {
public:
    explicit PathTree(const QString& root);
    /// Whether the path is there: seen from the folder of `document`, from the root, or as the end of any
    /// path. A header and its source together may be named without their endings.
    bool has(const QString& named, const QString& document) const;
    qsizetype size() const { return m_paths.size(); }

private:
    void add(const QString& path);

    QSet<QString> m_paths; ///< from the root, endings of C++ files left out as well
    QSet<QString> m_ends;  ///< the same, from every folder on
};

/// The text files of the repository that are ours, relative to its root.
QStringList ownTextFiles(const QString& root);
QString contentOf(const QString& file);

} // namespace chiron::test
