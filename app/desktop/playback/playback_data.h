// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/repositories/session_reader.h"
#include "desktop/playback/playback_layer.h"
#include "session/playback_track.h"
#include "session/session_setup.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace chiron::desktop {

/// A session as playback needs it: values only, so that the GUI thread waits for nobody.
struct PlaybackData {
    database::SessionRecord record; ///< with its person's name as screens call them
    session::SessionSetup setup;
    std::unique_ptr<PlaybackLayer> layer; ///< of its exercise; null without a recording
    session::PlaybackTrack track; ///< empty where nothing was recorded, or where the recording was erased
};

/// Why a session is offered as a second one.
enum class GhostRole { ownFirst, ownBest, scripted, other };

struct GhostCandidate {
    database::SessionSummary summary;
    GhostRole role = GhostRole::other;
};

/// A comment and the name of who wrote it; empty where the name may not be known here.
struct NamedComment {
    database::SessionComment comment;
    std::string author;
};

/// All of these: on a worker. Failure: the repositories' and the reader's, doesNotHold naming a damaged chunk; cancelled.
core::Result<PlaybackData> loadPlayback(database::Connection& connection, const database::Actor& actor,
                                        database::SessionId session, const std::function<bool(double)>& progress);
/// Completed sessions of the same exercise, level and device class, the person's own first and best in front, then scripted
/// ones, then the newest others.
core::Result<std::vector<GhostCandidate>> listGhosts(database::Connection& connection, const database::Actor& actor,
                                                     const database::SessionRecord& record, const std::string& mainMetric,
                                                     bool lowerIsBetter);
/// What people are called as the login screen of this site shows them: nothing that is not seen there anyway. Empty where that fails.
std::map<database::PersonId, std::string> shownNames(database::Connection& connection);
core::Result<std::vector<NamedComment>> loadComments(database::Connection& connection, const database::Actor& actor,
                                                     database::SessionId session);

} // namespace chiron::desktop
