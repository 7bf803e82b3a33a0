// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QVariantMap>

namespace chiron::desktop {

/// Where a person is in the program: the id of a screen and what it shows ({"session": 7, "at_s": 12.5}). It
/// is a value that contains everything needed to open the screen again (for Back, a new theme or a new
/// language).
struct Place {
    QString screen;
    QVariantMap parameters;
    bool operator==(const Place&) const = default;
};

} // namespace chiron::desktop
