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

/// The short name that a title gives for exports and commands: "tubes_of_60_n_m" for "Tubes of 60 N/m".
/// Letters that cannot occur in short names are dropped; empty if nothing is left.
QString shortNameOf(const QString& title);
/// `wanted`, with the first free number appended if it is taken.
QString freeShortName(const QString& wanted, const std::set<QString>& taken);
bool isShortName(const QString& name); ///< lower-case letters, digits and _, a letter first
/// Whether a short name is the title's, perhaps with the number of a copy: "tube_of_60_n_m" and
/// "tube_of_60_n_m_2" are made of "Tube of 60 N/m". Such a name can follow the title; any other was chosen
/// for itself.
bool isMadeOf(const QString& shortName, const QString& title);

/// The initial title of a copy: "Tubes (copy)", or "Tubes (copy 2)" for a copy of a copy. It is never one
/// that is taken, and never longer than a title may be.
QString copyTitle(const QString& original, const std::set<QString>& taken);

} // namespace chiron::desktop
