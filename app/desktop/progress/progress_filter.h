// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/group_standing.h"

#include <QDateTime>
#include <QString>
#include <QVariantMap>

namespace chiron::desktop {

/// The part of the group that is selected.
enum class GroupPart { everybody, toReview, notLately, notAllPassed };

/// The filter of the group overview. A value; a Place carries it as a map.
struct ProgressFilter {
    static constexpr int kLately_days = 14;

    QString names; ///< parts separated by commas; a name matches if it contains all words of one part
    GroupPart part = GroupPart::everybody;

    bool operator==(const ProgressFilter&) const = default;
    bool isEmpty() const { return *this == ProgressFilter{}; }
    bool matches(const session::PersonStanding& person, const QDateTime& now) const;
    QVariantMap toMap() const;
    static ProgressFilter fromMap(const QVariantMap& map); ///< missing or unknown entries keep their default
};

} // namespace chiron::desktop
