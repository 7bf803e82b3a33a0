// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/repositories/session_types.h"
#include "desktop/exercise_face.h"
#include "desktop/playback/playback_data.h"
#include "report/report_data.h"
#include "session/session_setup.h"
#include "session/session_view.h"
#include "session/worst_moment.h"

#include <atomic>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace chiron::desktop {

/// The part of a debrief that is shown at once. It comes from stored rows alone; no recording is read for it.
struct DebriefHead {
    database::SessionRecord record; ///< with the person's name as the screens show it
    session::SessionSetup setup;
    const ExerciseFace* face = nullptr; ///< of its exercise; never null once loaded
    report::ReportData report;          ///< facts and metrics, without samples
    /// Values by metric of the same person's previous attempt at this level, on a device of the same class.
    /// Empty if there was none.
    std::map<std::string, double> before;
    std::vector<NamedComment> comments; ///< in order of writing; available even without a recording
    /// Names of those who voided the session or took that back.
    std::map<database::PersonId, std::string> deciders;
};

/// A comment on a session, and the moment that it refers to.
struct CommentAtMoment {
    NamedComment named;
    /// Time in the recording; empty if it concerns the whole session, or if the recording was not read.
    std::optional<double> t_s;
};

/// The part of a debrief that has to be read from the recording, which takes some tenths of a second longer.
struct DebriefDetails {
    DebriefReading part; ///< specific to this exercise; if it could not be read, the rest still holds
    report::ForceFacts force;
    std::optional<session::WorstMoment> worst;
    std::vector<session::WorstMoment> missed; ///< one for each missed pass mark that has a moment
    double duration_s = 0.0;
    std::vector<CommentAtMoment> comments;      ///< by time, those on the whole session first
    std::vector<session::PlaybackTrial> trials; ///< to say in which trial a comment lies
};

/// Key of the person's setting (Settings::ofPerson) for the number of comments on a session that they have
/// seen.
QString commentsSeenKey(database::SessionId session);

/// Reads the stored rows of a debrief.
/// Thread: worker; blocks.
/// Errors: those of the repositories.
core::Result<DebriefHead> loadDebriefHead(database::Connection& connection, const database::Actor& actor,
                                          database::SessionId session, const std::string& language);
/// Reads the recording of a session for its debrief.
/// Thread: worker; blocks.
/// Errors: those of the reader; doesNotHold naming a damaged chunk; cancelled.
core::Result<DebriefDetails> loadDebriefDetails(database::Connection& connection,
                                                const database::Actor& actor, database::SessionId session,
                                                const std::atomic<bool>& cancelled);
/// The same from a session that is open already; decodes its recording only if nothing has done so yet.
core::Result<DebriefDetails> debriefDetailsOf(session::SessionView& session, database::Connection& connection,
                                              const database::Actor& actor,
                                              const std::atomic<bool>& cancelled);
/// Reads everything that the printed report needs.
/// Thread: worker; blocks.
/// Errors: as for loadDebriefDetails().
core::Result<report::ReportData> loadReport(database::Connection& connection, const database::Actor& actor,
                                            database::SessionId session, const std::string& language);

} // namespace chiron::desktop
