// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/desktop/palpation_part.h"

#include "app/exercises/palpation/desktop/palpation_panel.h"
#include "app/exercises/palpation/desktop/palpation_words.h"
#include "app/exercises/palpation/scene/palpation_overlay.h"
#include "desktop/training/finger_control.h"
#include "modules/exercises/palpation/cues/report_word.h"

namespace chiron::desktop {

namespace {

constexpr int kMapKey = Qt::Key_M;
// T as in "tell": frees the pointer for use beside the scene.
constexpr int kFreeKey = Qt::Key_T;

struct GuideTexts {
    Q_DECLARE_TR_FUNCTIONS(ControlGuide)
};

} // namespace

PalpationPart::PalpationPart(const simulation::PalpationParameters& level, LiveSurroundings around)
    : LivePart(std::move(around)), m_level(level) {
    if (this->around().cues.coverage)
        m_map.emplace(m_level);
}

InfoView* PalpationPart::makePanel() {
    m_panel = new PalpationPanel(around().theme, around().locale, around().cues, m_level);
    m_panel->findings().setEnabled(around().ownHand); // a person who only watches reports nothing
    QObject::connect(&m_panel->findings(), &FindingsBox::reported, m_panel,
                     [report = around().report](simulation::ReportField field, unsigned value) {
                         report(simulation::reportWord(field, value));
                     });
    return m_panel;
}

std::unique_ptr<HandControl> PalpationPart::takeHand(session::LiveTraining& training,
                                                     std::function<void(int)> chosen) const {
    const std::vector<devices::PointerMailbox*> mailboxes = training.pointers();
    if (mailboxes.empty())
        return nullptr; // somebody else's hand moves the tool
    auto fingers = std::make_unique<FingerControl>(mailboxes, m_level.fingers, around().theme.scale(),
                                                   around().leftHanded, m_level.pinch.has_value());
    fingers->onChosen(std::move(chosen));
    return fingers;
}

QString PalpationPart::activeText(int tool) const {
    return m_level.hands > 1 ? activeHandInWords(tool / m_level.fingers) : QString();
}

LiveGuide PalpationPart::guide() const {
    return {controls(), keysText()};
}

std::vector<ControlHint> PalpationPart::controls() const {
    if (around().hand == devices::HandKind::handle)
        return {{Pictogram::moveStylus, GuideTexts::tr("Move"),
                 GuideTexts::tr("Take the handle and move it: the finger moves with it.")},
                {Pictogram::pressStylus, GuideTexts::tr("Press"),
                 GuideTexts::tr("Push the handle down. To raise the finger, raise the handle.")},
                {Pictogram::stylusButton, GuideTexts::tr("Mark a finding"),
                 GuideTexts::tr("Press the button of the handle, or Enter. When nothing is left to report, "
                                "press D.")}};
    std::vector<ControlHint> hints{
        {Pictogram::moveMouse, GuideTexts::tr("Move"),
         GuideTexts::tr("Move the mouse, or use the arrow keys.")},
        {Pictogram::wheelTowards, GuideTexts::tr("Press"),
         GuideTexts::tr("Roll the wheel towards you, or hold Page Down. To raise, roll it away from you, "
                        "or hold Page Up.")},
        {Pictogram::leftClick, GuideTexts::tr("Mark a finding"),
         GuideTexts::tr("Click, or press Enter. When nothing is left to report, press D.")}};
    if (m_level.hands > 1)
        hints.push_back({Pictogram::keys, GuideTexts::tr("Change hands"),
                         GuideTexts::tr("You move one hand at a time. Press H for the other one.")});
    return hints;
}

QString PalpationPart::keysText() const {
    const bool rates = m_level.asksSize || m_level.asksHardness || m_level.asksConfidence;
    return palpationKeysInWords(around().ownHand, m_level.hands, rates, m_level.pinch.has_value(),
                                around().hand);
}

std::vector<LiveCommand> PalpationPart::commands() const {
    const auto textOf = [](int key) {
        return key == Qt::Key_N        ? TrainingTexts::tr("Select the next finding")
               : key == Qt::Key_Delete ? TrainingTexts::tr("Take back the selected finding")
               : key == Qt::Key_D      ? TrainingTexts::tr("Nothing more to report")
                                       : QString();
    };
    std::vector<LiveCommand> list;
    for (const int key : FindingsBox::keys())
        list.push_back({textOf(key), key, [panel = m_panel, key] { panel->findings().key(key); }});
    // The clock continues and the finger stays in place, because the session accepts no findings while
    // paused.
    list.push_back(
        {TrainingTexts::tr("Free the pointer to rate with the mouse"), kFreeKey, around().freePointer});
    list.push_back({m_map ? TrainingTexts::tr("Map: searched area or force") : QString(), kMapKey,
                    [panel = m_panel] { panel->switchMap(); }});
    return list;
}

void PalpationPart::show(const haptics::DisplayState& state, std::span<const session::LiveSample> samples,
                         scene3d::SceneState& drawn) {
    if (!m_map)
        return;
    m_map->take(state.trial, samples);
    auto& overlay = drawn.overlay.own<scene3d::PalpationOverlay>();
    overlay.map = &m_map->map();
    overlay.mapStep = m_map->map().step();
    overlay.mapKind =
        m_panel->showsForceMap() ? simulation::SurfaceMapKind::force : simulation::SurfaceMapKind::coverage;
}

double PalpationPart::lean_rad(const haptics::DisplayState& state, std::size_t tool) const {
    return state.exercise.of<simulation::PalpationCues>().lean_rad[tool];
}

} // namespace chiron::desktop
