// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/app_context.h"
#include "desktop/playback/playback_plots.h"
#include "desktop/playback/playback_screen.h"
#include "desktop/plots/session_token_words.h"
#include "desktop/scene3d/scene_view.h"
#include "scoring/metric_catalogue.h"

#include <QComboBox>

// The second session (ghost) beside the first.
namespace chiron::desktop {

void PlaybackScreen::loadGhosts() {
    const catalogue::ExerciseLevel& level = m_data->setup.level;
    std::string metric = !level.gates.empty()    ? level.gates.front().metric
                         : level.metrics.empty() ? std::string()
                                                 : level.metrics.front().id;
    const scoring::MetricDefinition* definition = scoring::findMetric(metric);
    const bool lowerIsBetter = !definition || definition->direction != scoring::Direction::higherIsBetter;
    database::Database& database = context().site().database();
    context().background().run(
        this,
        [&database, actor = context().actor(), record = m_data->record, metric = std::move(metric),
         lowerIsBetter](WorkToken&) -> core::Result<std::vector<GhostCandidate>> {
            auto connection = database.openReader();
            CHIRON_TRY(connection);
            return listGhosts(**connection, actor, record, metric, lowerIsBetter);
        },
        [this](core::Result<std::vector<GhostCandidate>> candidates) {
            if (candidates)
                showGhosts(*candidates);
            else
                context().messages().error(tr("The sessions for comparison could not be loaded."),
                                           candidates.error(), Tried::reading);
        });
}

void PlaybackScreen::showGhosts(const std::vector<GhostCandidate>& candidates) {
    const bool mine = m_data->record.summary.person == context().actor().personId();
    for (const GhostCandidate& candidate : candidates) {
        const QString who = whoText(candidate.summary);
        const QString when = whenText(candidate.summary, context().locale());
        QString text = tr("%1, %2").arg(who, when);
        if (candidate.role == GhostRole::ownFirst)
            text = mine ? tr("My first attempt, %1").arg(when) : tr("First attempt of %1, %2").arg(who, when);
        if (candidate.role == GhostRole::ownBest)
            text = mine ? tr("My best attempt, %1").arg(when) : tr("Best attempt of %1, %2").arg(who, when);
        m_ghostChoice->addItem(text, qlonglong(candidate.summary.id));
    }
    if (candidates.empty())
        m_ghostChoice->setItemText(0, tr("No other completed session of this level"));
    m_ghostChoice->setEnabled(!candidates.empty());
    const int wanted =
        m_ghostChoice->findData(place().parameters.value(QStringLiteral("ghost"), qlonglong(0)).toLongLong());
    if (wanted > 0) {
        m_ghostChoice->setCurrentIndex(wanted);
        chooseGhost();
    }
}

void PlaybackScreen::chooseGhost() {
    if (m_ghostWork)
        m_ghostWork->cancel();
    const database::SessionId id = m_ghostChoice->currentData().toLongLong();
    QVariantMap parameters = context().navigator().current().parameters;
    parameters.insert(QStringLiteral("ghost"), qlonglong(id));
    context().navigator().note(parameters);
    m_ghost.reset();
    m_plots->setGhost({}, {});
    showMoment(m_clock.position_s());
    if (id == 0)
        return;
    database::Database& database = context().site().database();
    m_ghostWork = context().background().run(
        this,
        [&database, actor = context().actor(), id](WorkToken& token) -> core::Result<PlaybackData> {
            auto connection = database.openReader();
            CHIRON_TRY(connection);
            return loadPlayback(**connection, actor, id, [&token](double) { return !token.cancelled(); });
        },
        [this, id](core::Result<PlaybackData> ghost) {
            if (id != m_ghostChoice->currentData().toLongLong())
                return; // another one was chosen in the meantime
            if (ghost)
                showGhost(std::move(*ghost));
            else
                context().messages().error(
                    tr("The second session could not be read. This one is shown alone."), ghost.error(),
                    Tried::reading);
        });
}

void PlaybackScreen::showGhost(PlaybackData ghost) {
    m_ghost = std::move(ghost.track);
    m_plots->setGhost(session::ghostSeries(m_data->track, *m_ghost), tr("second session"));
    showMoment(m_clock.position_s());
}

} // namespace chiron::desktop
