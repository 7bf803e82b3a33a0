// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/study_data/study_facts.h"

#include <QWidget>

class QTableWidget;

namespace chiron::desktop {

/// Lists every presentation of a run with its fidelity, and for those that did not count the reason.
/// Thread: GUI; the facts outlive it.
class TrialsPageOfRun final : public QWidget {
    Q_OBJECT
public:
    TrialsPageOfRun(AppContext& app, const StudyFacts& facts, database::StudyRunNumber run,
                    QWidget* parent = nullptr);

signals:
    void runChosen(qlonglong run);

private:
    static void setHeadings(QTableWidget& shown);
    QWidget* table(const RunFacts& run) const;

    AppContext& m_app;
    const StudyFacts& m_facts;
};

} // namespace chiron::desktop
