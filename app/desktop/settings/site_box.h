// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLineEdit;
class QPushButton;

namespace chiron::desktop {

class AppContext;
class NoticeArea;

/// For administrators: what the site is called, at the login, on slips of paper and on reports. GUI thread.
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
    bool m_known = false; ///< what is stored
    bool m_saves = false;
};

} // namespace chiron::desktop
