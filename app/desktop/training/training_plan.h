// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/catalogue.h"
#include "devices/driver_catalogue.h"
#include "session/station.h"
#include "session/training_run.h"

#include <QString>
#include <QStringList>
#include <QVariantMap>
#include <optional>

namespace chiron::desktop {

/// The choices of the set-up screen: everything needed to start the session, and small enough for a Place.
struct TrainingPlan {
    QString exercise;
    int level = 1;
    /// From the catalogue, never null.
    const devices::Driver* driver = &devices::usualDriver(devices::MovedBy::person);
    QString operatorName; ///< for a demonstration
    /// Of the session; 0: any. Given for the expert's demonstration, which shows how the level is passed.
    std::uint64_t seed = 0;
    /// For a demonstration on a mechanism with several (KinematicsEntry::forceMaps); empty: the usual one.
    QString forceMap;
    QString traceFile;     ///< for a trace
    QStringList addresses; ///< of connected devices, one for each tool (FoundDevice::address); else empty
    session::WorkspaceChoice workspace; ///< for the mouse
    bool familiarisation = false;
    /// For the mouse: a familiarisation of this length, after which the level itself is offered. 0: none.
    double practice_s = 0.0;
    int trials = 0; ///< at most this many trials, to try the level as a familiarisation. 0: all of them.
    std::optional<bool> depthOfField; ///< the person's choice; empty: the level's default

    bool movedBy(devices::MovedBy mover) const { return driver->movedBy == mover; }
    /// Whether a person feels the force. Who watches a demonstration or a recording feels nothing, whatever
    /// the device renders.
    bool feltByPerson() const { return ownHand() && driver->deviceClass == devices::DeviceClass::felt; }
    bool ownHand() const { return movedBy(devices::MovedBy::person); }
    /// Whether the person moves the tools with mouse and keyboard.
    bool byPointer() const { return ownHand() && driver->hand == devices::HandKind::mouseAndKeyboard; }
    bool practises() const { return practice_s > 0.0 && ownHand(); }
    QVariantMap toMap() const;
    static TrainingPlan fromMap(const QVariantMap& map); ///< missing or unknown entries get the default
};

/// A plan to try a level with one's own hand for about a minute: a few trials that do not count, and a
/// debrief at their end.
TrainingPlan tryPlan(const std::string& exercise, int level);

/// A plan for the scripted expert's demonstration of a level; empty if the program has none.
std::optional<TrainingPlan> expertPlan(const std::string& exercise, int level);

/// Parameter of the training screen's place, in addition to the plan: true if the session starts without the
/// ready card.
inline constexpr const char* kAtOnce = "at_once";
/// Likewise: true if a practice of this level has just ended.
inline constexpr const char* kPractised = "practised";
/// Parameter of the debrief's place: true if the person's own session has just ended, by itself or not.
inline constexpr const char* kJustEnded = "just_ended";
/// Key of the person's setting (Settings::ofPerson) that says that they know this level's ready card.
QString readyKey(const TrainingPlan& plan);

/// The session request of a plan, with a new seed. A demonstration belongs to the simulated account and is
/// nobody's score. It reads the trace file.
/// Thread: worker; blocks.
/// Errors: those of the station; an error in a trace names file and row.
core::Result<session::TrainingRequest> requestOf(const TrainingPlan& plan,
                                                 const catalogue::ExerciseLevel& level);
database::Actor actorOf(const TrainingPlan& plan, const database::Actor& person);

} // namespace chiron::desktop
