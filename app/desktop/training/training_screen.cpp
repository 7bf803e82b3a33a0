// SPDX-License-Identifier: GPL-3.0-or-later
// A session from preparing to storing.
#include "desktop/training/training_screen.h"

#include "desktop/frame/app_context.h"
#include "desktop/scene3d/scene_loader.h"
#include "desktop/training/force_notice.h"
#include "desktop/training/header_bar.h"
#include "desktop/training/info_view.h"
#include "desktop/training/key_filter.h"
#include "desktop/training/ready_card.h"
#include "desktop/training/scene_feed.h"
#include "desktop/training/side_panel.h"
#include "desktop/training/sound_sign.h"
#include "desktop/training/training_words.h"
#include "desktop/widgets/state_panel.h"

#include <QApplication>
#include <QLabel>

namespace chiron::desktop {

namespace {
// If the scene is never drawn (a covered window), the session starts after this time.
constexpr int kSceneWait_ms = 4000;
constexpr int kSilentWords_ms = 10'000;
constexpr double kPointerTold_s = 6.0; // seconds of work: long enough to be read during the first movements
} // namespace

TrainingScreen::~TrainingScreen() {
    m_keys->setActive(false);
    m_pointer.reset();
    m_hand.reset();
    m_control.reset();
    m_feed.reset(); // ends what still runs and waits until it is stored
    context().setTrialRuns(false);
}

void TrainingScreen::enter() {
    m_card ? m_card->takeFocus() : setFocus();
    if (!m_level)
        fail({core::ErrorCode::notFound, "exercise \"" + m_plan.exercise.toStdString() + "\": no level " +
                                             std::to_string(m_plan.level)});
}

void TrainingScreen::paintEvent(QPaintEvent* event) {
    Screen::paintEvent(event);
    if (m_painted || !m_level)
        return;
    m_painted = true; // the session is prepared after the screen has been shown
    QTimer::singleShot(0, this, &TrainingScreen::prepare);
}

void TrainingScreen::prepare() {
    context().background().run(
        this,
        [plan = m_plan, level = *m_level](WorkToken&) {
            (void)scene3d::findWhyFlat(); // loads the 3D libraries while the window stays responsive
            return requestOf(plan, level);
        },
        [this](core::Result<session::TrainingRequest> request) { take(std::move(request)); });
}

void TrainingScreen::take(core::Result<session::TrainingRequest> request) {
    if (!request) {
        fail(request.error());
        return;
    }
    m_request = std::move(*request);
    const auto kind = session::exerciseKind(m_level->exercise);
    m_answer.emplace(*m_level, context().locale(),
                     kind ? (*kind)->makeSurfaces(*m_level, m_request->seed) : nullptr);
    if (m_wentAhead)
        loadScene();
}

void TrainingScreen::loadScene() {
    if (m_cues.sound)
        if (const QString why = m_sound.open(); !why.isEmpty()) {
            m_header->setSilent(why);
            const QString keys = m_keysText->text();
            // The reason is shown once, in full sentences but unobtrusively, and removed again.
            m_keysText->setText(tr("%1 %2").arg(keys, why));
            QTimer::singleShot(kSilentWords_ms, this, [this, keys] { m_keysText->setText(keys); });
        }
    m_setup =
        sceneSetupOf(*m_level, m_cues, context().theme(), m_plan.workspace.leftHanded, m_plan.depthOfField);
    auto loaded = scene3d::makeSceneView(m_setup, m_pages);
    m_scene = std::move(loaded.view);
    m_scene->widget()->setAccessibleName(tr("Scene"));
    m_pages->addWidget(m_scene->widget());
    m_pages->setCurrentWidget(m_scene->widget());
    m_stage->showContent();
    m_keys->setScene(m_scene->inputSource());
    m_scene->onFirstFrame([alive = QPointer<TrainingScreen>(this)] {
        if (alive)
            alive->begin();
    });
    QTimer::singleShot(kSceneWait_ms, this, &TrainingScreen::begin);
}

void TrainingScreen::begin() {
    if (m_feed || !m_request)
        return;
    auto feed = LiveFeed::start(context().site().database(), actorOf(m_plan, context().actor()),
                                std::move(*m_request));
    m_request.reset();
    if (!feed) {
        fail(feed.error());
        return;
    }
    m_feed = std::move(*feed);
    m_control.emplace(m_feed->training());
    connect(m_feed.get(), &LiveFeed::frame, this, &TrainingScreen::onFrame);
    connect(m_feed.get(), &LiveFeed::finished, this, &TrainingScreen::onFinished);
    connectPointer();
    connect(qGuiApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
        if (state != Qt::ApplicationActive && running() && m_pointer && !m_control->held())
            pauseOrResume(); // the pointer belongs to another program now
    });
    context().setTrialRuns(true);
    m_keys->setActive(true);
    m_controls->setRunning(true);
    m_control->begin();
    goOn();
}

void TrainingScreen::connectPointer() {
    if (!m_live)
        return;
    m_hand = m_live->takeHand(m_feed->training(), [this](int tool) {
        if (m_activeText)
            m_activeText->setText(m_live->activeText(tool));
    });
    if (m_plan.ownHand())
        m_keys->setToolKeys(handKeys());
    if (!m_hand)
        return; // nobody moves the tool with mouse and keyboard
    m_pointer = std::make_unique<ScenePointer>(*m_hand, *m_scene->inputSource(), *m_scene->widget());
    connect(m_pointer.get(), &ScenePointer::marked, this, [this] {
        if (!marksAreEarly())
            m_hand->click();
    });
    connect(m_pointer.get(), &ScenePointer::captureAsked, this, [this] {
        if (running() && !m_control->held())
            goOn();
    });
}

std::vector<int> TrainingScreen::handKeys() const {
    std::vector<int> keys;
    if (m_hand)
        keys.assign(m_hand->keys().begin(), m_hand->keys().end());
    for (const LiveCommand& command : m_live->commands())
        keys.push_back(command.key);
    return keys;
}

void TrainingScreen::onFrame() {
    const haptics::DisplayState& state = m_feed->state();
    if (m_over || state.tools == 0)
        return;
    if (m_start_ns == 0)
        m_start_ns = state.now_ns;
    const bool wasHeld = m_control->held();
    m_control->look(state);
    if (m_control->held() && !wasHeld)
        hold();
    m_early.look(state, m_clock.elapsed());
    if (m_hand)
        m_hand->feel(state);
    if (m_pointer && !m_control->held() && !m_storing && QApplication::activeModalWidget())
        pauseOrResume(); // a dialog covers the scene, so nobody can work
    const bool stopped = m_control->stopped();
    const haptics::DisplayState shown = stopped ? withoutForce(state) : state;
    scene3d::SceneState drawn = sceneStateOf(shown, m_cues, m_start_ns);
    if (m_hand && m_tools > 1)
        drawn.activeTool = m_hand->activeTool();
    if (m_live)
        m_live->show(state, m_feed->samples(), drawn);
    takeAnswer(drawn);
    drawn.note = noteNow();
    m_drawn = drawn;
    m_scene->show(m_drawn);
    m_header->show(shown);
    m_info->show(shown, stopped ? std::span<const session::LiveSample>() : m_feed->samples());
    m_sound.play(state, m_feed->contacts(), m_control->held(),
                 [this](const haptics::DisplayState& of, std::size_t tool) {
                     return m_live ? m_live->lean_rad(of, tool) : 0.0;
                 });
    if (m_soundSign)
        m_soundSign->show(m_sound.cues(), m_sound.sounding(), state.now_ns);
    showControls();
    if (m_plan.practises() && !m_storing && m_feed->worked_s() >= m_plan.practice_s)
        m_control->end();
    if (state.ended && !m_storing) {
        m_storing = true;
        hold();
        m_controls->setRunning(false);
        beginLastLook();
    }
}

/// Shows the result of the last trial in the scene for the same time as others, while the session is stored
/// and scored.
void TrainingScreen::beginLastLook() {
    const haptics::DisplayState& state = m_feed->state();
    const bool looks =
        m_plan.ownHand() && state.phase == core::TrialPhase::finished && m_answer->holdsNext(state.now_ns);
    m_lastLook.setSingleShot(true);
    connect(&m_lastLook, &QTimer::timeout, this,
            [this] { m_over ? showOutcome() : m_stage->showLoading(storingText()); });
    if (looks)
        m_lastLook.start(static_cast<int>(AnswerNote::kHeld_ns / 1'000'000));
    else
        m_stage->showLoading(storingText());
}

QString TrainingScreen::storingText() {
    return tr("Storing and scoring the session …");
}

/// Shows the result of the trial that has just ended, as text and in the scene. If a person works with their
/// own hand, the next trial waits while they look.
void TrainingScreen::takeAnswer(scene3d::SceneState& drawn) {
    const haptics::DisplayState& state = m_feed->state();
    m_answer->take(state, m_feed->samples());
    m_answer->show(state.now_ns, drawn);
    if (m_plan.ownHand())
        m_control->keepNext(m_answer->holdsNext(state.now_ns) && state.phase == core::TrialPhase::between);
}

scene3d::SceneNote TrainingScreen::noteNow() const {
    using Kind = scene3d::SceneNote::Kind;
    const haptics::DisplayState& state = m_feed->state();
    if (m_control->stopped())
        return {Kind::stopped, tr("Force is stopped"),
                tr("The clock is stopped. Press Re-arm or R to go on.")};
    if (m_control->paused())
        return {Kind::paused, tr("Paused"), tr("The clock is stopped. Press Resume or Space to go on.")};
    if (const scene3d::SceneNote said = m_answer->note(state.now_ns); said.kind != Kind::none)
        return said;
    if (const scene3d::SceneNote said = m_live ? m_live->note(state.now_ns) : scene3d::SceneNote();
        said.kind != Kind::none)
        return said;
    if (const scene3d::SceneNote said = practiceNote(); said.kind != Kind::none)
        return said;
    return pointerNote();
}

scene3d::SceneNote TrainingScreen::pointerNote() const {
    if (m_storing || !m_pointer || !m_pointer->captured() || m_feed->worked_s() > kPointerTold_s)
        return {};
    if (context()
            .settings()
            .ofPerson(context().actor().personId(), QString::fromLatin1(kPointerKnown), false)
            .toBool())
        return {};
    return {
        scene3d::SceneNote::Kind::said, tr("The mouse moves the instrument. Space pauses and frees it."), {}};
}

void TrainingScreen::showPointer() {
    if (!m_pointerText || !m_pointer)
        return;
    QString text;
    if (m_pointer->captured())
        text = tr("Space frees the mouse");
    else if (!m_control->held() && !m_storing)
        text = tr("Click in the scene to go on");
    m_pointerText->setText(text);
}

void TrainingScreen::showControls() {
    const haptics::DisplayState& state = m_feed->state();
    const bool felt = m_feed->training().felt();
    if (m_notice->show(forceWords(
            state,
            {felt, m_plan.ownHand(), m_control->paused(), m_control->stopped(), isEndoscope(), isGrasper()},
            context().locale())))
        m_side->fit();
    const bool latched = m_control->stopped() || state.force == core::ForceState::stopped ||
                         state.force == core::ForceState::fault;
    m_controls->setMain(latched               ? ControlBar::Main::rearm
                        : m_control->paused() ? ControlBar::Main::resume
                                              : ControlBar::Main::pause);
    // The card has a button to go on. Force is restored only by the one below it.
    m_controls->setMainShown(!m_card || latched);
    if (m_card)
        m_card->setHeld(m_control->stopped(), pausedClock());
    m_controls->setResumeHere(!m_card && felt && m_plan.ownHand() &&
                              state.force == core::ForceState::arming &&
                              state.waitsFor == haptics::ArmingWait::smallRequest);
    m_keys->setHeld(m_control->held());
    showPointer();
}

void TrainingScreen::onFinished() {
    m_sound.silence();
    m_over = true;
    hold();
    m_keys->setActive(false);
    m_controls->setRunning(false);
    context().setTrialRuns(false);
    if (!m_lastLook.isActive())
        showOutcome();
}

void TrainingScreen::showOutcome() {
    const core::Result<session::TrainingResult>& result = m_feed->training().result();
    if (!result) {
        fail(result.error());
    } else if (m_plan.practises() && !m_again) {
        m_plan.practice_s = 0.0;
        QVariantMap plan = m_plan.toMap();
        plan.insert(QString::fromLatin1(kPractised), true);
        // This continues to the practised level, with its card.
        context().navigator().replace({QStringLiteral("training"), plan});
    } else if (m_again) {
        QVariantMap plan = m_plan.toMap();
        plan.insert(QString::fromLatin1(kAtOnce), true);
        // This is a new screen, so that every value starts afresh.
        context().navigator().replace({QStringLiteral("training"), plan});
    } else {
        context().navigator().replace({QStringLiteral("debrief"),
                                       {{QStringLiteral("session"), qlonglong(result->session)},
                                        {QString::fromLatin1(kJustEnded), m_plan.ownHand()}}});
    }
}

void TrainingScreen::fail(const core::Error& error) {
    m_over = true;
    for (QWidget* part : {static_cast<QWidget*>(m_side), static_cast<QWidget*>(m_controls), m_foot})
        part->hide(); // there is nothing to control or measure
    m_stage->showError(
        tr("The session could not be run"), error,
        [this] {
            QVariantMap parameters = m_plan.toMap();
            context().navigator().replace({QStringLiteral("exercise_setup"), parameters});
        },
        Tried::saving);
}

} // namespace chiron::desktop
