// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/study_data/study_facts.h"

#include <QWidget>

namespace chiron::desktop {

/// Shows one run: its psychometric curve with the data, and its estimates with intervals and warnings.
/// Thread: GUI; the facts outlive it.
class PersonPage final : public QWidget {
    Q_OBJECT
public:
    PersonPage(AppContext& app, const StudyFacts& facts, database::StudyRunNumber run,
               QWidget* parent = nullptr);

signals:
    void runChosen(qlonglong run);

private:
    QWidget* estimateBox(const RunFacts& run) const;
    QWidget* curveBox(const RunFacts& run) const;

    AppContext& m_app;
    const StudyFacts& m_facts;
};

} // namespace chiron::desktop
