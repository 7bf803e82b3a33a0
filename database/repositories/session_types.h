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

/// States of a session (data.md, Words); running is a session that has not ended, or whose program died.
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

/// What is known of a session before its first tick. JSON texts are canonical (sorted keys, no spaces) where
/// so said.
struct NewSession {
    std::string exercise;    ///< id, snake_case
    int level = 1;           ///< from 1
    std::string contentJson; ///< resolved content, canonical; its SHA-256 is computed and stored
    std::uint64_t seed = 0;
    std::string operatorName;   ///< scripted operator or trace; empty: the person's own hand
    bool felt = false;          ///< device class: force is rendered (felt) or only shown
    std::string deviceJson;     ///< device descriptor with calibration
    std::string mappingJson;    ///< workspace mapping
    std::string supervisorJson; ///< supervisor settings
    std::string versionsJson;   ///< model and metric versions
    std::string buildId;
    std::string cpuClass;
    double forceLimit_N = 0.0; ///< for "over the limit", >= 0
    int plannedTrials = 1;
    bool familiarisation = false; ///< recorded, marked, never counted
    bool realtime = false;
    std::string ringFile;                   ///< where the crash ring lies while it runs; empty: none
    std::vector<std::uint8_t> channelTable; ///< encoded (recording/channel_table.h)
    std::int64_t studyRun = 0;              ///< open run of a study that it is recorded for; 0: none
};

/// What is known at its end.
struct SessionEnd {
    SessionState state = SessionState::completed;
    std::uint64_t ticks = 0;
    std::uint64_t frames = 0;
    std::uint64_t dropped = 0;   ///< frames lost to a full ring; > 0 belongs to state incomplete
    std::string loopJson = "{}"; ///< loop statistics
};

/// One trial of a session.
struct TrialRecord {
    int index = 0; ///< from 0
    std::uint64_t seed = 0;
    SessionState state = SessionState::completed; ///< completed, stopped, interrupted, incomplete or faulted
    std::uint64_t firstTick = 0;
    std::uint64_t lastTick = 0;
    bool marked = false; ///< ended as the exercise asks: by the person's mark, or with its procedure completed
    bool timedOut = false;
    std::string sceneJson = "{}"; ///< the trial's truth: centre, R, K, mu ...
};

/// Something that happened, with the tick at which it took effect.
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
    std::string text;                    ///< empty where erased
    std::optional<std::uint64_t> tick{}; ///< executed tick it belongs to; absent: the session as a whole
};

/// What was decided about a session and taken back later: a voiding that holds no more, or that the session counts again.
struct SessionDecision {
    bool voiding = false; ///< else: that it counts again
    PersonId person = 0;  ///< who decided
    std::string utc;
    std::string reason; ///< empty where erased
};

/// A line of the list of sessions, from stored summaries only.
struct SessionSummary {
    SessionId id = 0; ///< the session number; the order of sessions
    PersonId person = 0;
    std::string personName; ///< the pseudonym for readers who may not see names
    std::string exercise;
    int level = 1;
    SessionState state = SessionState::running;
    std::string startedUtc; ///< label, never an order
    int utcOffset_min = 0;
    std::string operatorName;
    bool felt = false;
    bool familiarisation = false;
    bool demonstration = false;
    bool archived = false;
    bool recordingErased = false;
    std::optional<bool> passed; ///< of the latest scores; absent while unscored
    int gates = 0;              ///< of the latest scores: how many limits the level sets
    int gatesMet = 0;
    int comments = 0;
    bool reviewed = false; ///< somebody else has commented on it
    int attempt = 0;       ///< which of its person's attempts at this level, from 1; 0: none (session_attempts.h)
    bool ofStudy = false;  ///< recorded for a study
    bool toReview = false; ///< it awaits a look by whoever reads this list: never one's own session (session_attempts.h)
    std::uint64_t ticks = 0;
    std::uint64_t frames = 0;
    std::uint64_t dropped = 0;
    std::uint64_t chunks = 0;
    std::uint64_t recordingBytes = 0;
    /// A sitting of a blinded study: whether it passed, its gates and the five numbers above are withheld (absent, 0), because how long it took and how much was
    /// recorded tell the conditions apart.
    bool sealed = false;
};

/// Everything stored about a session but its samples.
struct SessionRecord {
    SessionSummary summary;
    NewSession setup;
    std::string contentSha256; ///< 64 hex digits
    std::string loopJson;
    std::string endedUtc;
    std::string voidReason;
    PersonId voidedBy = 0;
    std::optional<SessionState> stateBeforeVoid;
    std::vector<SessionDecision> decisions; ///< earlier ones, oldest first; a voiding that holds is in the fields above
};

/// A session about which the reader wrote, or on whose own session somebody wrote, with everything that was written about it.
struct CommentedSession {
    SessionSummary session;
    std::vector<SessionComment> comments; ///< in the order of writing
};

/// Which of them.
struct CommentedFilter {
    bool toRead = false; ///< only where others wrote something for the reader: on the reader's own session, or after the reader on another's
    int most = 0;        ///< at most so many, the newest sessions; 0: all
};

/// Which sessions to list; absent means any.
struct SessionFilter {
    std::optional<PersonId> person;
    std::string exercise;
    std::optional<int> level;
    std::optional<SessionState> state;
    bool toReview = false; ///< only those that await the reader's look (SessionSummary::toReview)
    bool includeArchived = false;
    bool newestFirst = false;
    int limit = 0;              ///< 0: all
    SessionId afterSession = 0; ///< for paging (before it, when newestFirst)
};

} // namespace chiron::database
