// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/repositories/session_types.h"
#include "desktop/exercise_face.h"
#include "desktop/playback/playback_data.h"
#include "report/report_data.h"
#include "session/session_setup.h"
#include "session/worst_moment.h"

#include <atomic>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace chiron::desktop {

/// What a debrief shows at once: stored rows alone, no recording is read for it.
struct DebriefHead {
    database::SessionRecord record; ///< with its person's name as screens call them
    session::SessionSetup setup;
    const ExerciseFace* face = nullptr; ///< of its exercise; never null once loaded
    report::ReportData report; ///< facts and metrics; no samples
    /// The same person's attempt at this level before this one, on a device of the same class: its values by metric. Empty: none.
    std::map<std::string, double> before;
    std::vector<NamedComment> comments; ///< as written; there without a recording, too
    std::map<database::PersonId, std::string> deciders; ///< what those are called who voided it and counted it again
};

/// What somebody wrote about a session, and when in it.
struct CommentAtMoment {
    NamedComment named;
    std::optional<double> t_s; ///< on the recording's time; empty: about the whole session, or the recording was not read
};

/// What has to be read from the recording, some tenths of a second later.
struct DebriefDetails {
    DebriefReading part; ///< of this session's exercise alone; where it was lost the rest holds
    report::ForceFacts force;
    std::optional<session::WorstMoment> worst;
    double duration_s = 0.0;
    std::vector<CommentAtMoment> comments; ///< by time; those on the whole session first
    std::vector<session::PlaybackTrial> trials; ///< to say where in them a comment stands
};

/// The person's setting (Settings::ofPerson) that tells how many comments on a session they have seen.
QString commentsSeenKey(database::SessionId session);

/// Worker. Failure: the repositories'.
core::Result<DebriefHead> loadDebriefHead(database::Connection& connection, const database::Actor& actor,
                                          database::SessionId session, const std::string& language);
/// Worker. Failure: the reader's, doesNotHold naming a damaged chunk; cancelled.
core::Result<DebriefDetails> loadDebriefDetails(database::Connection& connection, const database::Actor& actor,
                                                database::SessionId session, const std::atomic<bool>& cancelled);
/// Worker: everything that the printed report needs. Failure: as above.
core::Result<report::ReportData> loadReport(database::Connection& connection, const database::Actor& actor,
                                            database::SessionId session, const std::string& language);

} // namespace chiron::desktop
