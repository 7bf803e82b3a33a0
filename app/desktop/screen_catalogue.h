// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/role.h"
#include "desktop/frame/place.h"

#include <QString>
#include <vector>

namespace chiron::desktop {

class AppContext;
class Screen;

/// One line a screen: what it is called, who finds it in the navigation, how it is made.
struct ScreenEntry {
    const char* id;
    const char* title; ///< source text in context "Screens"; translated when shown
    const char* icon;  ///< Breeze name
    std::vector<database::Role> roles; ///< in whose navigation it is; empty: in nobody's
    bool framed = true;                ///< false: the whole window (login, first start)
    Screen* (*make)(AppContext& context, const Place& place);
    bool sitting = false; ///< a session or a study's sitting is done here: nothing else may use the machine
    const char* furtherWords = ""; ///< by which somebody may look for it, with commas between them; source text in context "CommandWords", where each
                                   ///< language has words of its own: they need not say the same
};

/// Every screen of the program, in the order of the navigation.
const std::vector<ScreenEntry>& screenCatalogue();
const ScreenEntry* findScreen(const QString& id);
QString titleOf(const ScreenEntry& entry);

} // namespace chiron::desktop
