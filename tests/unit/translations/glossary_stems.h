// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "unit/translations/content_sentences.h"

#include <QHash>
#include <QRegularExpression>
#include <QString>
#include <QStringList>
#include <vector>

namespace chiron::test {

/// Tells which terms of the glossary a sentence has in English and lacks in the translation. It is read from
/// glossary_stems.txt, which explains itself.
class GlossaryStems {
public:
    /// Lines that cannot be read are added to `faults`.
    GlossaryStems(const QString& path, QStringList& faults);

    /// The terms that a translation into `language` lacks.
    QStringList missingIn(const Sentence& sentence, const QString& language);
    int found() const { return m_found; } ///< terms seen so far in all sentences
    /// The words and texts listed as exceptions of this language that no sentence so far has needed.
    QStringList unused(const QString& language) const;

    /// Whether a text has a stem of the term that has this form in English; false if there is no such term.
    bool has(const QString& form, const QString& text, const QString& language) const;
    QStringList firstForms() const; ///< of each term
    QStringList forms() const;

private:
    struct Term {
        QStringList forms;
        QHash<QString, QStringList> stems; ///< by language
    };
    /// A form of a term, or other words (term: -1).
    struct Form {
        QString words;
        QRegularExpression pattern;
        int term = -1;
        QStringList usedIn{}; ///< languages
    };
    struct Exception {
        QStringList languages;
        QStringList terms;
        QString place;
        QString beginning;
        QStringList usedIn{};
    };
    void readLine(const QString& line, QStringList& faults);
    void addForm(const QString& words, int term);
    bool excused(const Sentence& sentence, const QString& term, const QString& language);

    std::vector<Term> m_terms;
    std::vector<Form> m_forms; ///< the longest first
    std::vector<Exception> m_exceptions;
    int m_found = 0;
};

} // namespace chiron::test
