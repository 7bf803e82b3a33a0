// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/force_words.h"

#include <QCoreApplication>
#include <algorithm>

namespace chiron::desktop {

using core::ForceState;
namespace guard_bits = core::guard_bits;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(ForceWords)
};

ForceWords stoppedWords() {
    return {"bad", Words::tr("Force is stopped"),
            Words::tr("The clock is stopped and everything so far is kept. Press Re-arm (or R) to go on, or "
                      "End session.")};
}

ForceWords faultWords(std::uint32_t guards) {
    QString why = Words::tr("The safety supervisor switched the force off.");
    if ((guards & guard_bits::kOverVelocity) != 0)
        why = Words::tr("The tool moved faster than is safe, so force was switched off.");
    else if ((guards & (guard_bits::kWatchdogFault | guard_bits::kWatchdog)) != 0)
        why = Words::tr("The device's data came too late, so force was switched off.");
    else if ((guards & (guard_bits::kSampleFault | guard_bits::kBadSample)) != 0)
        why = Words::tr("The device sent impossible positions, so force was switched off.");
    else if ((guards & guard_bits::kDeviceFault) != 0)
        why = Words::tr("The device reports a fault, so force was switched off.");
    else if ((guards & guard_bits::kNotFinite) != 0)
        why = Words::tr("The calculated force was invalid (not a number), so force was switched off. Please "
                        "report this.");
    return {"bad", why,
            Words::tr("The clock is stopped and everything so far is kept. Hold the tool safely, then press "
                      "Re-arm (or R).")};
}

ForceWords armingWords(const haptics::DisplayState& state) {
    switch (state.waitsFor) {
    case haptics::ArmingWait::firstPacket:
        return {"warning", Words::tr("Waiting for the device"),
                Words::tr("The device has not sent a valid position yet. Check that it is "
                          "switched on.")};
    case haptics::ArmingWait::holdStill:
        return {"warning", Words::tr("Hold still"),
                Words::tr("Hold the tool still for half a second; force then rises slowly.")};
    case haptics::ArmingWait::window:
        return {"warning", Words::tr("Force is on hold"),
                Words::tr("The window did not respond for a moment. Force comes back by itself.")};
    default:
        return {"warning", Words::tr("Force is not on yet"),
                Words::tr("Move the tool until it touches nothing, or hold it still and press Resume here.")};
    }
}

ForceWords watchedWords(const haptics::DisplayState& state, bool felt, const QLocale& locale) {
    QString text = Words::tr("Force is shown, not felt.");
    if (felt && state.force == ForceState::arming)
        text = Words::tr("The operator's force waits until the tool is free.");
    else if (felt && state.force == ForceState::ramping)
        text = Words::tr("The operator's force rises slowly (%1 %).")
                   .arg(locale.toString(qRound(state.gain * 10.0) * 10));
    else if (felt &&
             (state.force == ForceState::heldByHeartbeat || state.force == ForceState::heldByWatchdog))
        text = Words::tr("The operator's force is on hold for a moment and comes back by itself.");
    return {"info", Words::tr("You are watching"), text};
}

/// True only if no tool moves, because with several tools one rests while another is moved.
bool nothingMoves(const haptics::DisplayState& state) {
    const auto tools = static_cast<std::ptrdiff_t>(std::clamp(state.tools, 1, core::kMaxTools));
    return std::all_of(state.tool.begin(), state.tool.begin() + tools,
                       [](const auto& tool) { return tool.noMovement; });
}

ForceWords shownWords(const haptics::DisplayState& state, bool endoscope, bool grasper) {
    if (nothingMoves(state))
        return {
            "warning", Words::tr("No movement"),
            Words::tr(
                "Nothing has moved for two seconds. Move the mouse over the scene or press an arrow key.")};
    if (endoscope)
        return {
            "info", Words::tr("Shown, not felt"),
            Words::tr("This device renders no force. The endoscope moves more slowly the harder you press.")};
    if (grasper)
        return {"info", Words::tr("Shown, not felt"),
                Words::tr("This device renders no force. An instrument moves more slowly the harder "
                          "something pulls or presses.")};
    return {"info", Words::tr("Shown, not felt"),
            Words::tr("This device renders no force. The tool stays at the surface and moves more slowly the "
                      "harder you press.")};
}

} // namespace

ForceWords forceWords(const haptics::DisplayState& state, const AskedFor& asked, const QLocale& locale) {
    if (!state.started)
        return {"info", Words::tr("Getting ready"),
                asked.endoscope ? Words::tr("The procedure begins as soon as the scene is drawn.")
                                : Words::tr("The first trial begins as soon as the scene is drawn.")};
    if (state.force == ForceState::fault)
        return faultWords(state.guards);
    if (asked.stopped || state.force == ForceState::stopped)
        return stoppedWords();
    if (asked.paused)
        return {"info", Words::tr("Paused"),
                Words::tr("The clock is stopped. Press Resume or Space to go on.")};
    if (!asked.ownHand)
        return watchedWords(state, asked.felt, locale);
    if (!asked.felt)
        return shownWords(state, asked.endoscope, asked.grasper);
    switch (state.force) {
    case ForceState::ramping:
        return {"info", Words::tr("Force is rising"),
                Words::tr("It rises slowly (now %1 %). The clock starts once it has reached full "
                          "strength.")
                    .arg(locale.toString(qRound(state.gain * 10.0) * 10))};
    case ForceState::on:
        return {"good", Words::tr("Force is on"), Words::tr("Esc stops it at once.")};
    case ForceState::heldByHeartbeat:
        return {"warning", Words::tr("Force is on hold"),
                Words::tr("The window did not respond for a moment. Force comes back by itself.")};
    case ForceState::heldByWatchdog:
        return {"warning", Words::tr("Force is on hold"),
                Words::tr("The device's data arrive late. Force comes back when they arrive on time "
                          "again.")};
    case ForceState::pausing:
    case ForceState::paused:
        return {"info", Words::tr("Paused"),
                Words::tr("The clock is stopped. Press Resume or Space to go on.")};
    default:
        return armingWords(state);
    }
}

} // namespace chiron::desktop
