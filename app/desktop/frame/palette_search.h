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

/// The kinds of items that the palette finds by name, besides commands.
enum class ThingKind { person, exercise, session, study, count };

/// One such item, and the place that it leads to.
struct NamedThing {
    QString text;
    QString folded; ///< as forSearch() returns it
    Place place;
};

/// Normalises text for comparison: lower case, without accents. Pure.
QString forSearch(const QString& text);

/// Everything that a person may find, as it was at the time of reading. It is a value and safe to read on any
/// thread.
struct SearchIndex {
    /// Sessions are in the order newest first.
    std::array<std::vector<NamedThing>, static_cast<std::size_t>(ThingKind::count)> things;
    std::vector<core::Error> problems; ///< reading errors; a denied permission is not one
};

/// Who searches, and in which language.
struct SearchQuestion {
    database::Actor actor;
    QString language;
    QLocale locale;
    catalogue::Catalogue catalogue;
};

/// Reads everything that the repositories allow this person to see. Ends early when `cancel` is set.
/// Thread: worker; blocks.
SearchIndex readSearchIndex(const database::Database& database, const SearchQuestion& question,
                            const std::atomic<bool>& cancel);

/// The items of one kind that contain every typed word, those with a word that begins with it first: the best
/// ones, and the number of all.
struct FoundThings {
    std::vector<const NamedThing*> best;
    int all = 0;
};
FoundThings findThings(const SearchIndex& index, ThingKind kind, const QString& typed, int most);

} // namespace chiron::desktop
