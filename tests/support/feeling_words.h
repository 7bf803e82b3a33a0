// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRegularExpression>
#include <QString>
#include <QtGlobal>

#include <array>

namespace chiron::tests {

/// What a text says of feeling, in one language of the program (experience.md, Force that is shown, not
/// felt). A language that is added needs its line.
struct FeelingWords {
    const char* language;
    const char* feels;    ///< words of what a hand feels
    const char* palpates; ///< words of palpating, which name the task of one exercise and feeling elsewhere
    const char* label;    ///< names the class of a device whose force is not felt; allowed everywhere
};

inline constexpr std::array kFeelingWords{
    FeelingWords{"en", "\\bfeel|\\bfelt\\b|\\bby touch\\b|\\b(?:sense|means) of touch\\b", "\\bpalpat\\w+",
                 "not felt"},
    FeelingWords{"de", "fühl|spür|\\bertast|\\btastend|tastsinn", "\\btasten Sie\\b|\\babtast|\\bbetast",
                 "nicht gefühlt"},
    FeelingWords{"el", "νιώθ|νιώσ|ένιω|νοιώ|αισθάν|αισθαν|αισθητ(?!ήρ)|αίσθησ|αισθήσ|\\bαφή(?:ς|ν)?\\b",
                 "ψηλαφ", "δεν γίνεται αισθητ(?:ή|ό)"}};

/// Returns the first words of feeling in a text; empty if there are none. `palpation`: the text belongs to
/// the exercise of that name.
inline QString feelingIn(QString text, const QString& language, bool palpation = false) {
    const auto pattern = [](const QString& words) {
        return QRegularExpression(words, QRegularExpression::CaseInsensitiveOption |
                                             QRegularExpression::UseUnicodePropertiesOption);
    };
    for (const FeelingWords& words : kFeelingWords) {
        if (language != QLatin1String(words.language))
            continue;
        text.remove(pattern(QString::fromUtf8(words.label)));
        QString all = QString::fromUtf8(words.feels);
        if (!palpation)
            all += QLatin1Char('|') + QString::fromUtf8(words.palpates);
        return pattern(all).match(text).captured();
    }
    qFatal("feeling_words.h has no words of the language \"%s\"", qPrintable(language));
}

} // namespace chiron::tests
