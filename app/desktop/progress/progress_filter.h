// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/group_standing.h"

#include <QDateTime>
#include <QString>
#include <QVariantMap>

namespace chiron::desktop {

/// Which people of the group are asked for.
enum class GroupPart { everybody, toReview, notLately, notAllPassed };

/// What the overview of a group is narrowed to. A value; travels in a Place as a map.
struct ProgressFilter {
    static constexpr int kLately_days = 14;

    QString names; ///< parts between commas: whoever's name has all words of one of them
    GroupPart part = GroupPart::everybody;

    bool operator==(const ProgressFilter&) const = default;
    bool isEmpty() const { return *this == ProgressFilter{}; }
    bool matches(const session::PersonStanding& person, const QDateTime& now) const;
    QVariantMap toMap() const;
    static ProgressFilter fromMap(const QVariantMap& map); ///< what is missing or unknown stays open
};

} // namespace chiron::desktop
