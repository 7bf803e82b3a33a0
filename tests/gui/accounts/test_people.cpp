// SPDX-License-Identifier: GPL-3.0-or-later
#include "people_hands.h"

#include "core/languages.h"
#include "database/access/access_table.h"
#include "database/privacy/erasure.h"
#include "database/repositories/session_reader.h"
#include "database/repositories/site_repository.h"
#include "database/write_context.h"
#include "desktop/people/role_choice.h"
#include "desktop/people/slips_panel.h"
#include "support/made_study.h"
#include "support/patience.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDirIterator>
#include <QFileDialog>
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
    void ownRolesShowAtOnce();
    void rolesSayWhoDoesStudies();
    void disableAndUndo();
    void resetWithATypedPassword();
    void exportHoldsThePerson();
    void erase();
    void eraseAParticipant();
    void editNames();
    void renamingSaysWhatBecomesOfTheSlip();
    void renamingOneselfIsSeenAtOnce();
    void importRoster();
    void anUnknownRoleIsToldWhatItStandsFor();
    void germanExcelIsImportedAndSlipsArePrinted();
    void whoExistsIsUpdatedWhenAsked();
    void anOldListNamesWhoWasRenamed();
    void anOldFullNameIsNotGivenBack();
    void otherFilesAreNamed();
    void templateCanBeImported_data();
    void templateCanBeImported();
    void enterPressesTheFocusedButton();
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
    const QString ofPerson = desk.find<QPushButton>(QStringLiteral("people.erase"))->accessibleDescription();
    QVERIFY(!ofPerson.isEmpty() &&
            ofPerson !=
                desk.find<QPushButton>(QStringLiteral("people.erase_participant"))->accessibleDescription());
    picture(desk.window.get(), QStringLiteral("people"));
    press(Qt::Key_N, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(desk.dialog("add_person") && desk.dialog("add_person")->isActiveWindow(),
                             kPatience_ms);
    QTRY_COMPARE_WITH_TIMEOUT(focusName(), QStringLiteral("add_person.name"), kPatience_ms);
    QVERIFY(!desk.isEnabled("add_person.accept"));
    type(QStringLiteral("uma"));
    VERIFY_READABLE(desk.dialog("add_person"));
    picture(desk.dialog("add_person"), QStringLiteral("people_add"));
    QVERIFY(tabTo(QStringLiteral("add_person.accept")));
    press(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QLabel>(QStringLiteral("handed.password")), kPatience_ms);
    const QString password = desk.find<QLabel>(QStringLiteral("handed.password"))->text();
    picture(desk.dialog("add_person"), QStringLiteral("people_handed"));
    QCOMPARE(focusName(), QStringLiteral("handed.copy"));
    press(Qt::Key_Return); // takes the password along, and does not close
    QCOMPARE(QGuiApplication::clipboard()->text(), password);
    QVERIFY(desk.dialog("add_person")->isVisible() && tabTo(QStringLiteral("add_person.cancel")));
    press(Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(!desk.dialog("add_person"), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(desk.rowOf(QStringLiteral("uma")) >= 0, kPatience_ms);
    QCOMPARE(desk.cell(QStringLiteral("uma"), 2), QStringLiteral("Trainee"));
    QCOMPARE(desk.cell(QStringLiteral("uma"), 3), QStringLiteral("Must change the password"));
    const auto uma = database::AccountService(desk.database()).login("uma", password.toStdString());
    QVERIFY(uma && uma->mustChangePassword());
}

void TestPeople::findByTyping() {
    PeopleDesk desk;
    QTRY_COMPARE_WITH_TIMEOUT(focusName(), QStringLiteral("people.search"), kPatience_ms);
    type(QStringLiteral("trainer"));
    QCOMPARE(desk.table()->model()->rowCount(), 1); // by role
    QVERIFY(desk.rowOf(QStringLiteral("tom")) == 0);
    desk.set("people.search", QStringLiteral("lovelace"));
    QCOMPARE(desk.table()->model()->rowCount(), 1); // by full name
    QVERIFY(!desk.isEnabled("people.erase"));       // nobody is chosen
    desk.choose(QStringLiteral("ada"));
    QVERIFY(desk.isEnabled("people.erase"));
    desk.set("people.search",
             QStringLiteral("LÓVELACE")); // as somebody types it who has no such keys, or others
    QCOMPARE(desk.table()->model()->rowCount(), 1);
    desk.set("people.search", QStringLiteral("zzz"));
    QCOMPARE(desk.find<desktop::StatePanel>(QStringLiteral("people.panel"))->state(),
             desktop::StatePanel::State::empty); // it is said, not only shown
    desk.click("state.action");
    QCOMPARE(desk.table()->model()->rowCount(), 5);
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
    QTRY_COMPARE_WITH_TIMEOUT(desk.cell(QStringLiteral("tina"), 2), QStringLiteral("Trainer"), kPatience_ms);
    QVERIFY(desk.actor("tina").roles() == database::RoleSet{database::Role::trainer});
}

/// The side bar follows; who is no administrator any more does not stay here.
void TestPeople::ownRolesShowAtOnce() {
    PeopleDesk desk;
    QVERIFY(!desk.find<QPushButton>(QStringLiteral("nav.results")));
    desk.choose(QStringLiteral("ada"));
    desk.click("people.roles");
    desk.find<QCheckBox>(QStringLiteral("roles.trainee"))->click();
    desk.click("roles.accept");
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QPushButton>(QStringLiteral("nav.results")), kPatience_ms);
    QVERIFY(desk.context.has(database::Role::trainee));
    QVERIFY(!desk.told.isEmpty() && !desk.lastAction); // nothing else is to be done
    QCOMPARE(desk.context.navigator().current().screen, QStringLiteral("people"));
    QTRY_VERIFY_WITH_TIMEOUT(!desk.dialog("roles") && desk.rowOf(QStringLiteral("ada")) >= 0 &&
                                 desk.cell(QStringLiteral("ada"), 2).contains(QStringLiteral("Trainee")),
                             kPatience_ms);
    QVERIFY(database::AccountService(desk.database())
                .setRoles(desk.actor("ada"), desk.actor("tom").personId(),
                          {database::Role::trainer, database::Role::admin})
                .has_value());
    desk.choose(QStringLiteral("ada"));
    desk.click("people.roles");
    desk.find<QCheckBox>(QStringLiteral("roles.admin"))->click();
    desk.click("roles.accept");
    QTRY_COMPARE_WITH_TIMEOUT(desk.context.navigator().current().screen, QStringLiteral("home"),
                              kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!desk.find<QPushButton>(QStringLiteral("nav.people")), kPatience_ms);
}

/// As the access table has it: a role's description names studies where the role may begin or run them.
void TestPeople::rolesSayWhoDoesStudies() {
    using namespace database;
    const auto theme = desktop::Theme::load(desktop::ThemeName::light, 1.0);
    QVERIFY(theme.has_value());
    const desktop::RoleChoice choice(*theme, QStringLiteral("roles"), {});
    for (const Role role : kAllRoles) {
        const auto may = [role](Action action) {
            return scopeOf(action, ActorKind::person, RoleSet{role}) != Scope::none;
        };
        const std::string name(token(role));
        const auto* box =
            choice.findChild<QCheckBox*>(QStringLiteral("roles.") + QString::fromStdString(name));
        QVERIFY2(box, name.c_str());
        const QString said = box->accessibleDescription();
        QCOMPARE(said.contains(QStringLiteral("esign")) && said.contains(QStringLiteral("studies")),
                 may(Action::createStudy));
        QCOMPARE(said.contains(QStringLiteral("run")), may(Action::conductRun));
    }
}

void TestPeople::disableAndUndo() {
    PeopleDesk desk;
    desk.choose(QStringLiteral("tina"));
    desk.click("people.enable");
    QTRY_COMPARE_WITH_TIMEOUT(desk.cell(QStringLiteral("tina"), 3), QStringLiteral("Disabled"), kPatience_ms);
    QVERIFY(!database::AccountService(desk.database()).login("tina", kTestPassword));
    QCOMPARE(desk.find<QPushButton>(QStringLiteral("people.enable"))->text(),
             QStringLiteral("Enable")); // still chosen
    picture(desk.window.get(), QStringLiteral("people_disabled"));
    QVERIFY(desk.lastAction != nullptr);
    desk.lastAction(); // Undo
    QTRY_COMPARE_WITH_TIMEOUT(desk.cell(QStringLiteral("tina"), 3), QStringLiteral("Can log in"),
                              kPatience_ms);
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
    QTRY_VERIFY_WITH_TIMEOUT(!desk.dialog("reset"), kPatience_ms);
    const auto theo = database::AccountService(desk.database()).login("theo", "brought-by-ada-7");
    QVERIFY(theo && theo->mustChangePassword());
}

void TestPeople::exportHoldsThePerson() {
    PeopleDesk desk;
    const QString file = desk.folder() + QStringLiteral("/tina.json");
    desk.choose(QStringLiteral("tina"));
    desk.screen<desktop::PeopleScreen>()->exportTo(file);
    QTRY_VERIFY_WITH_TIMEOUT(!desk.told.isEmpty() && desk.told.last().contains(file), kPatience_ms);
    QFile written(file);
    QVERIFY(written.open(QIODevice::ReadOnly));
    const QJsonObject person = QJsonDocument::fromJson(written.readAll()).object()["person"].toObject();
    QCOMPARE(person["name"].toString(), QStringLiteral("tina"));
    QVERIFY((written.permissions() & (QFile::ReadOther | QFile::ReadGroup)) == QFile::Permissions());
    desk.screen<desktop::PeopleScreen>()->exportTo(desk.folder() + QStringLiteral("/nowhere/tina.json"));
    QTRY_VERIFY_WITH_TIMEOUT(desk.told.last().contains(QStringLiteral("Nothing was exported")), kPatience_ms);
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
    QTRY_VERIFY_WITH_TIMEOUT(desk.notice("erase.notice").contains(QStringLiteral("Nobody was erased")),
                             kPatience_ms);
    QCOMPARE(desk.find<QLabel>(QStringLiteral("erase.password.note"))->text(),
             QStringLiteral("Wrong password. Passwords are case-sensitive."));
    QVERIFY(desk.find<QLabel>(QStringLiteral("erase.password.note"))->isVisible());
    QVERIFY(desk.rowOf(QStringLiteral("tina")) >= 0);
    // It stops half-way: the list of erasures cannot be written. The same button goes on.
    const QString list = QString::fromStdString(database::erasureListFile(desk.database().siteFolder()));
    QVERIFY(QDir().mkpath(list));
    desk.set("erase.password", QLatin1String(kTestPassword));
    desk.click("erase.accept");
    QTRY_VERIFY_WITH_TIMEOUT(
        desk.notice("erase.notice").contains(QStringLiteral("continue where it stopped")), kPatience_ms);
    QVERIFY(QDir().rmdir(list));
    QVERIFY(desk.isEnabled("erase.accept"));
    desk.click("erase.accept");
    QTRY_VERIFY_WITH_TIMEOUT(!desk.dialog("erase"), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(desk.rowOf(QStringLiteral("tina")) < 0, kPatience_ms);
    const auto erased = database::readErasureList(list.toStdString());
    QVERIFY(erased && erased->size() == 1 && erased->front().person == tina &&
            erased->front().reason == "asked for it");
}

/// Who has withdrawn from a study, with or without an account; Home says that somebody waits.
void TestPeople::eraseAParticipant() {
    PeopleDesk desk;
    const auto words = [&desk] {
        const auto* label = desk.find<QLabel>(QStringLiteral("erase_participant.words"));
        return label ? label->text() : QString();
    };
    desk.click("people.erase_participant");
    QTRY_VERIFY_WITH_TIMEOUT(words().contains(QStringLiteral("No participant")), kPatience_ms);
    desk.set("erase_participant.reason", QStringLiteral("wish"));
    desk.set("erase_participant.password", QLatin1String(kTestPassword));
    QVERIFY(!desk.isEnabled("erase_participant.accept"));
    desk.dialog("erase_participant")->reject();

    const database::Actor rhea = desk.actor("rhea");
    const psychophysics::StudyDesign design = smallStudy("left");
    const database::StudyNumber study = addDraft(desk, rhea, design);
    writeAs(desk, rhea, [&](database::StudyRepository& studies) { return studies.freezeStudy(study); });
    const database::Participant keeps = addParticipant(desk, rhea, study, design, "Kim, ward 1");
    const database::Participant goes = addParticipant(desk, rhea, study, design, "Gil, ward 2");
    (void)addParticipant(desk, rhea, study, design, "Sam, ward 3"); // goes on taking part
    writeAs(desk, rhea,
            [&](database::StudyRepository& studies) { return studies.withdrawParticipant(keeps.id, false); });
    writeAs(desk, rhea,
            [&](database::StudyRepository& studies) { return studies.withdrawParticipant(goes.id, true); });
    const auto homeTells = [&desk] {
        desk.go(QStringLiteral("home"));
        const bool read = QTest::qWaitFor([&desk] { return desk.context.background().idle(); }, kPatience_ms);
        const auto notices = desk.window->screen()->findChildren<QLabel*>(QStringLiteral("notice.text"));
        return read && std::any_of(notices.begin(), notices.end(), [](const QLabel* label) {
                   return label->text().contains(QStringLiteral("recordings to be erased"));
               });
    };
    QVERIFY(homeTells());

    desk.go(QStringLiteral("people"));
    desk.click("people.erase_participant");
    auto* who = desk.find<QComboBox>(QStringLiteral("erase_participant.who"));
    QTRY_COMPARE_WITH_TIMEOUT(who->count(), 2, kPatience_ms);
    QVERIFY(
        who->itemText(0).startsWith(QString::fromStdString(goes.code))); // whoever asked for it comes first
    QVERIFY(words().contains(QStringLiteral("as the participant wished, the recordings")));
    who->setCurrentIndex(1);
    QVERIFY(words().contains(QStringLiteral("did not ask for the recordings")));
    who->setCurrentIndex(0);
    desk.set("erase_participant.reason", QStringLiteral("wish"));
    desk.set("erase_participant.password", QStringLiteral("not my password"));
    VERIFY_READABLE(desk.dialog("erase_participant"));
    picture(desk.dialog("erase_participant"), QStringLiteral("people_erase_participant"));
    desk.click("erase_participant.accept");
    QTRY_VERIFY_WITH_TIMEOUT(
        desk.notice("erase_participant.notice").contains(QStringLiteral("Nobody was erased")), kPatience_ms);
    const auto erased = [&](const database::Participant& participant) {
        const auto reader = desk.database().openReader();
        return database::StudyReader(**reader, desk.actor("ada"))
            .participantByCode(study, participant.code)
            ->erased;
    };
    QVERIFY(!erased(goes));
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QLineEdit>(QStringLiteral("erase_participant.password"))->isEnabled(),
                             kPatience_ms);
    desk.set("erase_participant.password", QLatin1String(kTestPassword));
    desk.click("erase_participant.accept");
    QTRY_VERIFY_WITH_TIMEOUT(!desk.dialog("erase_participant"), kPatience_ms);
    QVERIFY(erased(goes) && !erased(keeps));
    QVERIFY(!homeTells()); // the other one did not ask for it
}

void TestPeople::importRoster() {
    PeopleDesk desk;
    const QString file = desk.folder() + QStringLiteral("/roster.csv");
    auto* screen = desk.screen<desktop::PeopleScreen>();
    write(file, "name,display_name,roles,password\numa,Uma,trainee,a good long word\nTINA,Again,trainee,a "
                "good long word\nvic,Vic,wizard,short\n");
    screen->importRoster(file);
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QFrame>(QStringLiteral("roster.problems")), kPatience_ms);
    const QString words = desk.find<QFrame>(QStringLiteral("roster.problems"))
                              ->findChild<QLabel*>(QStringLiteral("notice.text"))
                              ->text();
    QVERIFY2(words.contains(QStringLiteral("Line 4, column “roles”: \"wizard\" is not a role")) &&
                 words.contains(QStringLiteral("Line 4, column “password”: the password")),
             qPrintable(words));
    QVERIFY2(!words.contains(QStringLiteral("Line 3")), qPrintable(words)); // who has an account is no fault
    QVERIFY(!desk.isEnabled("roster.accept"));
    picture(desk.dialog("roster"), QStringLiteral("people_roster_wrong"));
    desk.click("roster.cancel");
    QTRY_VERIFY_WITH_TIMEOUT(!desk.dialog("roster"), kPatience_ms);
    write(file, "name,display_name,roles,password\numa,Uma,trainee,a good long "
                "word\nvic,Vic,trainer;researcher,a good long word\n");
    screen->importRoster(file);
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QTableWidget>(QStringLiteral("roster.people")), kPatience_ms);
    QCOMPARE(desk.find<QTableWidget>(QStringLiteral("roster.people"))->rowCount(), 2);
    QCOMPARE(desk.table()->model()->rowCount(), 5); // shown, not done
    picture(desk.dialog("roster"), QStringLiteral("people_roster"));
    desk.click("roster.accept");
    QTRY_COMPARE_WITH_TIMEOUT(desk.table()->model()->rowCount(), 7, kPatience_ms);
    QCOMPARE(desk.cell(QStringLiteral("vic"), 2), QStringLiteral("Trainer, Researcher"));
}

/// A word of the list that is no role can be given one in the dialog; each line says what would happen to it,
/// and what keeps it from that.
void TestPeople::anUnknownRoleIsToldWhatItStandsFor() {
    PeopleDesk desk;
    const QString file = desk.folder() + QStringLiteral("/roster.csv");
    write(file,
          "login name,full "
          "name,role\numa,Uma,trainee\nvic,Vic,Famulant\nwim,Wim,trainer;FAMULANT\ntina,Tina,trainee\n");
    desk.screen<desktop::PeopleScreen>()->importRoster(file);
    const auto happens = [&](int row) {
        auto* table = desk.find<QTableWidget>(QStringLiteral("roster.people"));
        return table && row < table->rowCount() ? table->item(row, 1)->text() : QString();
    };
    QTRY_COMPARE_WITH_TIMEOUT(happens(1), QStringLiteral("Cannot be imported yet"), kPatience_ms);
    QCOMPARE(happens(0), QStringLiteral("Would be added"));
    QCOMPARE(happens(2), QStringLiteral("Cannot be imported yet"));
    QCOMPARE(happens(3), QStringLiteral("Would be left as it is"));
    QVERIFY(desk.find<QTableWidget>(QStringLiteral("roster.people"))
                ->item(1, 1)
                ->toolTip()
                .contains(QStringLiteral("\"Famulant\" is not a role")));
    QVERIFY(!desk.isEnabled("roster.accept"));
    QVERIFY(desk.find<QFrame>(QStringLiteral("roster.problems"))
                ->findChild<QLabel*>(QStringLiteral("notice.text"))
                ->text()
                .contains(QStringLiteral("choose above")));
    QCOMPARE(desk.find<QWidget>(QStringLiteral("roster.roles"))->findChildren<QComboBox*>().size(),
             1); // one for a word, however it is written
    VERIFY_READABLE(desk.dialog("roster"));
    picture(desk.dialog("roster"), QStringLiteral("people_roster_roles"));
    auto* choice = desk.find<QComboBox>(QStringLiteral("roster.role.Famulant"));
    choice->setCurrentText(QStringLiteral("Trainee"));
    QTRY_VERIFY_WITH_TIMEOUT(desk.isEnabled("roster.accept"), kPatience_ms);
    QCOMPARE(happens(1), QStringLiteral("Would be added"));
    choice->setCurrentIndex(0); // taken back
    QTRY_COMPARE_WITH_TIMEOUT(happens(1), QStringLiteral("Cannot be imported yet"), kPatience_ms);
    choice->setCurrentText(QStringLiteral("Trainee"));
    QTRY_VERIFY_WITH_TIMEOUT(desk.isEnabled("roster.accept"), kPatience_ms);
    const QPointer<QWidget> chosen(choice), update(desk.find<QRadioButton>(QStringLiteral("roster.update")));
    QVERIFY(update && update->isEnabled());
    desk.click("roster.accept");
    QVERIFY(chosen && !chosen->isEnabled() &&
            !update->isEnabled()); // while it is imported, nothing can be chosen any more
    QTRY_COMPARE_WITH_TIMEOUT(desk.table()->model()->rowCount(), 8, kPatience_ms);
    QCOMPARE(desk.cell(QStringLiteral("vic"), 2), QStringLiteral("Trainee"));
    QCOMPARE(desk.cell(QStringLiteral("wim"), 2), QStringLiteral("Trainee, Trainer"));
}

void TestPeople::editNames() {
    PeopleDesk desk;
    const database::SessionId session = desk.addSession("tina", 1, "expert", 1, 1);
    desk.choose(QStringLiteral("tina"));
    desk.click("people.edit");
    QTRY_COMPARE_WITH_TIMEOUT(focusName(), QStringLiteral("edit_person.full_name"), kPatience_ms);
    QVERIFY(!desk.isEnabled("edit_person.accept")); // nothing is changed yet
    const auto rule = [&] { return desk.find<QLabel>(QStringLiteral("edit_person.name_rule"))->text(); };
    desk.set("edit_person.name", QString());
    QVERIFY(!desk.isEnabled("edit_person.accept") && rule().contains(QStringLiteral("is needed")));
    desk.set("edit_person.name", QStringLiteral("tina,two"));
    QVERIFY(!desk.isEnabled("edit_person.accept") && rule().contains(QStringLiteral("cannot be used")));
    desk.set("edit_person.name", QStringLiteral("THEO"));
    desk.click("edit_person.accept");
    QTRY_VERIFY_WITH_TIMEOUT(rule().contains(QStringLiteral("already")),
                             kPatience_ms); // at the field, and what was typed is kept
    QCOMPARE(focusName(), QStringLiteral("edit_person.name"));
    picture(desk.dialog("edit_person"), QStringLiteral("people_edit_taken"));
    desk.set("edit_person.name", QStringLiteral("christina"));
    desk.set("edit_person.full_name", QStringLiteral("Christina Weiß"));
    VERIFY_READABLE(desk.dialog("edit_person"));
    desk.told.clear();
    desk.click("edit_person.accept");
    QTRY_VERIFY_WITH_TIMEOUT(desk.rowOf(QStringLiteral("christina")) >= 0, kPatience_ms);
    QTRY_VERIFY2_WITH_TIMEOUT(desk.told.join(u' ').contains(QStringLiteral("christina")) &&
                                  desk.told.join(u' ').contains(QStringLiteral("saved")),
                              qPrintable(desk.told.join(u' ')), kPatience_ms);
    QCOMPARE(desk.cell(QStringLiteral("christina"), 1), QStringLiteral("Christina Weiß"));
    // Still chosen, with what she was called before.
    auto* earlier = desk.find<QLabel>(QStringLiteral("people.earlier"));
    QTRY_VERIFY_WITH_TIMEOUT(earlier->isVisible() &&
                                 earlier->text().contains(QStringLiteral("Tina Trainee (tina)")),
                             kPatience_ms);
    desk.choose(QStringLiteral("theo"));
    QTRY_VERIFY_WITH_TIMEOUT(!earlier->isVisible(), kPatience_ms);
    auto reader = desk.database().openReader();
    const auto past = database::SessionReader(**reader, desk.actor("ada")).session(session);
    QVERIFY(past && past->summary.personName == "christina"); // her past session says who it was
    QVERIFY(database::AccountService(desk.database()).login("christina", kTestPassword).has_value());
}

/// Whoever has a slip with the old login name would stand at the login without knowing why.
void TestPeople::renamingSaysWhatBecomesOfTheSlip() {
    PeopleDesk desk;
    database::AccountService accounts(desk.database());
    const database::Actor ada = desk.actor("ada");
    QVERIFY(accounts.createPerson(ada, {"uma", "Uma", {database::Role::trainee}, kTestPassword, true}));
    desk.go(QStringLiteral("home")); // and back: the list is read anew
    settle();
    desk.go(QStringLiteral("people"));
    settle();
    QTRY_VERIFY_WITH_TIMEOUT(desk.rowOf(QStringLiteral("uma")) >= 0, kPatience_ms);
    for (const auto& [name, hasSlip] : {std::pair{"uma", true}, std::pair{"tina", false}}) {
        desk.choose(QString::fromLatin1(name));
        desk.click("people.edit");
        QTRY_COMPARE_WITH_TIMEOUT(focusName(), QStringLiteral("edit_person.full_name"), kPatience_ms);
        const auto* renamed = desk.find<QLabel>(QStringLiteral("edit_person.renamed"));
        QVERIFY(renamed && !renamed->isVisible());
        desk.set("edit_person.full_name", QStringLiteral("Another Name"));
        desk.set("edit_person.name", QString::fromLatin1(name).toUpper()); // the same to the login
        QVERIFY(!renamed->isVisible());
        desk.set("edit_person.name", QStringLiteral("wilma"));
        QVERIFY2(renamed->isVisible() && renamed->text().contains(QStringLiteral("only wilma can be used")),
                 qPrintable(renamed->text()));
        QCOMPARE(renamed->text().contains(QStringLiteral("slip")), hasSlip);
        VERIFY_READABLE(desk.dialog("edit_person"));
        desk.click("edit_person.cancel");
        QTRY_VERIFY_WITH_TIMEOUT(!desk.dialog("edit_person"), kPatience_ms);
    }
}

void TestPeople::renamingOneselfIsSeenAtOnce() {
    PeopleDesk desk;
    desk.choose(QStringLiteral("ada"));
    desk.click("people.edit");
    const auto shown = [&] { return desk.find<QLabel>(QStringLiteral("nav.person"))->text(); };
    QCOMPARE(shown(), QStringLiteral("Ada Lovelace")); // people are called by their full names
    desk.set("edit_person.name", QStringLiteral("augusta"));
    desk.set("edit_person.full_name", QStringLiteral("Augusta King"));
    desk.click("edit_person.accept");
    QTRY_VERIFY_WITH_TIMEOUT(desk.rowOf(QStringLiteral("augusta")) >= 0, kPatience_ms);
    QCOMPARE(shown(), QStringLiteral("Augusta King"));
    QTRY_VERIFY_WITH_TIMEOUT(!desk.dialog("edit_person"), kPatience_ms);
    desk.choose(QStringLiteral("augusta"));
    desk.click("people.edit");
    desk.set("edit_person.full_name", QString());
    desk.click("edit_person.accept");
    QTRY_COMPARE_WITH_TIMEOUT(desk.cell(QStringLiteral("augusta"), 1), QString(), kPatience_ms);
    QCOMPARE(shown(), QStringLiteral("augusta")); // who has none
    QTRY_VERIFY_WITH_TIMEOUT(!desk.dialog("edit_person"), kPatience_ms);
    desk.choose(QStringLiteral("tina")); // she still may, under her present login
    desk.click("people.enable");
    QTRY_COMPARE_WITH_TIMEOUT(desk.cell(QStringLiteral("tina"), 3), QStringLiteral("Disabled"), kPatience_ms);
}

void TestPeople::germanExcelIsImportedAndSlipsArePrinted() {
    PeopleDesk desk;
    QVERIFY(desk.database()
                .write([&](database::WriteContext& writing) {
                    return database::SiteRepository(writing.connection(), desk.context.actor())
                        .setSiteName("Nordklinik");
                })
                .has_value());
    const QString file = desk.folder() + QStringLiteral("/Kurs.csv");
    write(file, "Name;Vorname;Anmeldename;Rolle;Gruppe\r\nM\xfcller;J\xf6rg;mueller;Lernende "
                "Person;A\r\nGro\xdf;Uwe;gross;Ausbilder/in;A\r\n");
    desk.screen<desktop::PeopleScreen>()->importRoster(file);
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QTableWidget>(QStringLiteral("roster.people")), kPatience_ms);
    QVERIFY(desk.find<QLabel>(QStringLiteral("roster.read"))
                ->text()
                .contains(QStringLiteral("Windows-1252, separated by semicolons")));
    const QString summary = desk.find<QFrame>(QStringLiteral("roster.summary"))
                                ->findChild<QLabel*>(QStringLiteral("notice.text"))
                                ->text();
    QVERIFY2(summary.contains(QStringLiteral("Gruppe")) && summary.contains(QStringLiteral("shown once")),
             qPrintable(summary));
    QVERIFY(!desk.find<QRadioButton>(QStringLiteral("roster.update"))
                 ->isVisible()); // nobody in the list is here yet: no question
    QVERIFY(desk.isEnabled("roster.accept"));
    picture(desk.dialog("roster"), QStringLiteral("people_roster_german"));
    desk.click("roster.accept");
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QTableWidget>(QStringLiteral("slips.people")), kPatience_ms);
    auto* table = desk.find<QTableWidget>(QStringLiteral("slips.people"));
    QCOMPARE(table->rowCount(), 2);
    QCOMPARE(table->item(0, 0)->text(), QStringLiteral("Jörg Müller"));
    const QString password = table->item(0, 2)->text();
    const auto joerg = database::AccountService(desk.database()).login("mueller", password.toStdString());
    QVERIFY(joerg && joerg->mustChangePassword());
    VERIFY_READABLE(desk.dialog("roster"));
    picture(desk.dialog("roster"), QStringLiteral("people_slips"));
    QCOMPARE(desk.dialog("roster")->focusWidget()->objectName(),
             QStringLiteral("slips.print")); // Enter does not close
    // Closing is asked about once while nobody has the passwords on paper.
    desk.click("roster.cancel");
    QVERIFY(desk.dialog("roster")->isVisible() &&
            desk.notice("roster.notice").contains(QStringLiteral("neither printed nor saved")));
    QTRY_COMPARE_WITH_TIMEOUT(desk.find<QLineEdit>(QStringLiteral("slips.site"))->text(),
                              QStringLiteral("Nordklinik"), kPatience_ms); // the site's own
    desk.set("slips.site", QStringLiteral("Skills lab"));
    const QString pdf = desk.folder() + QStringLiteral("/slips.pdf");
    auto* slips = desk.find<desktop::SlipsPanel>(QString());
    slips->saveTo(desk.folder() + QStringLiteral("/nowhere/slips.pdf"));
    QVERIFY(!slips->isTaken() && desk.notice("slips.notice").contains(QStringLiteral("not saved")));
    desk.dialog("roster")->resize(desk.dialog("roster")->width(),
                                  300); // what is said comes into sight by itself
    slips->saveTo(pdf);
    const auto* said = desk.find<desktop::NoticeArea>(QStringLiteral("slips.notice"));
    QTRY_VERIFY_WITH_TIMEOUT(said->visibleRegion().boundingRect().height() == said->height(), kPatience_ms);
    QVERIFY(slips->isTaken() && QFileInfo(pdf).size() > 1000);
    QVERIFY((QFileInfo(pdf).permissions() & (QFile::ReadGroup | QFile::ReadOther)) == QFile::Permissions());
    desk.click("slips.save"); // asks for a file
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QFileDialog>(QString()), kPatience_ms);
    QCOMPARE(desk.find<QFileDialog>(QString())->defaultSuffix(), QStringLiteral("pdf"));
    desk.find<QFileDialog>(QString())->reject();
    desk.click("roster.cancel");
    QTRY_VERIFY_WITH_TIMEOUT(!desk.dialog("roster"), kPatience_ms);
    QCOMPARE(desk.table()->model()->rowCount(), 7);
    // It is on the paper that was asked for, and in nothing that the program keeps.
    QDirIterator files(desk.folder(), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile stored(files.next());
        QVERIFY(stored.open(QIODevice::ReadOnly));
        QVERIFY2(!stored.readAll().contains(password.toUtf8()), qPrintable(stored.fileName()));
    }
}

void TestPeople::whoExistsIsUpdatedWhenAsked() {
    PeopleDesk desk;
    const QString file = desk.folder() + QStringLiteral("/roster.csv");
    write(file, "login name;full name;role\nTina;Christina;trainer\ntheo;Theo Trainee;trainee\n");
    desk.screen<desktop::PeopleScreen>()->importRoster(file);
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QTableWidget>(QStringLiteral("roster.people")), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QRadioButton>(QStringLiteral("roster.update"))->isVisible(),
                             kPatience_ms);
    QVERIFY(!desk.isEnabled("roster.accept")); // both are left as they are: nothing to do
    const auto* accept = desk.find<QPushButton>(QStringLiteral("roster.accept"));
    const auto* leave = desk.find<QPushButton>(QStringLiteral("roster.cancel"));
    QVERIFY(!accept->isVisible() && leave->text() == QLatin1String("Close"));
    const QString nothing = desk.find<QFrame>(QStringLiteral("roster.summary"))
                                ->findChild<QLabel*>(QStringLiteral("notice.text"))
                                ->text();
    QCOMPARE(nothing, QStringLiteral("Nothing to import: everybody on the list is already here."));
    desk.find<QRadioButton>(QStringLiteral("roster.update"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(desk.isEnabled("roster.accept"), kPatience_ms);
    QVERIFY(accept->isVisible() && leave->text() == QLatin1String("Cancel"));
    auto* table = desk.find<QTableWidget>(QStringLiteral("roster.people"));
    QCOMPARE(table->item(0, 1)->text(), QStringLiteral("Would be updated"));
    QCOMPARE(table->item(0, 3)->text(), QStringLiteral("Tina Trainee → Christina"));
    QCOMPARE(table->item(0, 4)->text(), QStringLiteral("Trainee → Trainer"));
    QCOMPARE(table->item(1, 1)->text(), QStringLiteral("Nothing to change"));
    VERIFY_READABLE(desk.dialog("roster"));
    picture(desk.dialog("roster"), QStringLiteral("people_roster_update"));
    desk.click("roster.accept");
    QTRY_VERIFY_WITH_TIMEOUT(!desk.dialog("roster"), kPatience_ms); // no passwords: no slips
    QTRY_COMPARE_WITH_TIMEOUT(desk.cell(QStringLiteral("tina"), 1), QStringLiteral("Christina"),
                              kPatience_ms);
    QCOMPARE(desk.cell(QStringLiteral("tina"), 2), QStringLiteral("Trainer"));
    QVERIFY(database::AccountService(desk.database()).login("tina", kTestPassword).has_value());
}

/// A list from before a change of name: the person is recognised, and where the old name is somebody else's
/// today it is said.
void TestPeople::anOldListNamesWhoWasRenamed() {
    PeopleDesk desk;
    database::AccountService accounts(desk.database());
    const database::Actor ada = desk.actor("ada");
    QVERIFY(accounts.changeNames(ada, accounts.personByName(ada, "tina")->id, "christina", "Tina Trainee"));
    QVERIFY(accounts.changeNames(ada, accounts.personByName(ada, "theo")->id, "theodor", "Theo Trainee"));
    QVERIFY(accounts.createPerson(ada,
                                  {"theo", "Another Theo", {database::Role::trainee}, kTestPassword, false}));
    const QString file = desk.folder() + QStringLiteral("/roster.csv");
    write(file, "login name;full name;role\ntina;Tina T.;trainee\ntheo;Another Theo;trainee\n");
    desk.screen<desktop::PeopleScreen>()->importRoster(file);
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QTableWidget>(QStringLiteral("roster.people")), kPatience_ms);
    auto* table = desk.find<QTableWidget>(QStringLiteral("roster.people"));
    QCOMPARE(table->item(0, 1)->text(), QStringLiteral("Would be left as it is"));
    QCOMPARE(table->item(0, 2)->text(), QStringLiteral("tina, known as christina today"));
    QCOMPARE(table->item(1, 2)->text(), QStringLiteral("theo"));
    const QString summary = desk.find<QFrame>(QStringLiteral("roster.summary"))
                                ->findChild<QLabel*>(QStringLiteral("notice.text"))
                                ->text();
    QVERIFY2(summary.contains(QStringLiteral("earlier login name")), qPrintable(summary));
    QVERIFY2(
        summary.contains(QStringLiteral(
            "Line 3: the login name theo belongs to Another Theo today; it used to be that of theodor.")),
        qPrintable(summary));
    VERIFY_READABLE(desk.dialog("roster"));
    desk.find<QRadioButton>(QStringLiteral("roster.update"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(desk.isEnabled("roster.accept"), kPatience_ms);
    desk.click("roster.accept");
    QTRY_VERIFY_WITH_TIMEOUT(!desk.dialog("roster"), kPatience_ms);
    QTRY_COMPARE_WITH_TIMEOUT(desk.cell(QStringLiteral("christina"), 1), QStringLiteral("Tina T."),
                              kPatience_ms);
    QCOMPARE(desk.rowOf(QStringLiteral("tina")), -1);
    QCOMPARE(accounts.listPeople(ada)->size(), std::size_t{6});
}

/// The summary names who would be called otherwise, and says whose name of today stays.
void TestPeople::anOldFullNameIsNotGivenBack() {
    PeopleDesk desk;
    database::AccountService accounts(desk.database());
    const database::Actor ada = desk.actor("ada");
    QVERIFY(accounts.changeNames(ada, accounts.personByName(ada, "tina")->id, "tina", "Tina Weiß"));
    const QString file = desk.folder() + QStringLiteral("/roster.csv");
    write(file, "login name;full name;role\ntina;Tina Trainee;trainer\ntheo;Theodor;trainee\n");
    desk.screen<desktop::PeopleScreen>()->importRoster(file);
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QTableWidget>(QStringLiteral("roster.people")), kPatience_ms);
    desk.find<QRadioButton>(QStringLiteral("roster.update"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(desk.isEnabled("roster.accept"), kPatience_ms);
    const QString summary = desk.find<QFrame>(QStringLiteral("roster.summary"))
                                ->findChild<QLabel*>(QStringLiteral("notice.text"))
                                ->text();
    QVERIFY2(summary.contains(QStringLiteral("Theo Trainee would be called Theodor.")) &&
                 summary.contains(QStringLiteral("earlier full name")),
             qPrintable(summary));
    QVERIFY2(!summary.contains(QStringLiteral("called Tina")), qPrintable(summary));
    const auto* shown = desk.find<QTableWidget>(QStringLiteral("roster.people"))->item(0, 3);
    QCOMPARE(shown->text(), QStringLiteral("Tina Weiß"));
    QVERIFY(shown->toolTip().contains(QStringLiteral("Tina Trainee")));
    VERIFY_READABLE(desk.dialog("roster"));
    desk.click("roster.accept");
    QTRY_VERIFY_WITH_TIMEOUT(!desk.dialog("roster"), kPatience_ms);
    QTRY_COMPARE_WITH_TIMEOUT(desk.cell(QStringLiteral("tina"), 2), QStringLiteral("Trainer"), kPatience_ms);
    QCOMPARE(desk.cell(QStringLiteral("tina"), 1), QStringLiteral("Tina Weiß"));
    QCOMPARE(desk.cell(QStringLiteral("theo"), 1), QStringLiteral("Theodor"));
}

void TestPeople::otherFilesAreNamed() {
    PeopleDesk desk;
    const QString file = desk.folder() + QStringLiteral("/roster.xlsx");
    write(file, QByteArray("PK\x03\x04\x14\x00\x06\x00", 8) + QByteArray(22, '\1') + "[Content_Types].xml");
    desk.screen<desktop::PeopleScreen>()->importRoster(file);
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QFrame>(QStringLiteral("roster.problems")), kPatience_ms);
    const QString words = desk.find<QFrame>(QStringLiteral("roster.problems"))
                              ->findChild<QLabel*>(QStringLiteral("notice.text"))
                              ->text();
    QVERIFY2(words.contains(QStringLiteral("Save As")) && words.contains(QStringLiteral("CSV UTF-8")),
             qPrintable(words));
    QVERIFY(!desk.isEnabled("roster.accept"));
    VERIFY_READABLE(desk.dialog("roster"));
}

void TestPeople::templateCanBeImported_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<char>("separator");
    for (const core::Language& language : core::kLanguages) {
        const QString id = QString::fromStdString(std::string(language.id));
        const QLocale locale(QString::fromStdString(std::string(language.locale)));
        // As spreadsheets of that language save lists.
        QTest::newRow(qPrintable(id)) << id << (locale.decimalPoint() == QLatin1String(",") ? ';' : ',');
    }
}

void TestPeople::templateCanBeImported() {
    QFETCH(QString, language);
    QFETCH(char, separator);
    PeopleDesk desk;
    desk.context.setStationLanguage(language);
    settle();
    const QString file = desk.folder() + QStringLiteral("/template.csv");
    desk.screen<desktop::PeopleScreen>()->saveTemplate(file);
    QFile written(file);
    QVERIFY(written.open(QIODevice::ReadOnly));
    const database::Roster roster = database::readRoster(written.readAll().toStdString());
    QVERIFY2(roster.problems.empty(), roster.problems.empty() ? "" : roster.problems[0].words.c_str());
    QCOMPARE(roster.delimiter, separator);
    QCOMPARE(roster.rows.size(), std::size_t{2});
    QVERIFY(roster.rows[0].roles.contains(database::Role::trainee) &&
            roster.rows[1].roles.contains(database::Role::trainer));
    QVERIFY(!roster.rows[0].displayName.empty() && roster.ignoredColumns.empty());
    desk.context.setStationLanguage(QStringLiteral("en"));
}

void TestPeople::enterPressesTheFocusedButton() {
    PeopleDesk desk;
    desk.choose(QStringLiteral("tina"));
    for (const auto& [button, dialog] :
         {std::pair{"people.add", "add_person"}, std::pair{"people.edit", "edit_person"},
          std::pair{"people.roles", "roles"}, std::pair{"people.reset", "reset"},
          std::pair{"people.erase", "erase"}}) {
        desk.click(button);
        QTRY_VERIFY_WITH_TIMEOUT(desk.dialog(dialog) && desk.dialog(dialog)->isActiveWindow(), kPatience_ms);
        auto* cancel = desk.find<QPushButton>(QLatin1String(dialog) + QStringLiteral(".cancel"));
        auto* accept = desk.find<QPushButton>(QLatin1String(dialog) + QStringLiteral(".accept"));
        QVERIFY2(accept->isDefault(), dialog);
        cancel->setFocus();
        press(Qt::Key_Return);
        QTRY_VERIFY2_WITH_TIMEOUT(!desk.dialog(dialog), dialog, kPatience_ms); // left, not sent
    }
    QCOMPARE(desk.table()->model()->rowCount(), 5);
    // In a field Enter sends what is complete.
    desk.click("people.edit");
    QTRY_COMPARE_WITH_TIMEOUT(focusName(), QStringLiteral("edit_person.full_name"), kPatience_ms);
    desk.set("edit_person.full_name", QStringLiteral("Tina Tester"));
    press(Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(desk.cell(QStringLiteral("tina"), 1), QStringLiteral("Tina Tester"),
                              kPatience_ms);
    // The one that copies copies, although closing is the default.
    desk.choose(QStringLiteral("theo"));
    desk.click("people.reset");
    desk.click("reset.accept");
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QPushButton>(QStringLiteral("handed.copy")), kPatience_ms);
    desk.find<QPushButton>(QStringLiteral("handed.copy"))->setFocus();
    press(Qt::Key_Enter);
    QVERIFY(desk.dialog("reset"));
    QCOMPARE(desk.find<QPushButton>(QStringLiteral("handed.copy"))->text(), QStringLiteral("Copied"));
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
    QTRY_VERIFY_WITH_TIMEOUT(desk.table() && desk.table()->model()->rowCount() == 5, kPatience_ms);
    desk.choose(QStringLiteral("tina"));
    VERIFY_READABLE(desk.window->screen());
    picture(desk.window.get(), QStringLiteral("people_%1").arg(scale));
    for (const auto& [button, dialog] :
         {std::pair{"people.add", "add_person"}, std::pair{"people.edit", "edit_person"},
          std::pair{"people.roles", "roles"}, std::pair{"people.reset", "reset"},
          std::pair{"people.erase", "erase"}}) {
        desk.click(button);
        QTest::qWait(50);
        VERIFY_READABLE(desk.dialog(dialog));
        picture(desk.dialog(dialog), QStringLiteral("people_%1_%2").arg(QLatin1String(dialog)).arg(scale));
        desk.dialog(dialog)->close();
        QTRY_VERIFY_WITH_TIMEOUT(!desk.dialog(dialog), kPatience_ms);
    }
}

QTEST_MAIN(TestPeople)
#include "test_people.moc"
