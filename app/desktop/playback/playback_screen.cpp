// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/playback/playback_screen.h"

#include "database/repositories/session_repository.h"
#include "desktop/frame/app_context.h"
#include "desktop/playback/comment_panel.h"
#include "desktop/playback/playback_plots.h"
#include "desktop/playback/playback_scene.h"
#include "desktop/playback/scrubber.h"
#include "desktop/plots/session_token_words.h"
#include "desktop/results/results_place.h"
#include "desktop/scene3d/scene_loader.h"
#include "desktop/sessions/session_words.h"
#include "desktop/sessions/void_dialog.h"
#include "desktop/widgets/state_panel.h"

#include <QKeyEvent>
#include <QLabel>
#include <QTabWidget>
#include <QVBoxLayout>

namespace chiron::desktop {

namespace {
constexpr double kPlaybackLeadIn_s = 3.0; // to see what led to a commented moment
}

PlaybackScreen::PlaybackScreen(AppContext& context, const Place& place) : Screen(context, place) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    m_panel = new StatePanel(context.theme());
    column->addWidget(m_panel);
    connect(&m_clock, &PlaybackClock::moved, this, &PlaybackScreen::showMoment);
    connect(&m_clock, &PlaybackClock::playingChanged, this, [this] { notePlace(); });
}

PlaybackScreen::~PlaybackScreen() {
    for (const auto& work : {m_work, m_ghostWork})
        if (work)
            work->cancel();
}

QString PlaybackScreen::title() const {
    return tr("Playback");
}

QString PlaybackScreen::help() const {
    return tr("A session as it was recorded.\n\nSpace plays and pauses. The arrow keys move one frame "
              "forward or back, with Shift one "
              "second, with Ctrl to the next or previous event; Home and End jump to the beginning and the "
              "end. Clicking in a plot jumps "
              "to that time. Plus and minus zoom the plots, 0 shows the whole session.\n\nC writes a comment "
              "at the moment shown.\n\nPauses "
              "are hatched, and skipped unless you switch that off. Triangles on the time bar are penalties, "
              "flags are answers, squares below it are "
              "comments.\n\nChoose a second session to see it beside this one: each of its trials starts "
              "together with the trial here and "
              "is drawn in the same place.") +
           QStringLiteral("\n\n") +
           tr("A cross in the scene shows where tissue gave way, or where an object of a study came off the "
              "tool.");
}

std::vector<ScreenCommand> PlaybackScreen::commands() {
    std::vector<ScreenCommand> list{
        {tr("Play or pause"), QKeySequence(Qt::Key_Space), [this] { m_clock.toggle(); }, false},
        {tr("One frame forward"), QKeySequence(Qt::Key_Right), [this] { m_clock.step(1); }, false},
        {tr("One frame back"), QKeySequence(Qt::Key_Left), [this] { m_clock.step(-1); }, false},
        {tr("Next event"), QKeySequence(Qt::CTRL | Qt::Key_Right), [this] { seekMark(1); }, false},
        {tr("Previous event"), QKeySequence(Qt::CTRL | Qt::Key_Left), [this] { seekMark(-1); }, false},
        {tr("Write a comment at this moment"), QKeySequence(Qt::Key_C), [this] { writeComment(); }, false},
        {tr("Zoom in on the plots"), QKeySequence(Qt::Key_Plus), [this] { zoomPlots(Qt::Key_Plus); }, false},
        {tr("Zoom out of the plots"), QKeySequence(Qt::Key_Minus), [this] { zoomPlots(Qt::Key_Minus); },
         false},
        {tr("The whole session in the plots"), QKeySequence(Qt::Key_0), [this] { zoomPlots(Qt::Key_0); },
         false},
        {tr("To the beginning"), QKeySequence(Qt::Key_Home), [this] { m_clock.seek(0.0); }, false},
        {tr("To the end"), QKeySequence(Qt::Key_End), [this] { m_clock.seek(m_clock.duration_s()); }, false}};
    if (const QString results = m_data ? resultsCommand(context(), m_data->record.summary) : QString();
        !results.isEmpty())
        list.push_back({results, {}, [this] { openResults(); }});
    return list;
}

database::SessionId PlaybackScreen::sessionId() const {
    return place().parameters.value(QStringLiteral("session")).toLongLong();
}

void PlaybackScreen::enter() {
    load();
}

void PlaybackScreen::load() {
    database::Database& database = context().site().database();
    m_work = context().background().run(
        this,
        [&database, actor = context().actor(),
         id = sessionId()](WorkToken& token) -> core::Result<PlaybackData> {
            // This loads what the scene needs, so that the window does not wait for it later.
            scene3d::findWhyFlat();
            auto connection = database.openReader();
            CHIRON_TRY(connection);
            return loadPlayback(**connection, actor, id, [&token](double part) {
                token.setProgress(static_cast<int>(100 * part), 100);
                return !token.cancelled();
            });
        },
        [this](core::Result<PlaybackData> loaded) {
            if (loaded)
                return showData(std::move(*loaded));
            // Trying again would give the same result.
            if (loaded.error().code == core::ErrorCode::doesNotHold)
                return m_panel->showError(
                    tr("This recording is damaged and cannot be played back. Its scores are kept."),
                    loaded.error());
            m_panel->showError(tr("This session could not be opened"), loaded.error(), [this] { load(); });
        });
    m_panel->showLoading(tr("Reading the recording …"), m_work);
}

void PlaybackScreen::showData(PlaybackData loaded) {
    const auto toDebrief = [this] {
        context().navigator().go(QStringLiteral("debrief"),
                                 {{QStringLiteral("session"), qlonglong(sessionId())}});
    };
    if (loaded.record.summary.recordingErased)
        return m_panel->showEmpty(tr("The recording was erased"),
                                  tr("It was erased at the person's request. The scores are kept."),
                                  tr("Open the debrief"), toDebrief);
    if (loaded.track.empty())
        return m_panel->showEmpty(tr("Nothing was recorded"),
                                  tr("This session ended before its first sample. It is kept and listed."),
                                  tr("Open the debrief"), toDebrief);
    m_data = std::move(loaded);
    readMoment();
    build();
    m_panel->showContent();
    m_clock.setDuration(m_data->track.duration_s);
    const double begin_s = place().parameters.contains(QStringLiteral("at_tick"))
                               ? std::max(0.0, m_moment_s - kPlaybackLeadIn_s)
                               : 0.0;
    m_clock.seek(place().parameters.value(QStringLiteral("at_s"), begin_s).toDouble());
    m_scrubber->setFocus();
    // The scene is created after this page has been painted.
    QMetaObject::invokeMethod(this, &PlaybackScreen::makeScene, Qt::QueuedConnection);
    loadComments();
    loadGhosts();
}

void PlaybackScreen::readMoment() {
    const QVariantMap& asked = place().parameters;
    m_moment_s = asked.contains(QStringLiteral("at_tick"))
                     ? m_data->track.timeOfTick(asked.value(QStringLiteral("at_tick")).toULongLong())
                     : asked.value(QStringLiteral("caption_s"), -1.0).toDouble();
}

scene3d::SceneSetup PlaybackScreen::sceneSetup() const {
    scene3d::SceneSetup setup = sceneSetupOf(m_data->setup, m_data->track.forceLimit_N, context().theme());
    m_data->layer->setUp(setup);
    return setup;
}

void PlaybackScreen::makeScene() {
    scene3d::LoadedScene loaded = scene3d::makeSceneView(sceneSetup(), this);
    m_scene = std::move(loaded.view);
    m_sceneHolder->addWidget(m_scene->widget());
    m_scene->widget()->setObjectName(QStringLiteral("playback.scene"));
    m_scene->widget()->setAccessibleName(tr("The scene at this moment"));
    m_scene->inputSource()->installEventFilter(this);
    showMoment(m_clock.position_s());
    // After a link to a moment, playback starts before it and pauses there.
    if (m_moment_s > m_clock.position_s()) {
        m_stopAt_s = m_moment_s;
        m_clock.play();
    }
}

void PlaybackScreen::showMoment(double t_s) {
    if (!m_data)
        return;
    m_scrubber->setPosition(t_s);
    m_plots->showCursor(t_s);
    m_comments->setMoment(t_s);
    if (m_scene) {
        auto state = sceneStateAt(m_data->track, m_ghost ? &*m_ghost : nullptr, t_s, m_data->layer.get());
        state.note = captionAt(t_s);
        m_scene->show(state);
    }
    m_readout->setText(m_data->layer->readout(m_data->track, m_data->track.at(t_s), t_s, context().locale()));
    if (m_stopAt_s && t_s >= *m_stopAt_s) {
        m_stopAt_s.reset();
        m_clock.pause(); // at the requested moment
    }
    if (!m_clock.playing())
        notePlace();
}

scene3d::SceneNote PlaybackScreen::captionAt(double t_s) const {
    constexpr double kSaid_s = 2.0;
    constexpr int kLongest = 90; // one line in the scene; the full text stands beside it
    QString caption = place().parameters.value(QStringLiteral("caption")).toString().simplified();
    if (caption.size() > kLongest)
        caption = caption.left(kLongest - 1).trimmed() + QStringLiteral("…");
    const double from_s = m_moment_s;
    if (caption.isEmpty() || t_s < from_s - 0.5 * PlaybackClock::kStep_s || t_s > from_s + kSaid_s)
        return {};
    return {scene3d::SceneNote::Kind::said, caption, {}};
}

void PlaybackScreen::notePlace() {
    QVariantMap parameters = context().navigator().current().parameters;
    if (parameters.value(QStringLiteral("session")).toLongLong() != sessionId())
        return; // another screen has already been requested
    parameters.insert(QStringLiteral("at_s"), m_clock.position_s());
    context().navigator().note(parameters);
}

bool PlaybackScreen::handleKey(QKeyEvent* event) {
    if (!m_data)
        return false;
    const bool second = (event->modifiers() & Qt::ShiftModifier) != 0;
    const bool mark = (event->modifiers() & Qt::ControlModifier) != 0;
    const int direction = event->key() == Qt::Key_Left ? -1 : 1;
    if (mark && event->key() != Qt::Key_Left && event->key() != Qt::Key_Right)
        return false; // Ctrl+C copies; Ctrl+0 has no meaning
    switch (event->key()) {
    case Qt::Key_Space:
        m_clock.toggle();
        return true;
    case Qt::Key_Left:
    case Qt::Key_Right:
        if (mark)
            seekMark(direction);
        else if (second)
            m_clock.seek(m_clock.position_s() + direction);
        else
            m_clock.step(direction);
        return true;
    case Qt::Key_C:
        writeComment();
        return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal: // plus without Shift, on many keyboards
    case Qt::Key_Minus:
    case Qt::Key_0:
        zoomPlots(event->key());
        return true;
    case Qt::Key_Home:
        m_clock.seek(0.0);
        return true;
    case Qt::Key_End:
        m_clock.seek(m_clock.duration_s());
        return true;
    default:
        return false;
    }
}

void PlaybackScreen::keyPressEvent(QKeyEvent* event) {
    if (!handleKey(event))
        Screen::keyPressEvent(event);
}

void PlaybackScreen::resizeEvent(QResizeEvent* event) {
    Screen::resizeEvent(event);
    fitScene();
}

bool PlaybackScreen::eventFilter(QObject* watched, QEvent* event) {
    // The 3D scene is a window of its own, whose key events do not propagate to this widget. The page would
    // also scroll on arrow keys, which here belong to the recording.
    if (event->type() == QEvent::KeyPress && handleKey(static_cast<QKeyEvent*>(event)))
        return true;
    return Screen::eventFilter(watched, event);
}

void PlaybackScreen::seekMark(int direction) {
    if (!m_data)
        return;
    constexpr double kHere_s = 0.5 * PlaybackClock::kStep_s;
    const double now_s = m_clock.position_s();
    std::optional<double> target_s;
    for (const session::PlaybackMark& mark : m_data->track.marks) {
        if (mark.kind == session::mark_kinds::kContact)
            continue;
        if (direction > 0 && mark.t_s > now_s + kHere_s && !target_s)
            target_s = mark.t_s;
        if (direction < 0 && mark.t_s < now_s - kHere_s)
            target_s = mark.t_s;
    }
    if (target_s)
        m_clock.seek(*target_s);
}

void PlaybackScreen::loadComments() {
    database::Database& database = context().site().database();
    context().background().run(
        this,
        [&database, actor = context().actor(),
         id = sessionId()](WorkToken&) -> core::Result<std::vector<NamedComment>> {
            auto connection = database.openReader();
            CHIRON_TRY(connection);
            return desktop::loadComments(**connection, actor, id);
        },
        [this](core::Result<std::vector<NamedComment>> comments) {
            if (!comments)
                return context().messages().error(tr("The comments could not be read."), comments.error(),
                                                  Tried::reading);
            std::vector<double> moments_s;
            for (const NamedComment& named : *comments)
                if (named.comment.tick)
                    moments_s.push_back(m_data->track.timeOfTick(*named.comment.tick));
            m_scrubber->setComments(std::move(moments_s));
            m_comments->show(std::move(*comments), context().actor().personId(),
                             [this](std::uint64_t tick) { return m_data->track.timeOfTick(tick); });
            answerAsked();
        });
}

// Asks only once, so that a cancelled reply is not offered again when the comments are reloaded.
void PlaybackScreen::answerAsked() {
    QVariantMap parameters = context().navigator().current().parameters;
    const QVariant asked = parameters.take(QStringLiteral("reply"));
    if (!asked.isValid() || parameters.value(QStringLiteral("session")).toLongLong() != sessionId())
        return;
    context().navigator().note(parameters);
    m_tabs->setCurrentWidget(m_comments);
    m_comments->reply(asked.toLongLong());
}

void PlaybackScreen::writeComment() {
    if (!m_data || !m_comments->mayAdd())
        return;
    m_clock.pause();
    m_tabs->setCurrentWidget(m_comments);
    m_comments->write();
}

void PlaybackScreen::zoomPlots(int key) {
    if (!m_plots)
        return;
    if (key == Qt::Key_0)
        m_plots->zoomWhole();
    else
        m_plots->zoom(key == Qt::Key_Minus ? 2.0 : 0.5);
}

void PlaybackScreen::addComment(const QString& text, std::optional<std::uint64_t> tick) {
    database::Database& database = context().site().database();
    context().background().run(
        this,
        [&database, actor = context().actor(), id = sessionId(), words = text.toStdString(),
         tick](WorkToken&) {
            return database.write([&](database::WriteContext& write) {
                return database::SessionRepository(write.connection(), actor).addComment(id, words, tick);
            });
        },
        [this](core::Result<std::int64_t> added) {
            if (!added)
                return context().messages().error(tr("The comment was not saved. Its text is still here."),
                                                  added.error());
            m_comments->clearDraft();
            loadComments();
            const database::SessionSummary& session = m_data->record.summary;
            if (session.person != context().actor().personId() &&
                session.person != database::Actor::kSimulatedPerson)
                context().messages().done(
                    (context().has(database::Role::trainer)
                         ? tr("The comment is saved, and the session counts as reviewed. %1 will see it on "
                              "Home.")
                         : tr("The comment is saved. %1 will see it on Home."))
                        .arg(QString::fromStdString(session.personName)));
            m_comments->setMayReview(false);
        });
}

void PlaybackScreen::openResults() {
    context().navigator().go(resultsPlace(m_data->record.summary));
}

void PlaybackScreen::askDecision() {
    m_clock.pause();
    const database::SessionSummary& session = m_data->record.summary;
    const bool voided = session.state == database::SessionState::voided;
    auto* dialog = new VoidSessionDialog(
        context().theme(), session.id, QString::fromStdString(session.personName),
        SessionWords::which(
            session, exerciseTitle(context().site().catalogue(), session.exercise, context().language()),
            context().locale()),
        this, voided ? VoidSessionDialog::Decision::countAgain : VoidSessionDialog::Decision::voidIt);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, voided] {
        voided ? countAgain(dialog->reason()) : declareVoid(dialog->reason());
    });
    dialog->open();
}

void PlaybackScreen::declareVoid(const QString& reason) {
    decide(&database::SessionRepository::voidSession, reason,
           tr("Session %1 is voided. Its recording is kept; it no longer counts.").arg(sessionId()),
           tr("Session %1 was not voided; nothing was changed.").arg(sessionId()));
}

void PlaybackScreen::countAgain(const QString& reason) {
    decide(&database::SessionRepository::reinstateSession, reason,
           tr("Session %1 counts again. Its history still shows that it was void.").arg(sessionId()),
           tr("Session %1 is still void; nothing was changed.").arg(sessionId()));
}

void PlaybackScreen::decide(core::Result<void> (database::SessionRepository::*decision)(database::SessionId,
                                                                                        const std::string&),
                            const QString& reason, const QString& done, const QString& failed) {
    database::Database& database = context().site().database();
    context().background().run(
        this,
        [&database, actor = context().actor(), id = sessionId(), decision,
         words = reason.toStdString()](WorkToken&) {
            return database.write([&](database::WriteContext& write) {
                database::SessionRepository sessions(write.connection(), actor);
                return (sessions.*decision)(id, words);
            });
        },
        [this, done, failed](core::Result<void> stored) {
            if (!stored)
                return context().messages().error(failed, stored.error());
            context().messages().done(done);
            m_clock.pause();
            context().navigator().replace(context().navigator().current()); // rebuilt in its new state
        });
}

} // namespace chiron::desktop
