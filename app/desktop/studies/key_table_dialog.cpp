// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/key_table_dialog.h"

#include "desktop/plots/fitted_table.h"
#include "desktop/studies/study_jobs.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/state_panel.h"

#include <algorithm>

namespace chiron::desktop {

KeyTableDialog::KeyTableDialog(AppContext& app, database::StudyNumber study, QWidget* parent)
    : QDialog(parent), m_app(app), m_study(study) {
    const Theme& theme = app.theme();
    setObjectName(QStringLiteral("keys"));
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Who is who"));
    setModal(true);
    const QSize room = parent->window()->size();
    resize(std::min(theme.px(560), room.width()), std::min(theme.px(480), room.height()));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(theme.px(20), theme.px(20), theme.px(20), theme.px(16));
    column->setSpacing(theme.px(12));
    column->addWidget(kit::label(theme, tr("Who is who"), TextStyle::heading));
    column->addWidget(kit::label(theme, tr("Opening this table is recorded in the audit trail."),
                                 TextStyle::small, "muted"));
    m_table = new FittedTable(theme, 2);
    m_table->setObjectName(QStringLiteral("keys.table"));
    m_table->setAccessibleName(tr("Who is who"));
    m_table->setHorizontalHeaderLabels({tr("Code"), tr("Identity")});
    m_panel = new StatePanel(theme);
    m_panel->setContent(m_table);
    column->addWidget(m_panel, 1);
    auto* close = kit::button(theme, tr("Close"));
    close->setObjectName(QStringLiteral("keys.close"));
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    column->addWidget(close, 0, Qt::AlignRight);
    load();
}

void KeyTableDialog::load() {
    m_panel->showLoading(tr("Reading the key table …"));
    m_app.background().run(
        this,
        [&database = m_app.site().database(), actor = m_app.actor(), study = m_study](WorkToken&) {
            return database.write([&](database::WriteContext& writing) {
                return database::StudyReader(writing.connection(), actor).participantKeys(study);
            });
        },
        [this](const core::Result<std::vector<database::ParticipantKey>>& keys) { show(keys); });
}

void KeyTableDialog::show(const core::Result<std::vector<database::ParticipantKey>>& keys) {
    if (!keys) {
        m_panel->showError(tr("The key table could not be read"), keys.error());
        return;
    }
    if (keys->empty()) {
        m_panel->showEmpty(tr("The key table is empty"), tr("Simulated participants have no key."));
        return;
    }
    const bool linked = std::any_of(keys->begin(), keys->end(),
                                    [](const database::ParticipantKey& key) { return !key.account.empty(); });
    if (linked) {
        m_table->setColumnCount(3);
        m_table->setHorizontalHeaderLabels({tr("Code"), tr("Identity"), tr("Login name")});
    }
    m_table->setRowCount(static_cast<int>(keys->size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const database::ParticipantKey& key = (*keys)[static_cast<std::size_t>(row)];
        auto* code = new QTableWidgetItem(QString::fromStdString(key.code));
        code->setFont(m_app.theme().font(TextStyle::mono));
        m_table->setItem(row, 0, code);
        m_table->setItem(row, 1, new QTableWidgetItem(QString::fromStdString(key.identity)));
        if (linked)
            m_table->setItem(row, 2, new QTableWidgetItem(QString::fromStdString(key.account)));
    }
    m_panel->showContent();
}

} // namespace chiron::desktop
