// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hands.h"
#include "support/desktop_fixture.h"
#include "support/patience.h"

#include "desktop/accounts/notice_area.h"
#include "desktop/people/people_screen.h"
#include "desktop/widgets/state_panel.h"

#include <QDialog>
#include <QTableView>

namespace chiron::tests {

/// The People screen of an administrator (or somebody else), with its list loaded.
class PeopleDesk : public DesktopFixture {
public:
    explicit PeopleDesk(const std::string& person = "ada") {
        logIn(person);
        go(QStringLiteral("people"));
        if (!QTest::qWaitFor([this] { return table()->model()->rowCount() > 0; }, kPatience_ms))
            qFatal("the people were not listed");
        settle();
        QObject::connect(&context.messages(), &desktop::Messages::told, &context.messages(),
                         [this](const desktop::Message& message) {
                             told << message.text;
                             lastAction = message.action;
                         });
    }
    QTableView* table() { return find<QTableView>(QStringLiteral("people.table")); }
    /// Row of a person in the list as it is shown; -1 if not there.
    int rowOf(const QString& name) {
        for (int row = 0; row < table()->model()->rowCount(); ++row)
            if (table()->model()->index(row, 0).data().toString() == name)
                return row;
        return -1;
    }
    QString cell(const QString& name, int column) {
        return table()->model()->index(rowOf(name), column).data().toString();
    }
    void choose(const QString& name) { table()->selectRow(rowOf(name)); }
    void click(const char* name) { find<QPushButton>(QLatin1String(name))->click(); }
    void set(const char* field, const QString& text) { find<QLineEdit>(QLatin1String(field))->setText(text); }
    bool isEnabled(const char* name) { return find<QPushButton>(QLatin1String(name))->isEnabled(); }
    QString notice(const char* name) {
        auto* area = find<desktop::NoticeArea>(QLatin1String(name));
        return area ? area->text() : QString();
    }
    QDialog* dialog(const char* name) { return find<QDialog>(QLatin1String(name)); }

    QStringList told; ///< every message so far
    std::function<void()> lastAction;
};

} // namespace chiron::tests
