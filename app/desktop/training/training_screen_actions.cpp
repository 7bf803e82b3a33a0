// SPDX-License-Identifier: GPL-3.0-or-later
// A person's actions during a running session.
#include "desktop/training/training_screen.h"

#include "desktop/frame/app_context.h"
#include "desktop/training/header_bar.h"
#include "desktop/training/key_filter.h"

namespace chiron::desktop {

namespace {
// After less work than this, starting again loses nothing and is not confirmed.
constexpr double kUnasked_s = 5.0;
} // namespace

void TrainingScreen::stopForce() {
    if (!running())
        return;
    m_control->stopForce();
    hold();
    showControls();
}

void TrainingScreen::pauseOrResume() {
    if (!running() || m_storing)
        return;
    m_control->pauseOrResume();
    m_control->held() ? hold() : goOn();
    showControls();
}

void TrainingScreen::rearm() {
    if (!running() || m_storing)
        return;
    m_control->rearm();
    goOn();
    showControls();
}

void TrainingScreen::mark() {
    if (running() && m_plan.ownHand() && m_tool == session::PointerTool::point && !m_control->held() &&
        !marksAreEarly())
        m_hand && m_hand->marks() ? m_hand->click() : m_control->mark();
}

void TrainingScreen::end() {
    if (!running() || m_storing)
        return;
    if (m_plan.practises()) {
        m_control->end(); // no result can be lost, and the practised level's card follows
        return;
    }
    m_control->pause();
    hold();
    askToEnd({tr("End the session now?"), keptText(), tr("End the session")}, [this] {
        if (running())
            m_control->end();
    });
}

void TrainingScreen::askToStartAgain() {
    if (!running() || m_storing || m_asking)
        return;
    m_control->pause();
    hold();
    showControls();
    if (m_feed->worked_s() < kUnasked_s) {
        startAgain();
        return;
    }
    const QString then = tr("What is recorded so far is kept and counts as stopped, not as completed. A new "
                            "attempt begins at once.");
    askToEnd({tr("Start again from the beginning?"), then, tr("Start again")}, [this] { startAgain(); });
}

void TrainingScreen::startAgain() {
    if (!running() || m_storing)
        return;
    m_again = true;
    m_control->end();
}

void TrainingScreen::setDepthOfField(bool on) {
    m_setup.depthOfField = on;
    m_plan.depthOfField = on;
    if (m_scene)
        m_scene->change(m_setup);
}

bool TrainingScreen::mayLeave() {
    bool leave = m_storing; // it has ended by itself, and leaving only waits until it is stored
    if (running() && !leave) {
        m_control->pause();
        hold();
        askToEnd({tr("A session is running. End it and leave?"), keptText(), tr("End and leave")},
                 [&leave] { leave = true; });
    }
    if (leave && running()) { // the person has left, so no debrief follows
        disconnect(m_feed.get(), nullptr, this, nullptr);
        m_over = true;
        m_keys->setActive(false);
        m_feed->training().requestStop();
    }
    return !running();
}

void TrainingScreen::hold() {
    if (m_hand)
        m_hand->releaseKeys();
    if (m_pointer)
        m_pointer->release();
}

// The focus also returns to the scene, so that Enter marks again and does not press the button that was used
// to continue.
void TrainingScreen::goOn() {
    takeCardAway();
    m_early.wentOn(m_clock.elapsed());
    if (!m_control->held())
        setFocus(Qt::OtherFocusReason);
    if (m_pointer && !m_control->held())
        m_pointer->capture();
}

void TrainingScreen::toggleMute() {
    m_sound.setMuted(!m_sound.muted());
    m_header->setMuted(m_sound.muted());
    context().settings().setSound(!m_sound.muted());
}

} // namespace chiron::desktop
