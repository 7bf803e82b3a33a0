// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/languages.h"

#include <vector>

namespace chiron::tests {

/// The ids of all languages in the order of core/languages.h, so that a new one is looked at as well; each
/// ends with a zero, as names of rows have to.
inline std::vector<const char*> languageIds() {
    std::vector<const char*> ids;
    for (const core::Language& language : core::kLanguages)
        ids.push_back(language.id.data());
    return ids;
}

/// All but English, the first.
inline std::vector<const char*> otherLanguages() {
    std::vector<const char*> ids = languageIds();
    ids.erase(ids.begin());
    return ids;
}

/// For tests that leave the program in the last one, in which the others expect it.
inline std::vector<const char*> languagesEnglishLast() {
    std::vector<const char*> ids = otherLanguages();
    ids.push_back(core::kLanguages.front().id.data());
    return ids;
}

} // namespace chiron::tests
