// SPDX-License-Identifier: GPL-3.0-or-later
// What the training screen has for fingers that palpate.
#include "desktop/frame/app_context.h"
#include "desktop/training/finger_control.h"
#include "app/exercises/palpation/desktop/palpation_panel.h"
#include "desktop/training/training_screen.h"
#include "desktop/training/training_words.h"

#include <QLabel>

namespace chiron::desktop {

namespace {
constexpr int kMapKey = Qt::Key_M;
constexpr int kFreeKey = Qt::Key_T; // "tell": the pointer is needed beside the scene
}

InfoView* TrainingScreen::makePalpationInfo() {
    m_palpation = new PalpationPanel(context().theme(), context().locale(), m_cues, *m_palpated);
    m_palpation->findings().setEnabled(m_plan.ownHand()); // who watches says nothing
    if (m_cues.coverage)
        m_map.emplace(*m_palpated);
    connect(&m_palpation->findings(), &FindingsBox::reported, this, [this](core::ReportField field, unsigned value) {
        if (running() && !m_storing)
            m_control->report(field, value);
    });
    return m_palpation;
}

void TrainingScreen::takeFingers(double scale) {
    session::LiveTraining& training = m_feed->training();
    const std::vector<devices::PointerMailbox*> mailboxes = training.pointers();
    if (mailboxes.empty())
        return; // somebody else's hand
    auto fingers = std::make_unique<FingerControl>(mailboxes, m_palpated->fingers, scale, m_plan.workspace.leftHanded, m_palpated->pinch.has_value());
    fingers->onChosen([this](int tool) {
        if (m_activeText)
            m_activeText->setText(activeHandInWords(tool / m_palpated->fingers));
    });
    m_hand = std::move(fingers);
}

std::vector<int> TrainingScreen::handKeys() const {
    std::vector<int> keys(m_hand->keys().begin(), m_hand->keys().end());
    if (!m_palpation)
        return keys;
    keys.insert(keys.end(), FindingsBox::keys().begin(), FindingsBox::keys().end());
    keys.push_back(kMapKey);
    keys.push_back(kFreeKey);
    return keys;
}

bool TrainingScreen::panelKey(int key) {
    if (!m_palpation)
        return false;
    if (key == kMapKey)
        m_palpation->switchMap();
    else if (key == kFreeKey)
        freePointer();
    else
        return m_palpation->findings().key(key);
    return true;
}

// The clock runs on and the finger stays where it is: while paused nothing is taken.
void TrainingScreen::freePointer() {
    m_hand->releaseKeys();
    if (m_pointer)
        m_pointer->release();
}

void TrainingScreen::showMap(scene3d::SceneState& drawn) {
    if (!m_map)
        return;
    m_map->take(m_feed->state().trial, m_feed->samples());
    drawn.surfaceMap = &m_map->map();
    drawn.surfaceMapStep = m_map->map().step();
    drawn.mapKind = m_palpation->showsForceMap() ? core::SurfaceMapKind::force : core::SurfaceMapKind::coverage;
}

void TrainingScreen::addPalpationCommands(std::vector<ScreenCommand>& list) {
    const auto press = [this](int key) {
        return [this, key] { (void)panelKey(key); };
    };
    list.push_back({tr("Select the next finding"), QKeySequence(Qt::Key_N), press(Qt::Key_N), false});
    list.push_back({tr("Take back the selected finding"), QKeySequence(Qt::Key_Delete), press(Qt::Key_Delete), false});
    list.push_back({tr("Nothing more to report"), QKeySequence(Qt::Key_D), press(Qt::Key_D), false});
    list.push_back({tr("Free the pointer to rate with the mouse"), QKeySequence(kFreeKey), press(kFreeKey), false});
    if (m_map)
        list.push_back({tr("Map: searched area or force"), QKeySequence(kMapKey), press(kMapKey), false});
}

QString TrainingScreen::keysText() const {
    if (!m_palpated)
        return keysInWords(m_plan.ownHand(), m_tool, m_tools);
    return palpationKeysInWords(m_plan.ownHand(), m_palpated->hands, m_palpated->asksSize || m_palpated->asksHardness || m_palpated->asksConfidence,
                                m_palpated->pinch.has_value());
}

} // namespace chiron::desktop
