// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/actor.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::database {

/// States of a session (data.md, Words). A running session has not ended, or its program died.
enum class SessionState : std::uint8_t {
    running,
    completed,
    stopped,
    interrupted,
    incomplete,
    faulted,
    voided
};
std::string_view token(SessionState state) noexcept;
std::optional<SessionState> sessionStateFromToken(std::string_view word) noexcept;

/// The properties of a session that are known before its first tick. JSON texts are canonical (sorted keys,
/// no spaces) where stated.
struct NewSession {
    std::string exercise;    ///< id, snake_case
    int level = 1;           ///< from 1
    std::string contentJson; ///< resolved content, canonical; its SHA-256 is computed and stored
    std::uint64_t seed = 0;
    std::string operatorName;   ///< scripted operator or trace; empty: a person's own hand
    bool felt = false;          ///< device class: force is rendered (felt) or only shown
    std::string deviceJson;     ///< device descriptor with calibration
    std::string mappingJson;    ///< workspace mapping
    std::string supervisorJson; ///< supervisor settings
    std::string versionsJson;   ///< model and metric versions
    std::string buildId;
    std::string cpuClass;
    double forceLimit_N = 0.0; ///< for metrics such as "time over the limit", >= 0
    int plannedTrials = 1;
    bool familiarisation = false; ///< recorded, marked, never counted
    bool realtime = false;
    /// Path of the crash ring while the session runs; empty: none.
    std::string ringFile;
    std::vector<std::uint8_t> channelTable; ///< encoded (recording/channel_table.h)
    std::int64_t studyRun = 0;              ///< open run of a study for which it is recorded; 0: none
};

/// The properties of a session that are known at its end.
struct SessionEnd {
    SessionState state = SessionState::completed;
    std::uint64_t ticks = 0;
    std::uint64_t frames = 0;
    std::uint64_t dropped = 0;   ///< frames lost to a full ring; > 0 implies the state incomplete
    std::string loopJson = "{}"; ///< loop statistics
};

/// One trial of a session.
struct TrialRecord {
    int index = 0; ///< from 0
    std::uint64_t seed = 0;
    SessionState state = SessionState::completed; ///< completed, stopped, interrupted, incomplete or faulted
    std::uint64_t firstTick = 0;
    std::uint64_t lastTick = 0;
    /// Ended as the exercise intends: by the person's mark, or with the procedure completed.
    bool marked = false;
    bool timedOut = false;
    std::string sceneJson = "{}"; ///< the trial's truth: centre, R, K, mu ...
};

/// An event, with the tick at which it took effect.
struct EventRecord {
    std::uint64_t tick = 0;
    double time_s = 0.0; ///< device time since the first frame
    int tool = 0;
    std::string kind; ///< snake_case
    std::string detailJson = "{}";
};

struct SessionComment {
    std::int64_t id = 0;
    PersonId author = 0;
    std::string utc;
    std::string text;                    ///< empty if erased
    std::optional<std::uint64_t> tick{}; ///< executed tick to which it belongs; absent: the session as a
                                         ///< whole
};

/// A decision about a session that was reversed later: a voiding that no longer applies, or a reinstatement.
struct SessionDecision {
    bool voiding = false; ///< false: a reinstatement
    PersonId person = 0;  ///< who decided
    std::string utc;
    std::string reason; ///< empty if erased
};

/// An entry of the list of sessions, read only from stored summaries.
struct SessionSummary {
    SessionId id = 0; ///< the session number, which defines the order of sessions
    PersonId person = 0;
    std::string personName; ///< pseudonym for readers who may not see names
    std::string exercise;
    int level = 1;
    SessionState state = SessionState::running;
    std::string startedUtc; ///< for display, never used for ordering
    int utcOffset_min = 0;
    std::string operatorName;
    bool felt = false;
    bool familiarisation = false;
    bool demonstration = false;
    bool archived = false;
    bool recordingErased = false;
    std::optional<bool> passed; ///< for the latest scores; absent if there are none
    int gates = 0;              ///< for the latest scores: number of limits that the level sets
    int gatesMet = 0;
    int comments = 0;
    bool reviewed = false; ///< somebody else has commented on it
    /// Number among its person's attempts at this level, from 1; 0: not an attempt (session_attempts.h).
    int attempt = 0;
    bool ofStudy = false; ///< recorded for a study
    /// The session awaits a review by the reader of this list; never one's own session (session_attempts.h).
    bool toReview = false;
    std::uint64_t ticks = 0;
    std::uint64_t frames = 0;
    std::uint64_t dropped = 0;
    std::uint64_t chunks = 0;
    std::uint64_t recordingBytes = 0;
    /// A session of a blinded study: whether it passed, its gates and the five numbers above are withheld
    /// (absent, 0), because its duration and the amount of recorded data distinguish the conditions.
    bool sealed = false;
};

/// All stored data of a session except its samples.
struct SessionRecord {
    SessionSummary summary;
    NewSession setup;
    std::string contentSha256; ///< 64 hex digits
    std::string loopJson;
    std::string endedUtc;
    std::string voidReason;
    PersonId voidedBy = 0;
    std::optional<SessionState> stateBeforeVoid;
    /// Earlier decisions, oldest first; a current voiding is described by the fields above.
    std::vector<SessionDecision> decisions;
};

/// Another person's session on which the reader commented, or the reader's own session on which somebody else
/// commented, with all comments on it.
struct CommentedSession {
    SessionSummary session;
    std::vector<SessionComment> comments; ///< in the order in which they were written
};

/// Selects commented sessions.
struct CommentedFilter {
    /// Only sessions with comments for the reader: on the reader's own session, or on another's after a
    /// comment by the reader.
    bool toRead = false;
    int most = 0; ///< at most this many, the newest sessions; 0: all
};

/// Selects the sessions to list; an absent field means any.
struct SessionFilter {
    std::optional<PersonId> person;
    std::string exercise;
    std::optional<int> level;
    std::optional<SessionState> state;
    bool toReview = false; ///< only sessions that await the reader's review (SessionSummary::toReview)
    bool includeArchived = false;
    bool newestFirst = false;
    int limit = 0;              ///< 0: all
    SessionId afterSession = 0; ///< for paging: sessions after it (before it if newestFirst)
};

} // namespace chiron::database
