// SPDX-License-Identifier: GPL-3.0-or-later
// How right a person was at which confidence, where a palpation is looked at.
#include "desktop/frame/app_context.h"
#include "desktop/results/results_screen.h"
#include "desktop/results/roc_box.h"
#include "app/exercises/palpation/desktop/palpating.h"

#include <QComboBox>

namespace chiron::desktop {

void ResultsScreen::showDetection(const std::vector<Attempt>& attempts) {
    const catalogue::ExerciseLevel* level =
        context().site().catalogue().find(m_exercise->currentData().toString().toStdString(), m_level->currentData().toInt());
    const bool palpated = level && palpationOf(*level);
    const QString what = QStringLiteral("%1/%2").arg(m_exercise->currentData().toString(), m_level->currentData().toString());
    m_roc->setVisible(palpated);
    if (!palpated || what == m_detectionOf)
        return;
    m_detectionOf = what;
    if (m_detection)
        m_detection->cancel();
    session::DetectionQuery query{person(), m_level->currentData().toInt(), true, {}};
    for (const Attempt& attempt : attempts)
        if (attempt.onCurve())
            query.felt = attempt.summary.felt; // of the newest: felt and shown are never pooled
    database::Database& database = context().site().database();
    m_detection = context().background().run(
        this,
        [&database, actor = context().actor(), query](WorkToken& token) -> core::Result<session::PooledDetection> {
            auto connection = database.openReader();
            if (!connection)
                return tl::unexpected(connection.error());
            return session::detectionOf(**connection, actor, query, [&token](double part) {
                token.setProgress(static_cast<int>(100 * part), 100);
                return !token.cancelled();
            });
        },
        [this, what, felt = query.felt](core::Result<session::PooledDetection> pooled) {
            if (what != m_detectionOf)
                return; // another level was chosen meanwhile
            if (pooled)
                m_roc->show(*pooled, felt);
            else
                m_roc->showError(pooled.error());
        });
    m_roc->showLoading(m_detection);
}

} // namespace chiron::desktop
