// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/actor.h"

#include <QWidget>

namespace chiron::database {
class Database;
}

namespace chiron::desktop {

class Background;

/// Of which sessions a part of the results is: those of a person at one level, on one class of devices.
struct ResultsQuestion {
    database::PersonId person = 0;
    int level = 0;
    bool felt = true; ///< felt and shown are never pooled
};

/// What the results of a person show of one exercise alone, between curve and attempts. GUI thread.
class ResultsPart : public QWidget {
public:
    using QWidget::QWidget;

    /// Reads and shows this; nothing anew where the same level is asked for again.
    virtual void ask(Background& background, database::Database& database, const database::Actor& actor,
                     const ResultsQuestion& question) = 0;
};

} // namespace chiron::desktop
