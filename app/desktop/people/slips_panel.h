// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/people/login_slips.h"

#include <QWidget>

class QLineEdit;

namespace chiron::desktop {

class AppContext;
class NoticeArea;

/// Shows the passwords that an import has generated, once, to print them as slips or save them as a PDF. They
/// are not stored anywhere.
/// Thread: GUI.
class SlipsPanel final : public QWidget {
    Q_OBJECT
public:
    SlipsPanel(AppContext& context, const QString& headline, std::vector<database::ImportedPerson> people,
               QWidget* parent = nullptr);

    bool isTaken() const { return m_taken; } ///< printed or saved at least once
    void saveTo(const QString& file);

signals:
    void told(QWidget* notice); ///< the notice has a new text and may be scrolled out of view

private:
    QWidget* peopleTable() const;
    void say(const char* kind, const QString& text);
    LoginSlips slips();
    void print();
    void askFile();

    AppContext& m_context;
    std::vector<database::ImportedPerson> m_people;
    QLineEdit* m_site;
    NoticeArea* m_notice;
    bool m_taken = false;
};

} // namespace chiron::desktop
