// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QVariantMap>

namespace chiron::desktop {

/// Where somebody is in the program: a screen's id and what it shows ({"session": 7, "at_s": 12.5}). A value; everything
/// that a screen needs to be opened again (back, a new theme or language) is in it.
struct Place {
    QString screen;
    QVariantMap parameters;
    bool operator==(const Place&) const = default;
};

} // namespace chiron::desktop
