// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::core {

/// A language of the interface and of the content.
struct Language {
    std::string_view id;     ///< ISO 639, as files are named after it: "de"
    std::string_view name;   ///< in its own words, so that whoever reads it finds it
    std::string_view locale; ///< how numbers and dates are written: "de_DE"
};

/// All of them. English is first: texts are written in it, and it is shown where a translation is missing. A new language is a line here and
/// the files that docs/guides/add-a-language.md names.
inline constexpr std::array kLanguages{Language{"en", "English", "en_GB"}, Language{"de", "Deutsch", "de_DE"}, Language{"el", "Ελληνικά", "el_GR"}};

/// What a language of this id is like; English for an id that there is not.
constexpr const Language& languageOf(std::string_view id) noexcept {
    for (const Language& language : kLanguages)
        if (language.id == id)
            return language;
    return kLanguages.front();
}

/// Their ids, in that order.
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
