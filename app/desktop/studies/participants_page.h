// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/study_jobs.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace chiron::desktop {

class EnrolDialog;
class FittedTable;

/// Lists the participants by code: enrol, record consent, withdraw, and for authorised people look up the
/// person behind a code.
/// Thread: GUI.
class ParticipantsPage final : public QWidget {
    Q_OBJECT
public:
    /// `selected`: the code that was selected before the list was reloaded; empty: select the first.
    ParticipantsPage(AppContext& app, const OpenStudy& study, const QString& selected = {},
                     QWidget* parent = nullptr);

signals:
    void selectedChanged(const QString& code);
    void enrolOpened(chiron::desktop::EnrolDialog* dialog); ///< the dialog outlives this page
    void changed(); ///< a participant was enrolled, consented or withdrew

private:
    QWidget* actions();
    void fill(const QString& selected);
    void showActions();
    const ParticipantRow* selected() const;
    void enrol();
    void consent();
    void withdraw();
    void showKeys();
    void run();
    void showDetail(); ///< for the selected participant: the state of each condition, and what to do next

    AppContext& m_app;
    OpenStudy m_study;
    FittedTable* m_table = nullptr;
    QLabel* m_detailTitle = nullptr;
    QLabel* m_detail = nullptr;
    QLabel* m_next = nullptr;
    QPushButton* m_enrol = nullptr;
    QPushButton* m_consent = nullptr;
    QPushButton* m_run = nullptr;
    QPushButton* m_withdraw = nullptr;
    QPushButton* m_keys = nullptr;
};

} // namespace chiron::desktop
