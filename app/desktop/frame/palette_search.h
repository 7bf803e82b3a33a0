// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/catalogue.h"
#include "database/actor.h"
#include "database/database.h"
#include "desktop/frame/place.h"

#include <QString>
#include <array>
#include <atomic>
#include <vector>

namespace chiron::desktop {

/// What the palette finds by name, beside commands.
enum class ThingKind { person, exercise, session, study, count };

/// One of them, and where it leads.
struct NamedThing {
    QString text;
    QString folded; ///< as forSearch() makes it
    Place place;
};

/// Letters as they are compared: lower case, without accents. Pure.
QString forSearch(const QString& text);

/// Everything that somebody may find, as it was when it was read. A value; safe to read on any thread.
struct SearchIndex {
    std::array<std::vector<NamedThing>, static_cast<std::size_t>(ThingKind::count)> things; ///< sessions newest first
    std::vector<core::Error> problems; ///< what could not be read; a refusal is none
};

/// For whom and in which language.
struct SearchQuestion {
    database::Actor actor;
    QString language;
    QLocale locale;
    catalogue::Catalogue catalogue;
};

/// Reads all of it, as far as the repositories let this person. Blocking: a worker's task. Ends early when `cancel` is set.
SearchIndex readSearchIndex(const database::Database& database, const SearchQuestion& question, const std::atomic<bool>& cancel);

/// Those of one kind that have every typed word in them, the beginnings of words first; some, and how many there are in all.
struct FoundThings {
    std::vector<const NamedThing*> best;
    int all = 0;
};
FoundThings findThings(const SearchIndex& index, ThingKind kind, const QString& typed, int most);

} // namespace chiron::desktop
