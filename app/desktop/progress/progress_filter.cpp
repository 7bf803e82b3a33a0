// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/progress/progress_filter.h"

#include "desktop/frame/palette_search.h"
#include "desktop/sessions/session_words.h"

#include <QStringList>
#include <algorithm>

namespace chiron::desktop {

namespace {

constexpr const char* kParts[] = {"everybody", "to_review", "not_lately", "not_all_passed"};
const QString kNames = QStringLiteral("names");
const QString kPart = QStringLiteral("part");

bool isNamed(const QString& folded, const QString& part) {
    const QStringList words = part.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    return std::all_of(words.begin(), words.end(),
                       [&folded](const QString& word) { return folded.contains(word); });
}

} // namespace

bool ProgressFilter::matches(const session::PersonStanding& person, const QDateTime& now) const {
    const QStringList parts = forSearch(names).split(QLatin1Char(','), Qt::SkipEmptyParts);
    const QString folded = forSearch(QString::fromStdString(person.name));
    if (!parts.isEmpty() && std::none_of(parts.begin(), parts.end(), [&folded](const QString& each) {
            return !each.trimmed().isEmpty() && isNamed(folded, each);
        }))
        return false;
    switch (part) {
    case GroupPart::everybody:
        return true;
    case GroupPart::toReview:
        return person.toReview > 0;
    case GroupPart::notLately:
        return !person.latest || SessionWords::timeOf(person.latest->startedUtc) < now.addDays(-kLately_days);
    case GroupPart::notAllPassed:
        return !person.allPassed();
    }
    return true;
}

QVariantMap ProgressFilter::toMap() const {
    QVariantMap map;
    if (!names.isEmpty())
        map.insert(kNames, names);
    if (part != GroupPart::everybody)
        map.insert(kPart, QLatin1String(kParts[static_cast<int>(part)]));
    return map;
}

ProgressFilter ProgressFilter::fromMap(const QVariantMap& map) {
    ProgressFilter filter;
    filter.names = map.value(kNames).toString();
    const auto found = std::find(std::begin(kParts), std::end(kParts), map.value(kPart).toString());
    if (found != std::end(kParts))
        filter.part = static_cast<GroupPart>(found - std::begin(kParts));
    return filter;
}

} // namespace chiron::desktop
