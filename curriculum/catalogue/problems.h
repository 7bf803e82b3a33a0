// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>
#include <vector>

namespace chiron::catalogue {

/// One fault in a content file.
struct Problem {
    QString path;     ///< JSON path, "$" is the document
    QString found;    ///< the value, or "missing", "unknown key" ...
    QString expected; ///< what would have been valid
};

/// Faults in the order in which they were found. Checking continues after a fault, so that an author sees all
/// of them together.
using Problems = std::vector<Problem>;

/// Returns the path of a member: `$.a.b`, or `$.a["odd key"]` if the key is not a plain identifier.
QString memberPath(const QString& parent, const QString& key);
QString elementPath(const QString& parent, qsizetype index);

/// Returns a text as messages show it: in quotes, at most 40 characters, control characters as \uXXXX.
QString quoted(const QString& text);

/// Returns `; did you mean "radius_mm"?` for the nearest of `known` within three edits, else an empty text.
QString didYouMean(const QString& given, const std::vector<QString>& known);

} // namespace chiron::catalogue
