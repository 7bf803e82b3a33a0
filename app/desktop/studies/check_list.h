// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/freeze_checks.h"
#include "desktop/studies/study_page.h"

#include <QWidget>
#include <memory>

class QVBoxLayout;

namespace chiron::desktop {

class WorkToken;

/// The lines that are looked at before a design is frozen, each with a sign, what was found and a way to where it is put right. Observers that it
/// simulates itself say how long and how precise the study will be. GUI thread.
class CheckList final : public QWidget {
    Q_OBJECT
public:
    CheckList(AppContext& app, const psychophysics::StudyDesign& design, FreezeFacts facts, QWidget* parent = nullptr);
    ~CheckList() override;

    const std::vector<FreezeCheck>& checks() const { return m_checks; }
    bool has(FreezeCheck::State state) const;

signals:
    void changed(); ///< a line says something else
    void goAsked(const chiron::desktop::FreezeCheck& check);

private:
    void simulate();
    void showChecks();
    QWidget* row(const FreezeCheck& check);

    AppContext& m_app;
    psychophysics::StudyDesign m_design;
    FreezeFacts m_facts;
    std::vector<FreezeCheck> m_checks;
    std::shared_ptr<WorkToken> m_work;
    QVBoxLayout* m_rows;
    QWidget* m_shown = nullptr;
};

} // namespace chiron::desktop
