// SPDX-License-Identifier: GPL-3.0-or-later
#include "people_hands.h"
#include "support/patience.h"

#include <QCheckBox>

using namespace chiron;
using namespace chiron::tests;

/// What the data layer does not let an administrator do, or others do at all, and how the screen says it.
class TestPeopleRefused : public QObject {
    Q_OBJECT
private slots:
    void takenNames();
    void lastAdministratorStays();
    void oneselfIsNotErased();
    void othersAreRefused();
    void aRefusedFormCanBeUsedAgain();
    void failedListCanBeTriedAgain();
    void unreadableRosters();
};

void TestPeopleRefused::takenNames() {
    PeopleDesk desk;
    desk.click("people.add");
    desk.set("add_person.name", QStringLiteral("Tina"));
    desk.click("add_person.accept");
    QTRY_VERIFY_WITH_TIMEOUT(desk.notice("add_person.notice").contains(QStringLiteral("already")),
                             kPatience_ms);
    QVERIFY(desk.dialog("add_person")->isVisible()); // what was typed is kept
    desk.set("add_person.name", QStringLiteral("tina, two"));
    QVERIFY(!desk.isEnabled("add_person.accept"));
    desk.dialog("add_person")->close();
    QCOMPARE(desk.table()->model()->rowCount(), 5);
}

void TestPeopleRefused::lastAdministratorStays() {
    PeopleDesk desk;
    desk.choose(QStringLiteral("ada"));
    desk.click("people.enable");
    QTRY_VERIFY_WITH_TIMEOUT(
        !desk.told.isEmpty() && desk.told.last().contains(QStringLiteral("stays enabled")), kPatience_ms);
    QCOMPARE(desk.cell(QStringLiteral("ada"), 3), QStringLiteral("Can log in"));
    desk.click("people.roles");
    desk.find<QCheckBox>(QStringLiteral("roles.trainer"))->click();
    desk.find<QCheckBox>(QStringLiteral("roles.admin"))->click();
    desk.click("roles.accept");
    QTRY_VERIFY_WITH_TIMEOUT(desk.notice("roles.notice").contains(QStringLiteral("remains an administrator")),
                             kPatience_ms);
    desk.dialog("roles")->close();
    QVERIFY(desk.actor("ada").roles().contains(database::Role::admin));
}

void TestPeopleRefused::oneselfIsNotErased() {
    PeopleDesk desk;
    desk.choose(QStringLiteral("ada"));
    desk.click("people.erase");
    desk.set("erase.reason", QStringLiteral("enough"));
    desk.set("erase.name", QStringLiteral("ada"));
    desk.set("erase.password", QLatin1String(kTestPassword));
    desk.click("erase.accept");
    QTRY_VERIFY_WITH_TIMEOUT(desk.notice("erase.notice").contains(QStringLiteral("cannot erase yourself")),
                             kPatience_ms);
    desk.dialog("erase")->close();
    QVERIFY(desk.rowOf(QStringLiteral("ada")) >= 0);
}

void TestPeopleRefused::othersAreRefused() {
    PeopleDesk desk("tom"); // a trainer may read the list, and change nothing
    QVERIFY(!desk.find<QPushButton>(QStringLiteral("nav.people"))); // not in their navigation
    desk.click("people.add");
    desk.set("add_person.name", QStringLiteral("uma"));
    desk.click("add_person.accept");
    QTRY_VERIFY_WITH_TIMEOUT(desk.notice("add_person.notice").contains(QStringLiteral("was not added")),
                             kPatience_ms);
    desk.dialog("add_person")->close();
    desk.choose(QStringLiteral("tina"));
    desk.click("people.enable");
    QTRY_VERIFY_WITH_TIMEOUT(
        !desk.told.isEmpty() && desk.told.last().contains(QStringLiteral("was not changed")), kPatience_ms);
    QVERIFY(database::AccountService(desk.database()).login("tina", kTestPassword).has_value());
    desk.screen<desktop::PeopleScreen>()->exportTo(desk.folder() + QStringLiteral("/tina.json"));
    QTRY_VERIFY_WITH_TIMEOUT(desk.told.last().contains(QStringLiteral("Nothing was exported")), kPatience_ms);
    QVERIFY(!QFile::exists(desk.folder() + QStringLiteral("/tina.json")));
}

/// Whatever a form was refused for, it says why, can be changed and left.
void TestPeopleRefused::aRefusedFormCanBeUsedAgain() {
    PeopleDesk desk("tom");
    desk.choose(QStringLiteral("tina"));
    const std::function<void()> nothing = [] {};
    for (const auto& [button, name, fill] :
         {std::tuple<const char*, QString, std::function<void()>>{
              "people.add", QStringLiteral("add_person"),
              [&] { desk.set("add_person.name", QStringLiteral("uma")); }},
          {"people.edit", QStringLiteral("edit_person"),
           [&] { desk.set("edit_person.full_name", QStringLiteral("Tina Tester")); }},
          {"people.roles", QStringLiteral("roles"),
           [&] { desk.find<QCheckBox>(QStringLiteral("roles.researcher"))->click(); }},
          {"people.reset", QStringLiteral("reset"), nothing}}) {
        desk.click(button);
        const QByteArray dialog = name.toLatin1();
        QTRY_VERIFY2_WITH_TIMEOUT(desk.dialog(dialog.constData()), button, kPatience_ms);
        fill();
        QVERIFY2(desk.isEnabled((dialog + ".accept").constData()), button);
        desk.click((dialog + ".accept").constData());
        QVERIFY2(!desk.isEnabled((dialog + ".accept").constData()) &&
                     !desk.isEnabled((dialog + ".cancel").constData()),
                 button); // not twice, and not left, while it works
        QTRY_VERIFY2_WITH_TIMEOUT(
            desk.notice((dialog + ".notice").constData()).contains(QStringLiteral(" not ")), button,
            kPatience_ms);
        QVERIFY2(desk.isEnabled((dialog + ".accept").constData()) &&
                     desk.isEnabled((dialog + ".cancel").constData()),
                 button);
        desk.click((dialog + ".cancel").constData());
        QTRY_VERIFY2_WITH_TIMEOUT(!desk.dialog(dialog.constData()), button, kPatience_ms);
    }
}

void TestPeopleRefused::failedListCanBeTriedAgain() {
    DesktopFixture desktop;
    desktop.logIn("tina");
    desktop.go(QStringLiteral("people"));
    auto* panel = desktop.find<desktop::StatePanel>(QStringLiteral("people.panel"));
    QTRY_COMPARE_WITH_TIMEOUT(panel->state(), desktop::StatePanel::State::error, kPatience_ms);
    picture(desktop.window.get(), QStringLiteral("people_error"));
    desktop.find<QPushButton>(QStringLiteral("state.action"))->click();
    QCOMPARE(panel->state(), desktop::StatePanel::State::loading);
    QTRY_COMPARE_WITH_TIMEOUT(panel->state(), desktop::StatePanel::State::error, kPatience_ms);
}

void TestPeopleRefused::unreadableRosters() {
    PeopleDesk desk;
    desk.screen<desktop::PeopleScreen>()->importRoster(desk.folder() + QStringLiteral("/nowhere.csv"));
    QVERIFY(desk.told.last().contains(QStringLiteral("cannot be read")));
    QVERIFY(!desk.dialog("roster"));
}

QTEST_MAIN(TestPeopleRefused)
#include "test_people_refused.moc"
