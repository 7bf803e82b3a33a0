// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::core {

/// A language of the interface and of the content.
struct Language {
    std::string_view id;     ///< ISO 639 code, used in file names: "de"
    std::string_view name;   ///< in the language itself, so that its readers recognise it
    std::string_view locale; ///< for the format of numbers and dates: "de_DE"
};

/// All languages. English is first: texts are written in it, and it is shown where a translation is missing.
/// A new language needs a line here and the files that docs/guides/add-a-language.md names.
inline constexpr std::array kLanguages{Language{"en", "English", "en_GB"}, Language{"de", "Deutsch", "de_DE"},
                                       Language{"el", "Ελληνικά", "el_GR"}};

/// Returns the language with this id; English if there is none.
constexpr const Language& languageOf(std::string_view id) noexcept {
    for (const Language& language : kLanguages)
        if (language.id == id)
            return language;
    return kLanguages.front();
}

/// Returns the ids of all languages in the order of kLanguages.
inline std::vector<std::string> languageIds() {
    std::vector<std::string> ids;
    for (const Language& language : kLanguages)
        ids.emplace_back(language.id);
    return ids;
}

/// "en, de, el".
inline std::string listOfLanguages() {
    std::string list;
    for (const Language& language : kLanguages)
        list.append(list.empty() ? "" : ", ").append(language.id);
    return list;
}

} // namespace chiron::core
