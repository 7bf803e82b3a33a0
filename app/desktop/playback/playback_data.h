// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/repositories/session_reader.h"
#include "desktop/playback/playback_layer.h"
#include "session/playback_track.h"
#include "session/session_setup.h"
#include "session/session_view.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace chiron::desktop {

/// The data of a session for playback. It holds values only, so that the GUI thread never waits.
struct PlaybackData {
    database::SessionRecord record; ///< with the person's name as the screens show it
    session::SessionSetup setup;
    std::unique_ptr<PlaybackLayer> layer; ///< of its exercise; null without a recording
    session::PlaybackTrack track;         ///< empty if nothing was recorded or the recording was erased
};

/// Why a session is offered as a ghost, that is, as a second session for comparison.
enum class GhostRole { ownFirst, ownBest, scripted, other };

struct GhostCandidate {
    database::SessionSummary summary;
    GhostRole role = GhostRole::other;
};

/// A comment with its author's name, which is empty if the name may not be known here.
struct NamedComment {
    database::SessionComment comment;
    std::string author;
};

/// Reads a session with its recording.
/// Thread: worker; blocks. The same holds for the functions below.
/// Errors: those of the repositories and the reader; doesNotHold naming a damaged chunk; cancelled.
core::Result<PlaybackData> loadPlayback(database::Connection& connection, const database::Actor& actor,
                                        database::SessionId session,
                                        const std::function<bool(double)>& progress);
/// Adds the recording of a session that is open already: track and layer. `data` has its set-up.
/// Errors: those of decoding; cancelled.
core::Result<void> addRecording(PlaybackData& data, session::SessionView& session,
                                const session::ReadProgress& progress);
/// Lists completed sessions of the same exercise, level and device class: first the person's own first and
/// best, then scripted ones, then the others from the newest.
core::Result<std::vector<GhostCandidate>> listGhosts(database::Connection& connection,
                                                     const database::Actor& actor,
                                                     const database::SessionRecord& record,
                                                     const std::string& mainMetric, bool lowerIsBetter);
/// The people's names as this site's login screen shows them, so that nothing is revealed that is not visible
/// there anyway. Empty if reading fails.
std::map<database::PersonId, std::string> shownNames(database::Connection& connection);
core::Result<std::vector<NamedComment>>
loadComments(database::Connection& connection, const database::Actor& actor, database::SessionId session);

} // namespace chiron::desktop
