// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/role.h"
#include "desktop/frame/place.h"

#include <QString>
#include <vector>

namespace chiron::desktop {

class AppContext;
class Screen;

/// One entry per screen: its title, the roles that find it in the navigation, and its constructor.
struct ScreenEntry {
    const char* id;
    const char* title;                 ///< source text in context "Screens"; translated when shown
    const char* icon;                  ///< Breeze name
    std::vector<database::Role> roles; ///< roles whose navigation shows it; empty: none
    bool framed = true;                ///< false: it fills the whole window (login, first start)
    Screen* (*make)(AppContext& context, const Place& place);
    /// A training session or study session runs here: nothing else may use the computer.
    bool sitting = false;
    /// Synonyms for the command search, separated by commas. Source text in context "CommandWords", where
    /// each language has its own words, which need not be translations of each other.
    const char* furtherWords = "";
};

/// Every screen of the program, in the order of the navigation.
const std::vector<ScreenEntry>& screenCatalogue();
/// Returns whether somebody with these roles finds the screen in the navigation and among the commands.
bool finds(const database::RoleSet& roles, const ScreenEntry& entry);
const ScreenEntry* findScreen(const QString& id);
QString titleOf(const ScreenEntry& entry);

} // namespace chiron::desktop
