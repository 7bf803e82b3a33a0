// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <set>

namespace chiron::desktop {

/// Normalises a title for comparison, because titles that differ only in case, accents or spaces look alike
/// in a list.
QString titleForComparison(const QString& title);

/// Returns `title`, with the first free number appended if it is taken. `taken`: titleForComparison() of each
/// existing title.
QString freeTitle(const QString& title, const std::set<QString>& taken);

/// The initial title of a copy: "Tubes (copy)", or "Tubes (copy 2)" for a copy of a copy. It is never one
/// that is taken, and never longer than a title may be.
QString copyTitle(const QString& original, const std::set<QString>& taken);

} // namespace chiron::desktop
