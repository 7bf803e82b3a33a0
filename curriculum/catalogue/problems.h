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
    QString expected; ///< what would have been right
};

/// Faults in the order met; what is checked goes on, so that an author sees them together.
using Problems = std::vector<Problem>;

/// Path of a member: `$.a.b`, or `$.a["odd key"]` where the key is no plain identifier.
QString memberPath(const QString& parent, const QString& key);
QString elementPath(const QString& parent, qsizetype index);

/// A text as messages show it: in quotes, at most 40 characters, control characters as \uXXXX.
QString quoted(const QString& text);

/// `; did you mean "radius_mm"?` for the nearest of `known` within three edits, else nothing.
QString didYouMean(const QString& given, const std::vector<QString>& known);

} // namespace chiron::catalogue
