// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLineEdit;
class QPushButton;

namespace chiron::desktop {

class AppContext;
class NoticeArea;

/// Lets administrators change the name of the site, which appears at the login, on login slips and on
/// reports.
/// Thread: GUI.
class SiteBox final : public QWidget {
    Q_OBJECT
public:
    explicit SiteBox(AppContext& context, QWidget* parent = nullptr);

private:
    void load();
    void renew();
    void save();

    AppContext& m_context;
    QLineEdit* m_name = nullptr;
    QPushButton* m_save = nullptr;
    NoticeArea* m_notice = nullptr;
    QString m_stored;
    bool m_known = false; ///< whether the stored name is known
    bool m_saves = false;
};

} // namespace chiron::desktop
