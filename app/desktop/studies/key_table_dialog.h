// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/repositories/study_types.h"

#include <QDialog>
#include <vector>

namespace chiron::desktop {

class AppContext;
class FittedTable;
class StatePanel;

/// Shows the identities behind the codes. It is opened only on request, because each look is audited.
/// Thread: GUI.
class KeyTableDialog final : public QDialog {
    Q_OBJECT
public:
    KeyTableDialog(AppContext& app, database::StudyNumber study, QWidget* parent);

private:
    void load();
    void show(const core::Result<std::vector<database::ParticipantKey>>& keys);

    AppContext& m_app;
    database::StudyNumber m_study;
    StatePanel* m_panel;
    FittedTable* m_table;
};

} // namespace chiron::desktop
