// SPDX-License-Identifier: GPL-3.0-or-later
#include "people_hands.h"

#include "database/privacy/erasure.h"

#include <QCheckBox>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QRadioButton>
#include <QTableWidget>

using namespace chiron;
using namespace chiron::tests;

/// What an administrator does with people.
class TestPeople : public QObject {
    Q_OBJECT
private slots:
    void addByKeyboardAndHandThePasswordOver();
    void findByTyping();
    void changeRoles();
    void disableAndUndo();
    void resetWithATypedPassword();
    void exportHoldsThePerson();
    void erase();
    void importRoster();
    void fitsAtEveryScale_data();
    void fitsAtEveryScale();

private:
    static void write(const QString& name, const QByteArray& text) {
        QFile file(name);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
    }
};

void TestPeople::addByKeyboardAndHandThePasswordOver() {
    PeopleDesk desk;
    QCOMPARE(desk.table()->model()->rowCount(), 5);
    picture(desk.window.get(), QStringLiteral("people"));
    press(Qt::Key_N, Qt::ControlModifier);
    QTRY_VERIFY(desk.dialog("add_person") && desk.dialog("add_person")->isActiveWindow());
    QTRY_COMPARE(focusName(), QStringLiteral("add_person.name"));
    QVERIFY(!desk.isEnabled("add_person.accept"));
    type(QStringLiteral("uma"));
    VERIFY_READABLE(desk.dialog("add_person"));
    picture(desk.dialog("add_person"), QStringLiteral("people_add"));
    QVERIFY(tabTo(QStringLiteral("add_person.accept")));
    press(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QLabel>(QStringLiteral("handed.password")), 10000);
    const QString password = desk.find<QLabel>(QStringLiteral("handed.password"))->text();
    picture(desk.dialog("add_person"), QStringLiteral("people_handed"));
    press(Qt::Key_Return); // Close has the focus
    QTRY_VERIFY(!desk.dialog("add_person"));
    QTRY_VERIFY(desk.rowOf(QStringLiteral("uma")) >= 0);
    QCOMPARE(desk.cell(QStringLiteral("uma"), 2), QStringLiteral("Trainee"));
    QCOMPARE(desk.cell(QStringLiteral("uma"), 3), QStringLiteral("Must change the password"));
    const auto uma = database::AccountService(desk.database()).login("uma", password.toStdString());
    QVERIFY(uma && uma->mustChangePassword());
}

void TestPeople::findByTyping() {
    PeopleDesk desk;
    QTRY_COMPARE(focusName(), QStringLiteral("people.search"));
    type(QStringLiteral("trainer"));
    QCOMPARE(desk.table()->model()->rowCount(), 1); // by role
    QVERIFY(desk.rowOf(QStringLiteral("tom")) == 0);
    desk.set("people.search", QStringLiteral("lovelace"));
    QCOMPARE(desk.table()->model()->rowCount(), 1); // by full name
    QVERIFY(!desk.isEnabled("people.erase"));      // nobody is chosen
    desk.choose(QStringLiteral("ada"));
    QVERIFY(desk.isEnabled("people.erase"));
    desk.set("people.search", QStringLiteral("zzz"));
    QVERIFY(!desk.isEnabled("people.erase")); // nobody out of sight is ever acted on
}

void TestPeople::changeRoles() {
    PeopleDesk desk;
    desk.choose(QStringLiteral("tina"));
    desk.click("people.roles");
    QVERIFY(!desk.isEnabled("roles.accept")); // nothing is changed yet
    desk.find<QCheckBox>(QStringLiteral("roles.trainer"))->click();
    desk.find<QCheckBox>(QStringLiteral("roles.trainee"))->click();
    picture(desk.dialog("roles"), QStringLiteral("people_roles"));
    desk.find<QCheckBox>(QStringLiteral("roles.trainer"))->click();
    QVERIFY(!desk.isEnabled("roles.accept")); // one role at least
    desk.find<QCheckBox>(QStringLiteral("roles.trainer"))->click();
    desk.click("roles.accept");
    QTRY_COMPARE_WITH_TIMEOUT(desk.cell(QStringLiteral("tina"), 2), QStringLiteral("Trainer"), 10000);
    QVERIFY(desk.actor("tina").roles() == database::RoleSet{database::Role::trainer});
}

void TestPeople::disableAndUndo() {
    PeopleDesk desk;
    desk.choose(QStringLiteral("tina"));
    desk.click("people.enable");
    QTRY_COMPARE_WITH_TIMEOUT(desk.cell(QStringLiteral("tina"), 3), QStringLiteral("Disabled"), 10000);
    QVERIFY(!database::AccountService(desk.database()).login("tina", kTestPassword));
    QCOMPARE(desk.find<QPushButton>(QStringLiteral("people.enable"))->text(), QStringLiteral("Enable")); // still chosen
    picture(desk.window.get(), QStringLiteral("people_disabled"));
    QVERIFY(desk.lastAction != nullptr);
    desk.lastAction(); // Undo
    QTRY_COMPARE_WITH_TIMEOUT(desk.cell(QStringLiteral("tina"), 3), QStringLiteral("Can log in"), 10000);
    QVERIFY(database::AccountService(desk.database()).login("tina", kTestPassword).has_value());
}

void TestPeople::resetWithATypedPassword() {
    PeopleDesk desk;
    desk.choose(QStringLiteral("theo"));
    desk.click("people.reset");
    desk.find<QRadioButton>(QStringLiteral("reset.type"))->click();
    QVERIFY(!desk.isEnabled("reset.accept"));
    desk.set("reset.password", QStringLiteral("brought-by-ada-7"));
    desk.set("reset.repeat", QStringLiteral("brought-by-ada-7"));
    QVERIFY(desk.isEnabled("reset.accept"));
    picture(desk.dialog("reset"), QStringLiteral("people_reset"));
    desk.click("reset.accept");
    QTRY_VERIFY_WITH_TIMEOUT(!desk.dialog("reset"), 10000);
    const auto theo = database::AccountService(desk.database()).login("theo", "brought-by-ada-7");
    QVERIFY(theo && theo->mustChangePassword());
}

void TestPeople::exportHoldsThePerson() {
    PeopleDesk desk;
    const QString file = desk.folder() + QStringLiteral("/tina.json");
    desk.choose(QStringLiteral("tina"));
    desk.screen<desktop::PeopleScreen>()->exportTo(file);
    QTRY_VERIFY_WITH_TIMEOUT(!desk.told.isEmpty() && desk.told.last().contains(file), 10000);
    QFile written(file);
    QVERIFY(written.open(QIODevice::ReadOnly));
    const QJsonObject person = QJsonDocument::fromJson(written.readAll()).object()["person"].toObject();
    QCOMPARE(person["name"].toString(), QStringLiteral("tina"));
    QVERIFY((written.permissions() & (QFile::ReadOther | QFile::ReadGroup)) == QFile::Permissions());
    desk.screen<desktop::PeopleScreen>()->exportTo(desk.folder() + QStringLiteral("/nowhere/tina.json"));
    QTRY_VERIFY_WITH_TIMEOUT(desk.told.last().contains(QStringLiteral("Nothing was exported")), 10000);
}

void TestPeople::erase() {
    PeopleDesk desk;
    const database::PersonId tina = desk.actor("tina").personId();
    desk.choose(QStringLiteral("tina"));
    desk.click("people.erase");
    desk.set("erase.reason", QStringLiteral("asked for it"));
    desk.set("erase.name", QStringLiteral("tin"));
    desk.set("erase.password", QStringLiteral("not my password"));
    QVERIFY(!desk.isEnabled("erase.accept")); // the name is not typed out
    desk.set("erase.name", QStringLiteral("tina"));
    VERIFY_READABLE(desk.dialog("erase"));
    picture(desk.dialog("erase"), QStringLiteral("people_erase"));
    desk.click("erase.accept");
    QTRY_VERIFY_WITH_TIMEOUT(desk.notice("erase.notice").contains(QStringLiteral("Nobody was erased")), 10000);
    QVERIFY(desk.rowOf(QStringLiteral("tina")) >= 0);
    // It stops half-way: the list of erasures cannot be written. The same button goes on.
    const QString list = QString::fromStdString(database::erasureListFile(desk.database().siteFolder()));
    QVERIFY(QDir().mkpath(list));
    desk.set("erase.password", QLatin1String(kTestPassword));
    desk.click("erase.accept");
    QTRY_VERIFY_WITH_TIMEOUT(desk.notice("erase.notice").contains(QStringLiteral("continue where it stopped")), 10000);
    QVERIFY(QDir().rmdir(list));
    QVERIFY(desk.isEnabled("erase.accept"));
    desk.click("erase.accept");
    QTRY_VERIFY_WITH_TIMEOUT(!desk.dialog("erase"), 10000);
    QTRY_VERIFY(desk.rowOf(QStringLiteral("tina")) < 0);
    const auto erased = database::readErasureList(list.toStdString());
    QVERIFY(erased && erased->size() == 1 && erased->front().person == tina && erased->front().reason == "asked for it");
}

void TestPeople::importRoster() {
    PeopleDesk desk;
    const QString file = desk.folder() + QStringLiteral("/roster.csv");
    auto* screen = desk.screen<desktop::PeopleScreen>();
    write(file, "name,display_name,roles,password\numa,Uma,trainee,a good long word\nTINA,Again,trainee,a good long word\nvic,Vic,wizard,short\n");
    screen->importRoster(file);
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QFrame>(QStringLiteral("roster.problems")), 10000);
    const QString words = desk.find<QFrame>(QStringLiteral("roster.problems"))->findChild<QLabel*>(QStringLiteral("notice.text"))->text();
    QVERIFY2(words.contains(QStringLiteral("Line 3: \"TINA\" already exists at this site")), qPrintable(words));
    QVERIFY2(words.contains(QStringLiteral("Line 4: roles \"wizard\"")) && words.contains(QStringLiteral("Line 4: the password")), qPrintable(words));
    QVERIFY(!desk.isEnabled("roster.accept"));
    picture(desk.dialog("roster"), QStringLiteral("people_roster_wrong"));
    desk.click("roster.cancel");
    QTRY_VERIFY(!desk.dialog("roster"));
    write(file, "name,display_name,roles,password\numa,Uma,trainee,a good long word\nvic,Vic,trainer;researcher,a good long word\n");
    screen->importRoster(file);
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QTableWidget>(QStringLiteral("roster.people")), 10000);
    QCOMPARE(desk.find<QTableWidget>(QStringLiteral("roster.people"))->rowCount(), 2);
    QCOMPARE(desk.table()->model()->rowCount(), 5); // shown, not done
    picture(desk.dialog("roster"), QStringLiteral("people_roster"));
    desk.click("roster.accept");
    QTRY_COMPARE_WITH_TIMEOUT(desk.table()->model()->rowCount(), 7, 10000);
    QCOMPARE(desk.cell(QStringLiteral("vic"), 2), QStringLiteral("Trainer, Researcher"));
}

void TestPeople::fitsAtEveryScale_data() {
    QTest::addColumn<double>("scale");
    QTest::addColumn<int>("theme");
    QTest::newRow("100 %") << 1.0 << 0;
    QTest::newRow("200 % dark") << 2.0 << 1;
}

void TestPeople::fitsAtEveryScale() {
    QFETCH(double, scale);
    QFETCH(int, theme);
    PeopleDesk desk;
    desk.settings.setScale(scale);
    desk.settings.setTheme(static_cast<desktop::ThemeName>(theme));
    desk.context.applyAppearance();
    settle();
    QTRY_VERIFY(desk.table() && desk.table()->model()->rowCount() == 5);
    desk.choose(QStringLiteral("tina"));
    VERIFY_READABLE(desk.window->screen());
    picture(desk.window.get(), QStringLiteral("people_%1").arg(scale));
    for (const auto& [button, dialog] : {std::pair{"people.add", "add_person"}, std::pair{"people.roles", "roles"}, std::pair{"people.reset", "reset"},
                                         std::pair{"people.erase", "erase"}}) {
        desk.click(button);
        QTest::qWait(50);
        VERIFY_READABLE(desk.dialog(dialog));
        picture(desk.dialog(dialog), QStringLiteral("people_%1_%2").arg(QLatin1String(dialog)).arg(scale));
        desk.dialog(dialog)->close();
        QTRY_VERIFY(!desk.dialog(dialog));
    }
}

QTEST_MAIN(TestPeople)
#include "test_people.moc"
