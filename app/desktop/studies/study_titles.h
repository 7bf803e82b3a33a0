// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <set>

namespace chiron::desktop {

/// Titles as they are compared: two that differ in capitals, accents or spaces alone look alike in a list.
QString titleForComparison(const QString& title);

/// `title`, or the same with the first number that is free. `taken`: titleForComparison() of each title that there is.
QString freeTitle(const QString& title, const std::set<QString>& taken);

/// What a copy of a study is called until somebody says otherwise: "Tubes (copy)", of a copy "Tubes (copy 2)". Never one that is taken, and never longer than
/// a title may be.
QString copyTitle(const QString& original, const std::set<QString>& taken);

} // namespace chiron::desktop
