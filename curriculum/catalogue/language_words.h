// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::catalogue {

/// The words of a language that the program stores or recognises: translations/words/<language>.json. What it
/// shows is in the language's catalogue instead (translations/chiron_<language>.ts).
struct LanguageWords {
    /// What people write in a list of people, by the key of what it means ("login_name", "trainee").
    struct Roster {
        std::map<QString, QStringList> headings;
        std::map<QString, QStringList> roles;
    };
    /// What texts of a study say about its settings. "*" stands for any ending of a word.
    struct Claims {
        std::map<int, QStringList> numbers; ///< the words for 1, 2, 3 and 4
        QStringList objects, trials, seconds;
        QStringList criterionThreeOfFour;
        QStringList objectsNotSeen, objectsSeen;
        QStringList timeNotLimited;
    };

    std::string language;    ///< "de"
    std::string pilotPrefix; ///< before the title of a study that is tried: "Probelauf: "
    Roster roster;
    Claims claims;
};

/// Reads the words of `language` from the text of its file.
/// Errors: badInput, with file, line and key of everything that is missing, unknown, empty or of another type
/// (translations/words/schema).
core::Result<LanguageWords> readLanguageWords(const std::string& language, const QByteArray& json);

/// Returns the words of all languages in the order of core::kLanguages. They travel inside the program and
/// are read at the first call. A fault in them is a fault of the build: it ends the program with the error of
/// readLanguageWords().
/// Thread: any.
const std::vector<LanguageWords>& languageWords();

/// Returns the words of this language; those of English if there is no such language.
const LanguageWords& wordsOfLanguage(std::string_view language);

} // namespace chiron::catalogue
