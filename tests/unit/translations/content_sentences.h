// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace chiron::test {

/// A text in English with its translation, and where it stands: the context of a catalogue, or a path in the
/// content ("content/exercises/palpation/levels/visible_lump/title").
struct Sentence {
    QString place;
    QString source;
    QString translation;
};

/// Every text of the content with its translation of a language. `folder`: that of the content. What is
/// translated but stands nowhere in English is added to `faults`.
std::vector<Sentence> contentSentences(const QString& folder, const QString& language, QStringList& faults);

} // namespace chiron::test
