// SPDX-License-Identifier: GPL-3.0-or-later
#include "hands.h"
#include "support/desktop_fixture.h"
#include "support/patience.h"

#include "desktop/accounts/notice_area.h"
#include "desktop/login/login_screen.h"
#include "desktop/login/name_list.h"
#include "desktop/widgets/state_panel.h"

#include <QLabel>
#include <QListWidget>

using namespace chiron;
using namespace chiron::tests;

/// Logging in: by name, with wrong passwords, with a password that somebody else has set.
class TestLogin : public QObject {
    Q_OBJECT
private slots:
    void aListWithoutNamesMissesNobody();
    void namesAreFoundByTyping();
    void theSitesNameIsGivenInTheSettingsAndShown();
    void wrongPasswordsMakeItWait();
    void unknownNamesAreToldTheSame();
    void oneExplanationAtATime();
    void disabledAccountsAreToldSo();
    void resetForcesAPasswordOfOnesOwn();
    void othersAreToldWhomToAsk();
    void failedSiteCanBeTriedAgain();
    void fitsAtEveryScale_data();
    void fitsAtEveryScale();
    void theButtonOfAFormIsInSight_data();
    void theButtonOfAFormIsInSight();

private:
    static void openLogin(DesktopFixture& desktop);
    static void tryPassword(DesktopFixture& desktop, const QString& name, const QString& password);
    static QString notice(DesktopFixture& desktop, const char* name = "login.notice") {
        return desktop.find<desktop::NoticeArea>(QLatin1String(name))->text();
    }
};

void TestLogin::openLogin(DesktopFixture& desktop) {
    desktop.context.navigator().replace({QStringLiteral("login"), {}});
    const auto people = [&desktop] {
        return desktop.find<QListWidget>(QStringLiteral("login.people"));
    }; // made once the names are there
    QTRY_VERIFY_WITH_TIMEOUT(people() && people()->count() > 0, kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(focusName() == QLatin1String("login.name"), kPatience_ms);
}

void TestLogin::tryPassword(DesktopFixture& desktop, const QString& name, const QString& password) {
    desktop.find<QLineEdit>(QStringLiteral("login.name"))->setText(name);
    desktop.find<QLineEdit>(QStringLiteral("login.password"))->setText(password);
    desktop.find<QPushButton>(QStringLiteral("login.enter"))->click();
}

void TestLogin::namesAreFoundByTyping() {
    DesktopFixture desktop;
    openLogin(desktop);
    auto* list = desktop.find<QListWidget>(QStringLiteral("login.people"));
    QCOMPARE(list->count(), 5);
    picture(desktop.window.get(), QStringLiteral("login"));
    type(QStringLiteral("nobody"));
    press(Qt::Key_Down); // no name is shown to go to
    QCOMPARE(focusName(), QStringLiteral("login.name"));
    desktop.find<QLineEdit>(QStringLiteral("login.name"))->clear();
    type(QStringLiteral("trainee"));
    int shown = 0;
    for (int i = 0; i < list->count(); ++i)
        shown += list->item(i)->isHidden() ? 0 : 1;
    QCOMPARE(shown, 2); // by full name too
    press(Qt::Key_Down);
    QCOMPARE(focusName(), QStringLiteral("login.people"));
    const QString chosen = desktop.find<QLineEdit>(QStringLiteral("login.name"))->text();
    for (int i = 0; i < list->count(); ++i)
        if (list->item(i)->isHidden()) {
            list->setCurrentRow(i); // as letters typed into the list do: nobody is chosen unseen
            QCOMPARE(desktop.find<QLineEdit>(QStringLiteral("login.name"))->text(), chosen);
        }
    list->setCurrentRow(-1);
    press(Qt::Key_Down);
    press(Qt::Key_Down);
    press(Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(focusName(), QStringLiteral("login.password"), kPatience_ms);
    QCOMPARE(desktop.find<QLineEdit>(QStringLiteral("login.name"))->text(), QStringLiteral("tina"));
    type(QLatin1String(kTestPassword));
    press(Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(desktop.context.loggedIn(), kPatience_ms);
    QCOMPARE(desktop.context.actor().name(), std::string("tina"));
    QCOMPARE(desktop.context.navigator().current().screen, QStringLiteral("home"));
}

/// An administrator gives the name; nobody else is asked for it; everybody sees it before they log in.
void TestLogin::theSitesNameIsGivenInTheSettingsAndShown() {
    DesktopFixture desktop;
    openLogin(desktop);
    QVERIFY(!desktop.find<QLabel>(QStringLiteral("login.site_name"))->isVisible());
    desktop.logIn("tina");
    desktop.go(QStringLiteral("settings"));
    QVERIFY(!desktop.find<QLineEdit>(QStringLiteral("settings.site_name")));
    desktop.logIn("ada");
    desktop.go(QStringLiteral("settings"));
    auto* name = desktop.find<QLineEdit>(QStringLiteral("settings.site_name"));
    QTRY_VERIFY_WITH_TIMEOUT(name->isEnabled(), kPatience_ms);
    QVERIFY(!desktop.find<QPushButton>(QStringLiteral("settings.save_site_name"))->isEnabled());
    name->setText(QStringLiteral("Nordklinik, Lehrstation 2"));
    desktop.find<QPushButton>(QStringLiteral("settings.save_site_name"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(
        notice(desktop, "settings.site_notice").contains(QStringLiteral("Nordklinik, Lehrstation 2")),
        kPatience_ms);
    VERIFY_READABLE(desktop.window->screen());
    desktop.context.logOut();
    openLogin(desktop);
    QTRY_VERIFY_WITH_TIMEOUT(desktop.find<QLabel>(QStringLiteral("login.site_name"))->isVisible(),
                             kPatience_ms);
    QCOMPARE(desktop.find<QLabel>(QStringLiteral("login.site_name"))->text(),
             QStringLiteral("Nordklinik, Lehrstation 2"));
}

void TestLogin::wrongPasswordsMakeItWait() {
    DesktopFixture desktop;
    openLogin(desktop);
    auto* password = desktop.find<QLineEdit>(QStringLiteral("login.password"));
    auto* enter = desktop.find<QPushButton>(QStringLiteral("login.enter"));
    for (int attempt = 1; attempt <= 3; ++attempt) {
        tryPassword(desktop, QStringLiteral("tina"), QStringLiteral("wrong word %1").arg(attempt));
        QVERIFY(!enter->isEnabled()); // nobody sends it twice
        QTRY_VERIFY_WITH_TIMEOUT(password->text().isEmpty(), kPatience_ms);
        QVERIFY(notice(desktop).contains(QStringLiteral("Wrong name or password")));
    }
    QVERIFY(!password->isEnabled() && enter->text().contains(QStringLiteral("again")));
    picture(desktop.window.get(), QStringLiteral("login_wait"));
    QTRY_VERIFY_WITH_TIMEOUT(password->isEnabled(), kPatience_ms);
    QCOMPARE(enter->text(), QStringLiteral("Log in"));
    tryPassword(desktop, QStringLiteral("tina"), QLatin1String(kTestPassword));
    QTRY_VERIFY_WITH_TIMEOUT(desktop.context.loggedIn(), kPatience_ms);
}

void TestLogin::unknownNamesAreToldTheSame() {
    DesktopFixture desktop;
    openLogin(desktop);
    tryPassword(desktop, QStringLiteral("tina"), QStringLiteral("wrong word 1"));
    QTRY_VERIFY_WITH_TIMEOUT(!notice(desktop).isEmpty(), kPatience_ms);
    const QString known = notice(desktop);
    tryPassword(desktop, QStringLiteral("nobody"), QStringLiteral("wrong word 1"));
    QTRY_VERIFY_WITH_TIMEOUT(!notice(desktop).isEmpty(), kPatience_ms);
    QCOMPARE(notice(desktop), known);
    QVERIFY(!desktop.context.loggedIn());
}

/// A name that nobody has (any more): what the list says of it makes room for the answer, and the answer for
/// the next name.
void TestLogin::oneExplanationAtATime() {
    DesktopFixture desktop;
    openLogin(desktop);
    type(QStringLiteral("xaver"));
    auto* nobody = desktop.find<QLabel>(QStringLiteral("login.nobody"));
    QVERIFY(nobody && nobody->isVisible() &&
            nobody->text().contains(QStringLiteral("your login name may have changed")));
    desktop.find<QLineEdit>(QStringLiteral("login.password"))->setText(QStringLiteral("wrong word 1"));
    desktop.find<QPushButton>(QStringLiteral("login.enter"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(notice(desktop).contains(QStringLiteral("your login name may have changed")),
                             kPatience_ms);
    QVERIFY(!nobody->isVisible());
    VERIFY_READABLE(desktop.window->screen());
    desktop.find<QLineEdit>(QStringLiteral("login.name"))->setFocus();
    press(Qt::Key_End);
    type(QStringLiteral("q"));
    QVERIFY(nobody->isVisible() && notice(desktop).isEmpty());
}

void TestLogin::disabledAccountsAreToldSo() {
    DesktopFixture desktop;
    openLogin(desktop);
    database::AccountService accounts(desktop.database());
    const auto tina = desktop.actor("tina");
    QVERIFY(accounts.setEnabled(desktop.actor("ada"), tina.personId(), false).has_value());
    tryPassword(desktop, QStringLiteral("tina"), QLatin1String(kTestPassword));
    QTRY_VERIFY_WITH_TIMEOUT(notice(desktop).contains(QStringLiteral("disabled")), kPatience_ms);
    openLogin(desktop);
    QCOMPARE(desktop.find<QListWidget>(QStringLiteral("login.people"))->count(), 4);
}

void TestLogin::resetForcesAPasswordOfOnesOwn() {
    DesktopFixture desktop;
    database::AccountService accounts(desktop.database());
    QVERIFY(accounts.resetPassword(desktop.actor("ada"), desktop.actor("tina").personId(), "given-by-ada-1")
                .has_value());
    openLogin(desktop);
    tryPassword(desktop, QStringLiteral("tina"), QStringLiteral("given-by-ada-1"));
    QTRY_VERIFY_WITH_TIMEOUT(desktop.find<QPushButton>(QStringLiteral("change.save")), kPatience_ms);
    QVERIFY(!desktop.context.loggedIn());
    QTRY_COMPARE_WITH_TIMEOUT(focusName(), QStringLiteral("change.password"), kPatience_ms);
    type(QStringLiteral("given-by-ada-1"));
    press(Qt::Key_Return);
    type(QStringLiteral("given-by-ada-1"));
    press(Qt::Key_Return);
    QVERIFY(notice(desktop, "change.notice").contains(QStringLiteral("another one")));
    VERIFY_READABLE(desktop.window->screen());
    picture(desktop.window.get(), QStringLiteral("login_forced"));
    for (const char* field : {"change.password", "change.repeat"})
        desktop.find<QLineEdit>(QLatin1String(field))->setText(QStringLiteral("tinas-own-word-2"));
    desktop.find<QLineEdit>(QStringLiteral("change.repeat"))->setFocus();
    press(Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(desktop.context.loggedIn(), kPatience_ms);
    QVERIFY(!desktop.context.actor().mustChangePassword());
    QVERIFY(accounts.login("tina", "tinas-own-word-2").has_value());
}

void TestLogin::othersAreToldWhomToAsk() {
    DesktopFixture desktop;
    openLogin(desktop);
    desktop.find<QLineEdit>(QStringLiteral("login.name"))->setText(QStringLiteral("tina"));
    desktop.find<QPushButton>(QStringLiteral("login.forgotten"))->click();
    QCOMPARE(desktop.find<QLineEdit>(QStringLiteral("recovery.name"))->text(), QStringLiteral("tina"));
    QTRY_COMPARE_WITH_TIMEOUT(focusName(), QStringLiteral("recovery.code_field"), kPatience_ms);
    VERIFY_READABLE(desktop.window->screen());
    type(QStringLiteral("AAAAA-AAAAA-AAAAA-AAAAA-AAAAA"));
    for (const char* field : {"recovery.password", "recovery.repeat"})
        desktop.find<QLineEdit>(QLatin1String(field))->setText(QStringLiteral("tinas-own-word-2"));
    desktop.find<QPushButton>(QStringLiteral("recovery.save"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(notice(desktop, "recovery.notice").contains(QStringLiteral("recovery code")),
                             kPatience_ms);
    QVERIFY(!desktop.context.loggedIn());
    desktop.find<QPushButton>(QStringLiteral("recovery.back"))->click();
    QVERIFY(desktop.find<QPushButton>(QStringLiteral("login.enter"))->isVisible());
}

void TestLogin::failedSiteCanBeTriedAgain() {
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("site.db"));
    QVERIFY(QDir().mkpath(file)); // a folder where the database should be
    desktop::Settings settings(folder.filePath(QStringLiteral("desktop.ini")));
    settings.setLanguage(QStringLiteral("en"));
    desktop::DesktopSite site(file, DesktopFixture::options());
    desktop::AppContext context(site, settings);
    desktop::applyAppearance(*qApp, context);
    desktop::MainWindow window(context);
    context.navigator().replace({QStringLiteral("login"), {}});
    window.show();
    auto* panel = window.findChild<desktop::StatePanel*>(QStringLiteral("login.site"));
    QCOMPARE(panel->state(), desktop::StatePanel::State::loading);
    context.openSite();
    QTRY_COMPARE_WITH_TIMEOUT(panel->state(), desktop::StatePanel::State::error, kPatience_ms);
    picture(&window, QStringLiteral("login_failed"));
    // Another theme builds the screen anew: it tries again by itself, and tells again.
    settings.setTheme(desktop::ThemeName::dark);
    context.applyAppearance();
    QTRY_VERIFY_WITH_TIMEOUT(
        window.findChild<desktop::StatePanel*>(QStringLiteral("login.site")) &&
            window.findChild<desktop::StatePanel*>(QStringLiteral("login.site"))->state() ==
                desktop::StatePanel::State::error,
        kPatience_ms);
    context.background().cancelAndWait();
}

void TestLogin::fitsAtEveryScale_data() {
    QTest::addColumn<double>("scale");
    QTest::addColumn<int>("theme");
    QTest::newRow("100 %") << 1.0 << 0;
    QTest::newRow("200 % dark") << 2.0 << 1;
}

void TestLogin::fitsAtEveryScale() {
    QFETCH(double, scale);
    QFETCH(int, theme);
    DesktopFixture desktop;
    desktop.settings.setScale(scale);
    desktop.settings.setTheme(static_cast<desktop::ThemeName>(theme));
    desktop.context.applyAppearance();
    openLogin(desktop);
    VERIFY_READABLE(desktop.window->screen());
    desktop.find<QPushButton>(QStringLiteral("login.forgotten"))->click();
    QTest::qWait(50);
    VERIFY_READABLE(desktop.window->screen());
    picture(desktop.window.get(), QStringLiteral("login_recovery_%1").arg(scale));
}

void TestLogin::theButtonOfAFormIsInSight_data() {
    QTest::addColumn<double>("scale");
    QTest::newRow("100 %") << 1.0;
    QTest::newRow("200 %") << 2.0;
}

/// In the smallest window, without scrolling; and gone with its form.
void TestLogin::theButtonOfAFormIsInSight() {
    QFETCH(double, scale);
    DesktopFixture desktop;
    desktop.settings.setScale(scale);
    desktop.window->resize(1280, 720);
    desktop.context.applyAppearance();
    database::AccountService accounts(desktop.database());
    QVERIFY(accounts.resetPassword(desktop.actor("ada"), desktop.actor("tina").personId(), "given-by-ada-1")
                .has_value());
    openLogin(desktop);
    const auto inSight = [&](const char* name) {
        const auto* button = desktop.find<QPushButton>(QLatin1String(name));
        return button && button->isVisible() && button->visibleRegion().boundingRect() == button->rect();
    };
    desktop.find<QPushButton>(QStringLiteral("login.forgotten"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(inSight("recovery.save") && inSight("recovery.back"), kPatience_ms);
    desktop.find<QPushButton>(QStringLiteral("recovery.back"))->click();
    settle();
    QVERIFY(!desktop.find<QPushButton>(QStringLiteral("recovery.save")));
    tryPassword(desktop, QStringLiteral("tina"), QStringLiteral("given-by-ada-1"));
    QTRY_VERIFY_WITH_TIMEOUT(inSight("change.save") && inSight("change.back"), kPatience_ms);
}

/// "Nobody with this name" is said only if the list has names: an empty list may just not have been read yet.
void TestLogin::aListWithoutNamesMissesNobody() {
    tests::DesktopFixture desktop;
    desktop::NameList list(desktop.context.theme());
    list.show();
    QLabel* none = nullptr;
    for (auto* label : list.findChildren<QLabel*>())
        if (label->text().startsWith(QStringLiteral("Nobody with this name")))
            none = label;
    QVERIFY(none);
    list.setName(QStringLiteral("tina"));
    QVERIFY(none->isHidden());
    list.setNames({{1, "theo", ""}});
    list.setName(QStringLiteral("tina"));
    QVERIFY(!none->isHidden());
    list.setName(QStringLiteral("th"));
    QVERIFY(none->isHidden());
}

QTEST_MAIN(TestLogin)
#include "test_login.moc"
