// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/session_repository.h"
#include "recording/recorder.h"
#include "session/channels.h"
#include "session/session_outcome.h"
#include "support/session_fixture.h"

#include <vector>

namespace chiron::tests {

/// A session made of given frames, stored and concluded as a real one: for what a scripted hand does not do
/// by itself (pauses, stops, faults, other people's names).
struct MadeSession {
    session::SessionSetup setup;
    std::vector<core::HapticFrame> frames;
    std::string operatorName; ///< empty: the actor's own hand
    bool familiarisation = false;
    session::RunEnding ending;
};

/// What a stored session was made of, to be changed and stored again.
inline MadeSession copyOf(database::Database& database, database::SessionId id) {
    OpenStored stored(database, id);
    auto frames = stored.session->reader().allFrames();
    if (!frames)
        qFatal("%s", frames.error().message.c_str());
    return {
        stored.session->setup(), std::move(*frames), stored.session->record().setup.operatorName, false, {}};
}

inline database::SessionId store(database::Database& database, const database::Actor& actor,
                                 const MadeSession& made) {
    auto table = session::channelTableFor(made.setup);
    auto positions = session::ToolPositions::create(made.setup);
    if (!table || !positions)
        qFatal("the setup of the copied session cannot be used");
    database::NewSession columns = session::toNewSession(made.setup);
    columns.operatorName = made.operatorName;
    columns.familiarisation = made.familiarisation;
    columns.channelTable = table->encode();
    const auto id = database.write([&](database::WriteContext& context) -> core::Result<database::SessionId> {
        database::SessionRepository sessions(context.connection(), actor);
        auto begun = sessions.beginSession(columns);
        if (!begun)
            return begun;
        auto sink = sessions.openSink(*begun);
        CHIRON_TRY(sink);
        recording::Recorder recorder(*table, **positions, **sink, {.forceLimit_N = columns.forceLimit_N});
        CHIRON_TRY(recorder.add(made.frames));
        CHIRON_TRY(recorder.finish());
        return begun;
    });
    if (!id)
        qFatal("%s", id.error().message.c_str());
    const auto scores = session::concludeSession(database, actor, *id, made.ending);
    if (!scores)
        qFatal("%s", scores.error().message.c_str());
    return *id;
}

/// Pauses the frames of ticks [from, to): as the supervisor leaves them, without force.
inline void pauseFrames(std::vector<core::HapticFrame>& frames, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < std::min(to, frames.size()); ++i) {
        frames[i].header.paused = 1;
        frames[i].header.force = core::ForceState::paused;
        frames[i].tool[0].commanded = {};
    }
}

/// Cuts the session after `count` frames; by `command` in the last one, where one is given.
inline void cutFrames(std::vector<core::HapticFrame>& frames, std::size_t count,
                      core::CommandKind command = core::CommandKind::none) {
    frames.resize(std::min(count, frames.size()));
    if (command != core::CommandKind::none && !frames.empty())
        frames.back().header.commands[0] = {command};
}

} // namespace chiron::tests
