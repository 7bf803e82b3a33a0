// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/catalogue.h"
#include "devices/driver_catalogue.h"
#include "session/station.h"
#include "session/training_run.h"

#include <QString>
#include <QVariantMap>
#include <optional>

namespace chiron::desktop {

/// What was chosen on the set-up screen: enough to begin the session, and small enough for a Place.
struct TrainingPlan {
    QString exercise;
    int level = 1;
    const devices::Driver* driver = &devices::usualDriver(devices::MovedBy::person); ///< of the catalogue, never null
    QString operatorName; ///< demonstration
    mechanisms::PolarMap forceMap = mechanisms::PolarMap::exact; ///< demonstration on the gimbal
    QString traceFile;    ///< trace
    session::WorkspaceChoice workspace; ///< mouse
    bool familiarisation = false;
    double practice_s = 0.0; ///< a familiarisation of this length, after which the level itself waits; mouse. 0: none
    int trials = 0; ///< no more than so many: the level is tried, as a familiarisation. 0: all of them
    std::optional<bool> depthOfField; ///< as the person switched it; empty: as the level begins

    bool movedBy(devices::MovedBy mover) const { return driver->movedBy == mover; }
    bool ownHand() const { return movedBy(devices::MovedBy::person); }
    bool practises() const { return practice_s > 0.0 && ownHand(); }
    QVariantMap toMap() const;
    static TrainingPlan fromMap(const QVariantMap& map); ///< what is missing or unknown is as in a new plan
};

/// A level to be tried with one's own hand, in about a minute: a few trials that do not count, and a debrief at their end.
TrainingPlan tryPlan(const std::string& exercise, int level);

/// An expert's demonstration of a level; nothing where this program has none.
std::optional<TrainingPlan> expertPlan(const std::string& exercise, int level);

/// In a place of the training screen, beside its plan: true where nobody has to be asked whether they are ready.
inline constexpr const char* kAtOnce = "at_once";
/// The same: true where a practice of this level has just ended.
inline constexpr const char* kPractised = "practised";
/// In a place of the debrief: true where the person's own session has just ended, by itself or not.
inline constexpr const char* kJustEnded = "just_ended";
/// The person's setting (Settings::ofPerson) that tells that they know this level's ready card.
QString readyKey(const TrainingPlan& plan);

/// The session of a plan, with a seed of its own. A demonstration belongs to the simulated account: it is nobody's score.
/// Reads the trace file, so a worker's task. Failure: as the station's (a trace's names file and row).
core::Result<session::TrainingRequest> requestOf(const TrainingPlan& plan, const catalogue::ExerciseLevel& level);
database::Actor actorOf(const TrainingPlan& plan, const database::Actor& person);

} // namespace chiron::desktop
