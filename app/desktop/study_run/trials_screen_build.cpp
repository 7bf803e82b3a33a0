// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a sitting's screen, its keys and pointer.
#include "desktop/study_run/trials_screen.h"

#include "catalogue/exercise.h"
#include "desktop/frame/app_context.h"
#include "desktop/study_run/answer_panel.h"
#include "desktop/study_run/apex_stage.h"
#include "desktop/study_run/break_panel.h"
#include "desktop/study_run/experimenter_panel.h"
#include "desktop/study_run/places_view.h"
#include "desktop/training/key_filter.h"
#include "desktop/training/pointer_control.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/state_panel.h"
#include "simulation/exercises/comparison/comparison_parameters.h"

#include <QCheckBox>
#include <QProgressBar>
#include <QStackedWidget>

namespace chiron::desktop {

namespace {
constexpr double kSide_px = 330;
constexpr double kLargestSideShare = 0.4;
} // namespace

TrialsScreen::TrialsScreen(AppContext& context, const Place& place)
    : Screen(context, place), m_participant(place.parameters.value(QStringLiteral("participant")).toString()),
      m_condition(place.parameters.value(QStringLiteral("condition")).toString().toStdString()),
      m_study(place.parameters.value(QStringLiteral("study")).toLongLong()) {
    const Theme& theme = context.theme();
    setProperty("kind", QStringLiteral("page"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(theme.px(16), theme.px(12), theme.px(16), theme.px(12));
    column->setSpacing(theme.px(10));
    column->addWidget(buildHead());
    auto* row = new QHBoxLayout;
    row->setSpacing(theme.px(12));
    m_panel = new StatePanel(theme);
    m_panel->setContent(buildStage());
    row->addWidget(m_panel, 1);
    m_experimenter = new ExperimenterPanel(theme, context.locale());
    m_experimenter->setFixedWidth(std::min(theme.px(kSide_px), static_cast<int>(kLargestSideShare * context.theme().px(1280) / theme.scale())));
    m_experimenter->hide();
    connect(m_experimenter, &ExperimenterPanel::spoilAsked, this, [this] {
        if (running())
            m_live->spoil();
    });
    connect(m_experimenter, &ExperimenterPanel::pauseAsked, this, &TrialsScreen::pauseOrResume);
    connect(m_experimenter, &ExperimenterPanel::stopAsked, this, &TrialsScreen::askToStop);
    row->addWidget(m_experimenter);
    column->addLayout(row, 1);
    buildKeys();
    connect(&m_frame, &QTimer::timeout, this, &TrialsScreen::poll);
    m_frame.setTimerType(Qt::PreciseTimer);
}

QWidget* TrialsScreen::buildHead() {
    const Theme& theme = context().theme();
    auto* head = new QFrame;
    head->setProperty("kind", QStringLiteral("card"));
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(theme.px(14), theme.px(6), theme.px(14), theme.px(6));
    row->setSpacing(theme.px(12));
    m_note = kit::label(theme, {}, TextStyle::strong);
    m_note->setObjectName(QStringLiteral("trials.note"));
    row->addWidget(m_note, 2);
    m_progress = new QProgressBar;
    m_progress->setObjectName(QStringLiteral("trials.progress"));
    m_progress->setAccessibleName(tr("Progress of this part"));
    m_progress->setToolTip(tr("Progress of this part"));
    m_progress->setTextVisible(false);
    m_progress->setRange(0, 100);
    row->addWidget(m_progress, 2);
    auto* masking = new QCheckBox(tr("Sound"));
    masking->setObjectName(QStringLiteral("trials.masking"));
    masking->setFont(theme.font(TextStyle::body));
    masking->setToolTip(tr("Masking sound on or off"));
    masking->setChecked(true);
    connect(masking, &QCheckBox::toggled, this, [this](bool on) { m_masking = on; });
    row->addWidget(masking);
    auto* experimenter = kit::button(theme, tr("Experimenter (F2)"), "quiet", QStringLiteral("view-statistics"));
    experimenter->setObjectName(QStringLiteral("trials.experimenter"));
    connect(experimenter, &QPushButton::clicked, this, &TrialsScreen::toggleExperimenter);
    row->addWidget(experimenter);
    m_stop = kit::button(theme, tr("Stop …"), "", QStringLiteral("media-playback-stop"));
    m_stop->setObjectName(QStringLiteral("trials.stop"));
    connect(m_stop, &QPushButton::clicked, this, &TrialsScreen::askToStop);
    row->addWidget(m_stop);
    return head;
}

QWidget* TrialsScreen::buildStage() {
    const Theme& theme = context().theme();
    m_stage = new QStackedWidget;
    m_break = new BreakPanel(theme);
    connect(m_break, &BreakPanel::acted, this, &TrialsScreen::onBreakButton);
    m_stage->addWidget(m_break);
    m_trial = new QWidget;
    auto* column = new QVBoxLayout(m_trial);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(8));
    m_timeRow = new QWidget;
    auto* time = new QHBoxLayout(m_timeRow);
    time->setContentsMargins(0, 0, 0, 0);
    time->setSpacing(theme.px(8));
    time->addWidget(kit::label(theme, tr("Time to explore"), TextStyle::small, "muted"));
    m_time = new QProgressBar;
    m_time->setAccessibleName(tr("Time to explore"));
    m_time->setTextVisible(false);
    m_time->setFixedHeight(theme.px(20));
    time->addWidget(m_time, 1);
    column->addWidget(m_timeRow);
    m_stage->addWidget(m_trial);
    return m_stage;
}

void TrialsScreen::buildLive() {
    m_live->condition().stimulus.attribute == psychophysics::Attribute::apex ? buildApex() : buildPlaces();
}

void TrialsScreen::buildApex() {
    m_apex = new ApexStage(context().theme(), m_live->level(), {m_live->training().felt(), false});
    m_apex->setObjectName(QStringLiteral("trials.apex"));
    static_cast<QVBoxLayout*>(m_trial->layout())->addWidget(m_apex, 1);
    connect(m_apex, &ApexStage::markAsked, this, &TrialsScreen::mark);
}

QWidget& TrialsScreen::area() { return m_apex ? m_apex->area() : *m_places; }
QObject& TrialsScreen::source() { return m_apex ? m_apex->source() : *m_places; }

void TrialsScreen::buildPlaces() {
    const Theme& theme = context().theme();
    const psychophysics::Condition& condition = m_live->condition();
    PlacesSetup setup;
    setup.places = psychophysics::placesOf(condition.task);
    setup.visible = m_live->design().trial.visibleObjects;
    if (const auto* parameters = std::get_if<simulation::ComparisonParameters>(&m_live->level().parameters)) {
        setup.spacing_m = parameters->spacing_m;
        setup.padRadius_m = parameters->padRadius_m;
        setup.hookHeight_m = parameters->hookHeight_m;
        setup.hooked = simulation::isHooked(parameters->attribute);
    }
    setup.names = AnswerPanel::placeNames(setup.places);
    m_places = new PlacesView(theme, setup);
    m_places->setObjectName(QStringLiteral("trials.places"));
    m_answers = new AnswerPanel(theme, condition.task, condition.stimulus.attribute);
    auto* column = static_cast<QVBoxLayout*>(m_trial->layout());
    column->addWidget(m_places, 1);
    column->addWidget(m_answers);
    connect(m_answers, &AnswerPanel::answered, this, &TrialsScreen::answer);
    connect(m_answers, &AnswerPanel::adjusted, this, [this](int steps) {
        if (running())
            m_live->adjust(steps);
    });
    connect(m_answers, &AnswerPanel::marksChanged, this, [this] { m_places->setMarks(m_answers->marks()); });
}

void TrialsScreen::buildKeys() {
    m_keys = new KeyFilter(*this);
    connect(m_keys, &KeyFilter::stopAsked, this, &TrialsScreen::stopForce);
    connect(m_keys, &KeyFilter::pauseAsked, this, &TrialsScreen::pauseOrResume);
    connect(m_keys, &KeyFilter::rearmAsked, this, &TrialsScreen::rearm);
    connect(m_keys, &KeyFilter::markAsked, this, [this] {
        if (m_stage->currentWidget() == m_break)
            onBreakButton();
        else if (m_answers)
            m_answers->enterKey();
        else
            mark();
    });
    connect(m_keys, &KeyFilter::leaveSceneAsked, this, [this](bool) {
        window()->activateWindow();
        m_stop->setFocus(Qt::TabFocusReason);
    });
    connect(m_keys, &KeyFilter::toolKey, this, &TrialsScreen::toolKey);
}

void TrialsScreen::toolKey(int key, bool down) {
    if (key == Qt::Key_F2 || key == Qt::Key_T) {
        if (down)
            key == Qt::Key_T ? freePointer() : toggleExperimenter();
        return;
    }
    if (down && m_answers && m_answers->key(key))
        return;
    if (m_hand)
        down ? m_hand->keyDown(key) : m_hand->keyUp(key);
}

void TrialsScreen::connectPointer() {
    m_sessions = m_live->sessions();
    m_pointer.reset();
    m_hand.reset();
    std::vector<int> keys = m_answers ? AnswerPanel::keys() : std::vector<int>();
    keys.push_back(Qt::Key_F2);
    keys.push_back(Qt::Key_T);
    if (devices::PointerMailbox* pointer = m_live->training().pointer()) {
        m_hand = std::make_unique<PointerControl>(*pointer, context().theme().scale());
        for (const int key : m_hand->keys())
            keys.push_back(key);
        m_pointer = std::make_unique<ScenePointer>(*m_hand, source(), area());
        connect(m_pointer.get(), &ScenePointer::marked, this, [this] {
            if (!m_apex || m_live->view().canAnswer) // a click that comes too early is no mark
                m_hand->click();
        });
        connect(m_pointer.get(), &ScenePointer::captureAsked, this, &TrialsScreen::capturePointer);
    }
    m_keys->setScene(&source());
    m_keys->setToolKeys(keys);
    m_keys->setActive(true);
}

} // namespace chiron::desktop
