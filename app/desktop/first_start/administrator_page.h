// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/first_start/site_maker.h"
#include "desktop/theme/theme.h"

#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;

namespace chiron::desktop {

class NoticeArea;
class PasswordFields;

/// The form for creating the first administrator.
/// Thread: GUI.
class AdministratorPage final : public QWidget {
    Q_OBJECT
public:
    explicit AdministratorPage(const Theme& theme, QWidget* parent = nullptr);
    /// The buttons and what is told beside them, for a PageFooter. They stand at the end of the page until
    /// somebody takes them.
    QWidget* foot() const { return m_foot; }
    void focusFirst();
    void setWorking(bool working); ///< true while the site is being created
    void showProblem(const QString& text);

signals:
    void submitted(const chiron::desktop::AdministratorRequest& request);
    void backAsked();

private:
    void renew();
    void submit();

    QLineEdit* m_name;
    QLabel* m_nameRule;
    QLineEdit* m_displayName;
    QLineEdit* m_siteName;
    PasswordFields* m_passwords;
    QWidget* m_foot;
    NoticeArea* m_notice;
    QPushButton* m_back;
    QPushButton* m_create;
    bool m_working = false;
};

} // namespace chiron::desktop
