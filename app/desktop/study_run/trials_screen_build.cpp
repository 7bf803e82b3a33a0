// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the screen of a study session, its keys and its pointer.
#include "desktop/study_run/trials_screen.h"

#include "catalogue/exercise.h"
#include "desktop/frame/app_context.h"
#include "desktop/studies/study_device.h"
#include "desktop/study_run/answer_panel.h"
#include "desktop/study_run/apex_stage.h"
#include "desktop/study_run/break_panel.h"
#include "desktop/study_run/experimenter_panel.h"
#include "desktop/study_run/large_texts.h"
#include "desktop/study_run/participant_page.h"
#include "desktop/study_run/participant_window.h"
#include "desktop/study_run/places_view.h"
#include "desktop/study_run/study_controls.h"
#include "desktop/training/felt_words.h"
#include "desktop/training/key_filter.h"
#include "desktop/training/pointer_control.h"
#include "desktop/training/ready_card.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/state_panel.h"
#include "simulation/comparison/comparison_parameters.h"

#include <QApplication>
#include <QCheckBox>
#include <QProgressBar>
#include <QStackedWidget>
#include <algorithm>

namespace chiron::desktop {

namespace {
constexpr double kDesk_px = 720;
} // namespace

bool TrialsScreen::isLarge() const {
    return areTextsLarge(context().theme());
}

TrialsScreen::TrialsScreen(AppContext& context, const Place& place)
    : Screen(context, place), m_participant(place.parameters.value(QStringLiteral("participant")).toString()),
      m_condition(place.parameters.value(QStringLiteral("condition")).toString().toStdString()),
      m_study(place.parameters.value(QStringLiteral("study")).toLongLong()) {
    setProperty("kind", QStringLiteral("page"));
    m_clock.start();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    m_faces = new QStackedWidget;
    column->addWidget(m_faces);
    buildPage();
    buildDesk();
    buildKeys();
    connect(&m_frame, &QTimer::timeout, this, &TrialsScreen::poll);
    m_frame.setTimerType(Qt::PreciseTimer);
}

void TrialsScreen::buildPage() {
    const Theme& theme = context().theme();
    m_page = new ParticipantPage;
    m_page->setObjectName(QStringLiteral("trials.page"));
    auto* column = new QVBoxLayout(m_page);
    column->setContentsMargins(theme.px(16), theme.px(12), theme.px(16), theme.px(12));
    column->setSpacing(theme.px(10));
    column->addWidget(buildHead());
    m_panel = new StatePanel(theme);
    m_panel->setContent(buildStage());
    column->addWidget(m_panel, 1);
    m_faces->addWidget(m_page);
}

/// Builds the experimenter's desk. Nothing of it ever appears on the participant's page.
void TrialsScreen::buildDesk() {
    const Theme& theme = context().theme();
    m_desk = new QWidget;
    m_desk->setObjectName(QStringLiteral("trials.desk"));
    auto* column = new QVBoxLayout(m_desk);
    column->setContentsMargins(theme.px(16), theme.px(12), theme.px(16), theme.px(12));
    column->setSpacing(theme.px(10));
    auto* bar = new QWidget;
    auto* row = new FlowLayout(theme.px(12), bar);
    m_toPage = kit::button(theme, tr("Back to the participant's page (F2)"), "primary",
                           QStringLiteral("go-previous"));
    m_toPage->setObjectName(QStringLiteral("trials.to_page"));
    connect(m_toPage, &QPushButton::clicked, this, &TrialsScreen::showPage);
    row->addWidget(m_toPage);
    m_leave = kit::button(theme, tr("Go on with the study"), "primary", QStringLiteral("go-next"));
    m_leave->setObjectName(QStringLiteral("trials.leave"));
    m_leave->hide();
    connect(m_leave, &QPushButton::clicked, this, &TrialsScreen::leave);
    row->addWidget(m_leave);
    auto* masking = new QCheckBox(tr("Masking sound"));
    masking->setObjectName(QStringLiteral("trials.masking"));
    masking->setFont(theme.font(TextStyle::body));
    masking->setToolTip(tr("Whether it is on is stored with each trial"));
    masking->setChecked(true);
    connect(masking, &QCheckBox::toggled, this, [this](bool on) {
        m_masking = on;
        if (running() && m_whole && !m_begun && !m_card)
            sayWholeInstructions();
        returnKeys();
    });
    row->addWidget(masking);
    column->addWidget(bar);
    m_noSound = kit::notice(theme, "warning",
                            tr("The masking sound is not heard: this machine has no sound output. Each trial "
                               "is recorded as not masked. To mask, stop the "
                               "session, connect headphones or loudspeakers, and resume the run."));
    m_noSound->setObjectName(QStringLiteral("trials.no_sound"));
    m_noSound->hide();
    column->addWidget(m_noSound);
    m_deskNote = kit::label(theme, {}, TextStyle::body, "muted");
    m_deskNote->setObjectName(QStringLiteral("trials.desk_note"));
    column->addWidget(m_deskNote);
    m_experimenter = new ExperimenterPanel(theme, context().locale());
    m_experimenter->setMaximumWidth(theme.px(kDesk_px));
    connect(m_experimenter, &ExperimenterPanel::spoilAsked, this, [this] {
        if (running())
            m_live->spoil();
        returnKeys();
    });
    connect(m_experimenter, &ExperimenterPanel::pauseAsked, this, [this] {
        pauseOrResume();
        returnKeys();
    });
    connect(m_experimenter, &ExperimenterPanel::stopAsked, this, &TrialsScreen::askToStop);
    column->addWidget(m_experimenter, 1);
    m_faces->addWidget(m_desk);
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
    m_progress->setMinimumWidth(theme.px(40)); // it shrinks before a button's text does
    m_progress->hide();                        // there is no progress before the trials
    row->addWidget(m_progress, 2);
    m_call = kit::button(theme, tr("Experimenter …"), "quiet", QStringLiteral("system-lock-screen"));
    m_call->setObjectName(QStringLiteral("trials.experimenter"));
    m_call->setFocusPolicy(Qt::NoFocus); // no key of the participant presses it; F2 does the same
    connect(m_call, &QPushButton::clicked, this, &TrialsScreen::toggleExperimenter);
    row->addWidget(m_call);
    m_stop = kit::button(theme, tr("Stop … (Esc twice)"), "", QStringLiteral("media-playback-stop"));
    m_stop->setToolTip(felt_words::stopHint(studyDeviceRendersForce()));
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
    connect(m_break, &BreakPanel::moreAsked, this, &TrialsScreen::showWholeInstructions);
    m_stage->addWidget(m_break);
    m_trial = new QWidget;
    auto* column = new QVBoxLayout(m_trial);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(8));
    column->addWidget(buildStrip());
    m_repeated = kit::label(theme, {}, TextStyle::body, "warning");
    m_repeated->setObjectName(QStringLiteral("trials.repeated"));
    // The label reserves its height while it is empty, so that nothing moves.
    if (!isLarge())
        m_repeated->setMinimumHeight(m_repeated->fontMetrics().height());
    column->addWidget(m_repeated);
    m_stage->addWidget(m_trial);
    return m_stage;
}

/// The strip above the scene: messages to the participant, the time, and their actions. Everything reserves
/// its space, so that nothing moves.
QWidget* TrialsScreen::buildStrip() {
    const Theme& theme = context().theme();
    auto* strip = new QWidget;
    auto* row = new QHBoxLayout(strip);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(theme.px(8));
    const auto keepRoom = [large = isLarge()](QWidget* part) {
        QSizePolicy policy = part->sizePolicy();
        policy.setRetainSizeWhenHidden(!large);
        part->setSizePolicy(policy);
        part->hide();
    };
    m_strip = kit::label(theme, {}, TextStyle::strong);
    m_strip->setObjectName(QStringLiteral("trials.strip"));
    row->addWidget(m_strip, 2);
    m_time = new QProgressBar;
    m_time->setAccessibleName(tr("Time to explore"));
    m_time->setToolTip(tr("Time to explore"));
    m_time->setAlignment(Qt::AlignCenter);
    m_time->setFont(theme.font(TextStyle::label));
    m_time->setFixedHeight(theme.px(20));
    keepRoom(m_time);
    row->addWidget(m_time, 1);
    m_takeBack = kit::button(theme, tr("Take back (⌫)"), "");
    m_takeBack->setObjectName(QStringLiteral("trials.take_back"));
    m_takeBack->setFocusPolicy(Qt::NoFocus); // keys belong to the screen
    connect(m_takeBack, &QPushButton::clicked, this, [this] {
        if (running())
            m_live->takeBack();
    });
    m_enough = kit::button(theme, tr("Next (Enter)"), "primary");
    m_enough->setObjectName(QStringLiteral("trials.enough"));
    m_enough->setFocusPolicy(Qt::NoFocus);
    connect(m_enough, &QPushButton::clicked, this, &TrialsScreen::stripAction);
    for (QPushButton* button : {m_takeBack, m_enough}) {
        keepRoom(button);
        row->addWidget(button);
    }
    return strip;
}

void TrialsScreen::buildLive() {
    m_live->condition().stimulus.attribute == psychophysics::Attribute::apex ? buildApex() : buildPlaces();
}

void TrialsScreen::buildApex() {
    m_apex = new ApexStage(context().theme(), m_live->level(),
                           {m_live->training().felt(), false, m_live->design().fidelity.peakForce_N});
    m_apex->setObjectName(QStringLiteral("trials.apex"));
    static_cast<QVBoxLayout*>(m_trial->layout())->addWidget(m_apex, 1);
    connect(m_apex, &ApexStage::markAsked, this, &TrialsScreen::mark);
}

QWidget& TrialsScreen::area() {
    return m_apex ? m_apex->area() : *m_places;
}
QObject& TrialsScreen::source() {
    return m_apex ? m_apex->source() : *m_places;
}

Handling TrialsScreen::handling() const {
    return handlingOf(m_live->condition().stimulus.attribute);
}

StudyHand TrialsScreen::hand() const {
    return {m_live->training().pointer() != nullptr, m_live->training().felt()};
}

LetGo TrialsScreen::letGo() const {
    LetGo where;
    where.drawn = m_live->design().trial.visibleObjects;
    if (const auto* parameters = m_live->level().parameters.find<simulation::ComparisonParameters>()) {
        where.below_m = parameters->hookLeave_m;
        where.press_m = simulation::ComparedObject::kPress_N /
                        std::max(1.0, parameters->object.stiffness_N_per_m); // as LiveStudy notices it
    }
    return where;
}

void TrialsScreen::buildPlaces() {
    const Theme& theme = context().theme();
    const psychophysics::Condition& condition = m_live->condition();
    PlacesSetup setup;
    setup.places = psychophysics::placesOf(condition.task);
    setup.visible = m_live->design().trial.visibleObjects;
    if (const auto* parameters = m_live->level().parameters.find<simulation::ComparisonParameters>()) {
        setup.spacing_m = parameters->spacing_m;
        setup.padRadius_m = parameters->padRadius_m;
        const simulation::GripZone grip = simulation::gripZone(*parameters);
        setup.gripHeight_m = grip.height_m;
        setup.gripRadius_m = grip.radius_m;
        setup.letGoHeight_m = simulation::letGoHeight_m(*parameters);
        setup.hooked = simulation::isHooked(parameters->attribute);
        setup.lifted = handling() == Handling::lift;
    }
    setup.names = AnswerPanel::placeNames(setup.places);
    m_places = new PlacesView(theme, setup);
    m_places->setObjectName(QStringLiteral("trials.places"));
    m_answers = new AnswerPanel(theme, condition.task, condition.stimulus.attribute);
    connect(m_answers, &AnswerPanel::begun, this, [this] {
        if (running())
            m_live->beginAnswer();
    });
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
    // The filter follows the page to any window, because keys typed at the desk are not answers.
    m_keys = new KeyFilter(*m_page);
    m_keys->setEarly([this] { return keysAreEarly(); });
    connect(m_keys, &KeyFilter::stopAsked, this, &TrialsScreen::stopForce);
    connect(m_keys, &KeyFilter::pauseAsked, this, [this] {
        if (isPage() && (m_card ? m_card->readOn() : m_break->readOn()))
            return; // Space reads to the end first
        if (auto* button = qobject_cast<QAbstractButton*>(QApplication::focusWidget()); button && isPage())
            button->click(); // Space presses the focused button, like Enter
        else if (!goOnByKey()) {
            m_pausedByKey = true;
            pauseOrResume();
        }
    });
    connect(m_keys, &KeyFilter::rearmAsked, this, &TrialsScreen::rearm);
    connect(m_keys, &KeyFilter::markAsked, this, [this] {
        if (!m_page->isVisible() || goOnByKey()) // keys at the desk are not answers
            return;
        if (!m_enough->isHidden())
            stripAction();
        else if (m_answers)
            m_answers->enterKey();
        else
            mark();
    });
    connect(m_keys, &KeyFilter::leaveSceneAsked, this, [this](bool) {
        m_page->window()->activateWindow();
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
    if (m_card) { // the first movement starts, once there is no more to read
        if (!down || m_card->scroll(key) || !m_card->isRead())
            return;
        const std::vector<int> movements = studyMovementKeys(hand());
        if (std::find(movements.begin(), movements.end(), key) != movements.end())
            go();
        return;
    }
    if (key == Qt::Key_Backspace && down && running() && m_live->view().mayTakeBack) {
        m_live->takeBack();
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
    keys.push_back(Qt::Key_Backspace);
    keys.push_back(Qt::Key_F2);
    keys.push_back(Qt::Key_T);
    if (devices::PointerMailbox* pointer = m_live->training().pointer()) {
        m_hand = std::make_unique<PointerControl>(*pointer, context().theme().scale());
        for (const int key : m_hand->keys())
            keys.push_back(key);
        m_pointer = std::make_unique<ScenePointer>(*m_hand, source(), area());
        connect(m_pointer.get(), &ScenePointer::marked, this, [this] {
            // Clicking an object is not an answer, and an early click is not a mark.
            if (m_apex && m_live->view().canAnswer && !m_early.areEarly(m_clock.elapsed()))
                m_hand->click();
        });
        connect(m_pointer.get(), &ScenePointer::captureAsked, this, &TrialsScreen::capturePointer);
    }
    m_keys->setScene(&source());
    m_keys->setToolKeys(keys);
    m_keys->setActive(true);
}

} // namespace chiron::desktop
