// SPDX-License-Identifier: GPL-3.0-or-later
#include "hands.h"
#include "support/desktop_fixture.h"
#include "support/languages.h"
#include "support/patience.h"

#include "desktop/accounts/field_note.h"
#include "desktop/accounts/notice_area.h"
#include "desktop/theme/theme.h"
#include "desktop/widgets/state_panel.h"

#include <QCheckBox>
#include <QDialog>
#include <QFrame>
#include <QLabel>
#include <QListWidget>
#include <QRadioButton>
#include <QVBoxLayout>

using namespace chiron;
using namespace chiron::tests;

namespace {

/// "My account" of somebody, with what is stored on it.
class AccountDesk : public DesktopFixture {
public:
    explicit AccountDesk(const std::string& person = "tina") {
        logIn(person);
        find<QPushButton>(QStringLiteral("nav.account"))->click();
        settle();
        if (!QTest::qWaitFor([this] { return panel()->state() == desktop::StatePanel::State::content; },
                             kPatience_ms))
            qFatal("the account was not read");
    }
    desktop::StatePanel* panel() { return find<desktop::StatePanel>(QStringLiteral("account.panel")); }
    void set(const char* field, const char* text) {
        find<QLineEdit>(QLatin1String(field))->setText(QString::fromUtf8(text));
    }
    bool isEnabled(const char* name) { return find<QPushButton>(QLatin1String(name))->isEnabled(); }
    QString notice(const char* name) { return find<desktop::NoticeArea>(QLatin1String(name))->text(); }
    void setNewPassword(const char* old, const char* fresh) {
        set("account.old_password", old);
        set("account.password", fresh);
        set("account.repeat", fresh);
    }
    void choose(const char* language) {
        find<QRadioButton>(QStringLiteral("account.language.") + QLatin1String(language))->click();
        settle();
    }
};

} // namespace

/// What everybody may change about themselves.
class TestAccount : public QObject {
    Q_OBJECT
private slots:
    void everybodyGetsThere_data();
    void everybodyGetsThere();
    void changesTheFullName();
    void changesThePassword();
    void aWrongOldPasswordChangesNothing();
    void whatIsWrongInAFieldLeadsToIt();
    void anotherPasswordIsNeeded();
    void theLanguageIsThePersons();
    void theStationsLanguageIsOthers();
    void enterDoesWhatHasTheFocus();
    void anAdministratorMakesARecoveryCode();
    void aCodeIsNotLostByASlip();
    void othersHaveNoRecoveryCode();
    void fitsAtEveryScale_data();
    void fitsAtEveryScale();
};

void TestAccount::everybodyGetsThere_data() {
    QTest::addColumn<QString>("person");
    for (const char* person : {"tina", "tom", "rhea", "ada"})
        QTest::newRow(person) << QString::fromLatin1(person);
}

void TestAccount::everybodyGetsThere() {
    QFETCH(QString, person);
    AccountDesk desk(person.toStdString());
    QVERIFY(desk.find<QLabel>(QStringLiteral("account.login_name"))->text().contains(person));
    desk.go(QStringLiteral("home"));
    settle();
    press(Qt::Key_K, Qt::ControlModifier); // and from the command palette
    QTRY_COMPARE_WITH_TIMEOUT(focusName(), QStringLiteral("palette.field"), kPatience_ms);
    type(QStringLiteral("my account"));
    press(Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(desk.window->screen()->objectName(), QStringLiteral("screen.account"),
                              kPatience_ms);
}

void TestAccount::changesTheFullName() {
    AccountDesk desk;
    QCOMPARE(desk.find<QLineEdit>(QStringLiteral("account.full_name"))->text(),
             QStringLiteral("Tina Trainee"));
    QVERIFY(!desk.isEnabled("account.save_name"));
    desk.set("account.full_name", "Τίνα Weiß");
    QVERIFY(desk.isEnabled("account.save_name"));
    desk.find<QPushButton>(QStringLiteral("account.save_name"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(desk.notice("account.name_notice").contains(QStringLiteral("Τίνα Weiß")),
                             kPatience_ms);
    QVERIFY(!desk.isEnabled("account.save_name"));
    database::AccountService accounts(desk.database());
    const auto ada = desk.actor("ada");
    const auto tina = accounts.personByName(ada, "tina");
    QVERIFY(tina && tina->displayName == "Τίνα Weiß" && tina->name == "tina");
    QCOMPARE(accounts.earlierNames(ada, tina->id)->front().displayName, std::string("Tina Trainee"));
    desk.find<QLineEdit>(QStringLiteral("account.full_name"))->setText(QString(201, QLatin1Char('x')));
    QVERIFY(!desk.isEnabled("account.save_name") &&
            desk.notice("account.name_notice").contains(QStringLiteral("200")));
}

void TestAccount::changesThePassword() {
    AccountDesk desk;
    QVERIFY(!desk.isEnabled("account.change_password"));
    auto* old = desk.find<QLineEdit>(QStringLiteral("account.old_password"));
    old->setFocus();
    QTest::keyClick(old, Qt::Key_Return); // on to the new one
    QTRY_COMPARE_WITH_TIMEOUT(focusName(), QStringLiteral("account.password"), kPatience_ms);
    desk.setNewPassword(kTestPassword, "twelve-fine-horses");
    desk.set("account.repeat", "twelve-fine-hors");
    QVERIFY(!desk.isEnabled("account.change_password"));
    desk.set("account.repeat", "twelve-fine-horses");
    desk.find<QPushButton>(QStringLiteral("account.change_password"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(
        desk.notice("account.password_notice").contains(QStringLiteral("has been changed")), kPatience_ms);
    QVERIFY(desk.find<QLineEdit>(QStringLiteral("account.old_password"))->text().isEmpty() &&
            desk.find<QLineEdit>(QStringLiteral("account.password"))->text().isEmpty());
    database::AccountService accounts(desk.database());
    QVERIFY(accounts.login("tina", "twelve-fine-horses").has_value());
    QVERIFY(!accounts.login("tina", kTestPassword).has_value());
}

void TestAccount::aWrongOldPasswordChangesNothing() {
    AccountDesk desk;
    for (int i = 0; i < 3; ++i) {
        desk.setNewPassword("eleven-grey-horses", "twelve-fine-horses");
        desk.find<QPushButton>(QStringLiteral("account.change_password"))->click();
        QTRY_VERIFY_WITH_TIMEOUT(desk.notice("account.password_notice").contains(QStringLiteral("is wrong")),
                                 kPatience_ms);
        QVERIFY(desk.find<QLineEdit>(QStringLiteral("account.old_password"))->text().isEmpty());
    }
    // As at the login: after the third one somebody has to wait, and the button says how long.
    QVERIFY(!desk.isEnabled("account.change_password"));
    QVERIFY(desk.find<QPushButton>(QStringLiteral("account.change_password"))
                ->text()
                .contains(QStringLiteral("Try again")));
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QLineEdit>(QStringLiteral("account.old_password"))->isEnabled(),
                             kPatience_ms);
    desk.setNewPassword(kTestPassword, "twelve-fine-horses");
    desk.find<QPushButton>(QStringLiteral("account.change_password"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(
        desk.notice("account.password_notice").contains(QStringLiteral("has been changed")), kPatience_ms);
}

/// The keys go to it and replace what is there; with the first of them the words are gone.
void TestAccount::whatIsWrongInAFieldLeadsToIt() {
    const desktop::Theme theme = *desktop::Theme::load(desktop::ThemeName::light, 1.0);
    QWidget window;
    auto* column = new QVBoxLayout(&window);
    auto* other = new QLineEdit;
    auto* field = new QLineEdit(QStringLiteral("a wrong word"));
    field->setObjectName(QStringLiteral("secret"));
    column->addWidget(other);
    column->addWidget(field);
    auto* note = new desktop::FieldNote(theme, *column, *field);
    window.show();
    other->setFocus();
    const auto* words = window.findChild<QLabel*>(QStringLiteral("secret.note"));
    QVERIFY(words && words->isHidden());
    note->say(QStringLiteral("It is wrong."));
    QCOMPARE(window.focusWidget(), static_cast<QWidget*>(field));
    QCOMPARE(field->selectedText(), QStringLiteral("a wrong word"));
    QCOMPARE(field->property("kind").toString(), QStringLiteral("bad"));
    QCOMPARE(field->accessibleDescription(), QStringLiteral("It is wrong."));
    QVERIFY(words->isVisible());
    QCOMPARE(words->text(), QStringLiteral("It is wrong."));
    QCOMPARE(words->accessibleName(), QStringLiteral("It is wrong."));
    QTest::keyClicks(field, QStringLiteral("r"));
    QCOMPARE(field->text(), QStringLiteral("r"));
    QVERIFY(words->isHidden() && field->accessibleDescription().isEmpty() &&
            field->property("kind").toString().isEmpty());
}

void TestAccount::anotherPasswordIsNeeded() {
    AccountDesk desk;
    desk.setNewPassword(kTestPassword, kTestPassword);
    desk.find<QPushButton>(QStringLiteral("account.change_password"))->click();
    QVERIFY(desk.notice("account.password_notice").contains(QStringLiteral("that you have now")));
    QVERIFY(database::AccountService(desk.database()).login("tina", kTestPassword).has_value());
}

void TestAccount::theLanguageIsThePersons() {
    AccountDesk desk;
    desk.choose("de");
    QTRY_COMPARE_WITH_TIMEOUT(desk.window->screen()->title(), QStringLiteral("Mein Konto"), kPatience_ms);
    QCOMPARE(focusName(),
             QStringLiteral("account.language.de")); // where it was before the screen was built anew
    QCOMPARE(desk.settings.language(), QStringLiteral("en"));
    QCOMPARE(QLocale().language(), QLocale::German);
    desk.context.logOut();
    settle();
    QCOMPARE(desk.window->screen()->title(), QStringLiteral("Log in")); // the station's again
    desk.logIn("theo");
    settle();
    QCOMPARE(desk.context.language(), QStringLiteral("en"));
    desk.logIn("tina");
    settle();
    QCOMPARE(desk.context.language(), QStringLiteral("de"));
    QCOMPARE(desk.window->screen()->title(), QStringLiteral("Start"));
    desk.go(QStringLiteral("account"));
    settle();
    desk.choose("station");
    QTRY_COMPARE_WITH_TIMEOUT(desk.window->screen()->title(), QStringLiteral("My account"), kPatience_ms);
}

void TestAccount::theStationsLanguageIsOthers() {
    AccountDesk desk;
    desk.context.setStationLanguage(
        QStringLiteral("el")); // as the settings screen does: she has none of her own
    QCOMPARE(desk.settings.language(), QStringLiteral("el"));
    QVERIFY(desk.context.ownLanguage().isEmpty());
    desk.context.setOwnLanguage(QStringLiteral("de"));
    desk.context.setStationLanguage(QStringLiteral("en")); // what she chooses is what she sees
    QCOMPARE(desk.context.language(), QStringLiteral("en"));
    QCOMPARE(desk.context.ownLanguage(), QStringLiteral("en"));
    desk.settings.setOfPerson(desk.context.actor().personId(), QStringLiteral("language"),
                              QStringLiteral("tlh"));
    QCOMPARE(desk.context.language(), QStringLiteral("en")); // a broken setting gives the station's
}

void TestAccount::enterDoesWhatHasTheFocus() {
    AccountDesk desk;
    desk.set("account.full_name", "Tina Tester");
    desk.find<QLineEdit>(QStringLiteral("account.full_name"))->setFocus();
    press(Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(desk.notice("account.name_notice").contains(QStringLiteral("Tina Tester")),
                             kPatience_ms);
    desk.setNewPassword(kTestPassword, "twelve-fine-horses");
    QVERIFY(tabTo(QStringLiteral("account.change_password")));
    press(Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(
        desk.notice("account.password_notice").contains(QStringLiteral("has been changed")), kPatience_ms);
}

/// Somebody who became an administrator: Home says so until it is done, and the code that is shown works.
void TestAccount::anAdministratorMakesARecoveryCode() {
    DesktopFixture desk;
    database::AccountService accounts(desk.database());
    QVERIFY(accounts.createPerson(desk.actor("ada"),
                                  {"otto", "Otto", {database::Role::admin}, kTestPassword, false}));
    desk.logIn("ada"); // has the one that was shown when the site was set up
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QPushButton>(QStringLiteral("home.people")), kPatience_ms);
    QVERIFY(!desk.find<QFrame>(QStringLiteral("home.recovery_code")));
    desk.logIn("otto");
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QPushButton>(QStringLiteral("home.make_recovery_code")), kPatience_ms);
    desk.find<QPushButton>(QStringLiteral("home.make_recovery_code"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QLabel>(QStringLiteral("account.recovery_state")) &&
                                 desk.find<QLabel>(QStringLiteral("account.recovery_state"))
                                     ->text()
                                     .contains(QStringLiteral("none yet")),
                             kPatience_ms);
    QTRY_COMPARE_WITH_TIMEOUT(focusName(), QStringLiteral("account.recovery"), kPatience_ms);
    desk.find<QPushButton>(QStringLiteral("account.recovery"))->click();
    auto* accept = desk.find<QPushButton>(QStringLiteral("recovery_code.accept"));
    QVERIFY(accept && !accept->isEnabled());
    QCOMPARE(accept->text(), QStringLiteral("Make the code"));
    desk.find<QLineEdit>(QStringLiteral("recovery_code.password"))
        ->setText(QStringLiteral("not the password"));
    accept->click();
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QLabel>(QStringLiteral("recovery_code.password.note"))->isVisible(),
                             kPatience_ms);
    QVERIFY(!desk.find<QLabel>(QStringLiteral("recovery.code")));
    desk.find<QLineEdit>(QStringLiteral("recovery_code.password"))
        ->setText(QString::fromLatin1(kTestPassword));
    accept->click();
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QLabel>(QStringLiteral("recovery.code")), kPatience_ms);
    const std::string code = desk.find<QLabel>(QStringLiteral("recovery.code"))->text().toStdString();
    QVERIFY(desk.find<QLabel>(QStringLiteral("recovery.backups"))
                ->text()
                .contains(QStringLiteral("no recovery code of yours")));
    VERIFY_READABLE(desk.find<QDialog>(QStringLiteral("recovery_code")));
    desk.find<QCheckBox>(QStringLiteral("recovery.written"))->click();
    desk.find<QPushButton>(QStringLiteral("recovery.continue"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(!desk.find<QDialog>(QStringLiteral("recovery_code")), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QLabel>(QStringLiteral("account.recovery_state"))
                                 ->text()
                                 .contains(QStringLiteral("You have one")),
                             kPatience_ms);
    desk.go(QStringLiteral("home"));
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QPushButton>(QStringLiteral("home.people")), kPatience_ms);
    QVERIFY(!desk.window->screen()->findChild<QFrame*>(QStringLiteral("home.recovery_code")));
    QVERIFY(accounts.recover("otto", code, "twelve-fine-horses").has_value());
    QVERIFY(accounts.login("otto", "twelve-fine-horses").has_value());
}

/// Shown once: leaving without having written it down is asked about, once.
void TestAccount::aCodeIsNotLostByASlip() {
    AccountDesk desk("ada");
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QLabel>(QStringLiteral("account.recovery_state"))
                                 ->text()
                                 .contains(QStringLiteral("You have one")),
                             kPatience_ms);
    desk.find<QPushButton>(QStringLiteral("account.recovery"))->click();
    desk.find<QLineEdit>(QStringLiteral("recovery_code.password"))
        ->setText(QString::fromLatin1(kTestPassword));
    desk.find<QPushButton>(QStringLiteral("recovery_code.accept"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QLabel>(QStringLiteral("recovery.code")), kPatience_ms);
    auto* dialog = desk.find<QDialog>(QStringLiteral("recovery_code"));
    QVERIFY(!desk.find<QPushButton>(QStringLiteral("recovery_code.cancel"))
                 ->isVisible()); // one way out: the button that needs the tick
    QVERIFY(!desk.isEnabled("recovery.continue"));
    QCOMPARE(dialog->focusWidget()->objectName(), QStringLiteral("recovery.copy"));
    QVERIFY(desk.find<QLabel>(QStringLiteral("recovery.backups"))
                ->text()
                .contains(QStringLiteral("still have the earlier code")));
    QTest::keyClick(dialog, Qt::Key_Escape);
    QVERIFY(dialog->isVisible());
    QVERIFY(desk.notice("recovery_code.notice").contains(QStringLiteral("not shown again")));
    QTest::keyClick(dialog, Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(!desk.find<QDialog>(QStringLiteral("recovery_code")), kPatience_ms);
}

void TestAccount::othersHaveNoRecoveryCode() {
    AccountDesk desk("tom");
    QVERIFY(!desk.find<QPushButton>(QStringLiteral("account.recovery")));
}

void TestAccount::fitsAtEveryScale_data() {
    QTest::addColumn<double>("scale");
    QTest::addColumn<QString>("language");
    QTest::newRow("100 %") << 1.0 << "en";
    for (const char* language : tests::otherLanguages())
        QTest::addRow("200 %% %s", language) << 2.0 << language;
}

void TestAccount::fitsAtEveryScale() {
    QFETCH(double, scale);
    QFETCH(QString, language);
    AccountDesk desk;
    desk.settings.setScale(scale);
    desk.context.setStationLanguage(language);
    settle();
    QTRY_COMPARE_WITH_TIMEOUT(desk.panel()->state(), desktop::StatePanel::State::content, kPatience_ms);
    VERIFY_READABLE(desk.window->screen());
    picture(desk.window.get(), QStringLiteral("account_%1_%2").arg(language).arg(scale));
    desk.context.setStationLanguage(QStringLiteral("en"));
}

QTEST_MAIN(TestAccount)
#include "test_account.moc"
