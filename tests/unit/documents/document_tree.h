// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
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

/// The text files of the repository that are ours, relative to its root.
QStringList ownTextFiles(const QString& root);
QString contentOf(const QString& file);

} // namespace chiron::test
