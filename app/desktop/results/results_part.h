// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/actor.h"

#include <QWidget>

namespace chiron::database {
class Database;
}

namespace chiron::desktop {

class Background;

/// Selects the sessions for a part of the results: those of a person at one level on one class of devices.
struct ResultsQuestion {
    database::PersonId person = 0;
    int level = 0;
    bool felt = true; ///< felt and shown sessions are never pooled
};

/// The part of a person's results that is specific to one exercise. It stands between the curve and the
/// attempts.
/// Thread: GUI.
class ResultsPart : public QWidget {
public:
    using QWidget::QWidget;

    /// Reads and shows the results. Does nothing if the same level is requested again.
    virtual void ask(Background& background, database::Database& database, const database::Actor& actor,
                     const ResultsQuestion& question) = 0;
};

} // namespace chiron::desktop
