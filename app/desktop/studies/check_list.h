// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/freeze_checks.h"
#include "desktop/studies/study_page.h"

#include <QWidget>
#include <memory>

class QVBoxLayout;

namespace chiron::desktop {

class WorkToken;

/// The list of checks before a design is frozen. Each line has an icon, the finding, and a link to the place
/// where it can be corrected. The list runs its own simulated observers to estimate duration and precision of
/// the study.
/// Thread: GUI.
class CheckList final : public QWidget {
    Q_OBJECT
public:
    CheckList(AppContext& app, const psychophysics::StudyDesign& design, FreezeFacts facts,
              QWidget* parent = nullptr);
    ~CheckList() override;

    const std::vector<FreezeCheck>& checks() const { return m_checks; }
    bool has(FreezeCheck::State state) const;

signals:
    void changed(); ///< the result of a check changed
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
