// SPDX-License-Identifier: GPL-3.0-or-later
#include "hands.h"

#include "database/accounts/account_service.h"
#include "desktop/first_start/first_start_screen.h"
#include "desktop/first_start/site_maker.h"
#include "desktop/frame/app_context.h"
#include "desktop/frame/main_window.h"
#include "desktop/frame/program.h"
#include "session/demo_site.h"
#include "support/patience.h"

#include <QCheckBox>
#include <QDir>
#include <QLabel>
#include <QListWidget>
#include <QTemporaryDir>

using namespace chiron;
using namespace chiron::tests;

namespace {

constexpr const char* kPassword = "eleven-fine-horses";

database::DatabaseOptions cheap() {
    database::DatabaseOptions options;
    options.passwordCost = database::PasswordCost::minimalForTests();
    return options;
}

/// The program on a station that has nothing yet.
class EmptyStation {
public:
    EmptyStation() {
        settings.setLanguage(QStringLiteral("en"));
        desktop::applyAppearance(*qApp, context);
        QObject::connect(&context, &desktop::AppContext::appearanceChanged, qApp,
                         [this] { desktop::applyAppearance(*qApp, context); });
        window = std::make_unique<desktop::MainWindow>(context);
    }
    ~EmptyStation() {
        context.background().cancelAndWait();
        window.reset();
    }
    void show(const char* screen) {
        context.navigator().replace({QLatin1String(screen), {}});
        window->show();
        window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window.get()));
    }
    QString file() const { return folder.filePath(QStringLiteral("site.db")); }
    template <class W> W* find(const char* name) const { return window->findChild<W*>(QLatin1String(name)); }

    QTemporaryDir folder;
    desktop::Settings settings{folder.filePath(QStringLiteral("desktop.ini"))};
    desktop::DesktopSite site{file(), cheap()};
    desktop::AppContext context{site, settings};
    std::unique_ptr<desktop::MainWindow> window;
};

} // namespace

/// First start: a site of one's own, or the demonstration.
class TestFirstStart : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { qputenv("CHIRON_CONTENT", CHIRON_SOURCE_DIR "/curriculum/content"); }
    void setUpByKeyboardThenRecover();
    void formSaysWhatIsMissing();
    void aNameThatCannotBeStoredMakesNoSite();
    void siteWithoutPeopleAsksForItsAdministrator();
    void codeSurvivesAnotherLanguage();
    void demonstrationIsStoppedWithoutATrace();
    void demonstrationOpensWithItsHint();
    void fitsAtEveryScale_data();
    void fitsAtEveryScale();
    void theButtonOfAFormIsInSight_data();
    void theButtonOfAFormIsInSight();

private:
    void fillForm(const QString& name);
};

void TestFirstStart::fillForm(const QString& name) {
    type(name);
    press(Qt::Key_Return);
    type(QStringLiteral("Ada Lovelace"));
    press(Qt::Key_Return);
    type(QStringLiteral("Nordklinik"));
    press(Qt::Key_Return);
    type(QLatin1String(kPassword));
    press(Qt::Key_Return);
    type(QLatin1String(kPassword));
    press(Qt::Key_Return);
}

void TestFirstStart::setUpByKeyboardThenRecover() {
    EmptyStation station;
    station.show("first_start");
    QTRY_VERIFY_WITH_TIMEOUT(focusName() == QLatin1String("first_start.set_up"), kPatience_ms);
    press(Qt::Key_Space);
    fillForm(QStringLiteral("ada"));
    QTRY_VERIFY_WITH_TIMEOUT(station.find<QLabel>("recovery.code"), kPatience_ms);
    const QString code = station.find<QLabel>("recovery.code")->text();
    QCOMPARE(code.size(), 29);
    picture(station.window.get(), QStringLiteral("first_start_code"));
    // Not before it is written down.
    station.window->close();
    QVERIFY(station.window->isVisible());
    QVERIFY(!station.find<QPushButton>("recovery.continue")->isEnabled());
    QVERIFY(tabTo(QStringLiteral("recovery.written")));
    press(Qt::Key_Space);
    QVERIFY(tabTo(QStringLiteral("recovery.continue")));
    press(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(station.context.loggedIn(), kPatience_ms);
    QVERIFY(station.context.has(database::Role::admin));
    QCOMPARE(station.context.navigator().current().screen, QStringLiteral("home"));

    // Later: the password is forgotten, the code lets in, and is used up.
    station.context.logOut();
    QTRY_VERIFY_WITH_TIMEOUT(station.find<QLabel>("login.site_name") &&
                                 station.find<QLabel>("login.site_name")->text() ==
                                     QLatin1String("Nordklinik"),
                             kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(station.find<QPushButton>("login.forgotten") &&
                                 station.find<QPushButton>("login.forgotten")->isVisible(),
                             kPatience_ms);
    QTest::mouseClick(station.find<QPushButton>("login.forgotten"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(focusName() == QLatin1String("recovery.name"), kPatience_ms);
    type(QStringLiteral("ada"));
    QVERIFY(tabTo(QStringLiteral("recovery.code_field")));
    type(code.toLower()); // however it is typed
    QVERIFY(tabTo(QStringLiteral("recovery.password")));
    type(QStringLiteral("twelve-finer-horses"));
    QVERIFY(tabTo(QStringLiteral("recovery.repeat")));
    type(QStringLiteral("twelve-finer-horses"));
    picture(station.window.get(), QStringLiteral("login_recovery"));
    press(Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(station.find<QLabel>("recovery.code"), kPatience_ms);
    QVERIFY(station.find<QLabel>("recovery.code")->text() != code);
    QVERIFY(tabTo(QStringLiteral("recovery.written")));
    press(Qt::Key_Space);
    QVERIFY(tabTo(QStringLiteral("recovery.continue")));
    press(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(station.context.loggedIn(), kPatience_ms);
    QVERIFY(
        database::AccountService(station.site.database()).login("ada", "twelve-finer-horses").has_value());
}

void TestFirstStart::formSaysWhatIsMissing() {
    EmptyStation station;
    station.show("first_start");
    QTest::mouseClick(station.find<QPushButton>("first_start.set_up"), Qt::LeftButton);
    auto* create = station.find<QPushButton>("first_start.create");
    QVERIFY(!create->isEnabled());
    const auto missing = [&] {
        int count = 0;
        for (const QLabel* label : station.window->findChildren<QLabel*>())
            count += label->accessibleName().startsWith(QLatin1String("Still missing")) ? 1 : 0;
        return count;
    };
    QCOMPARE(missing(), 4);
    station.find<QLineEdit>("first_start.name")->setText(QStringLiteral("ada, the first"));
    QCOMPARE(station.find<QLineEdit>("first_start.name")->property("kind").toString(), QStringLiteral("bad"));
    station.find<QLineEdit>("first_start.name")->setText(QStringLiteral("horse-horse"));
    station.find<QLineEdit>("first_start.password")->setText(QStringLiteral("HORSE-HORSE"));
    station.find<QLineEdit>("first_start.repeat")->setText(QStringLiteral("HORSE-HORSE"));
    QCOMPARE(missing(), 1); // it is the login name
    QVERIFY(!create->isEnabled());
    picture(station.window.get(), QStringLiteral("first_start_form"));
    station.find<QLineEdit>("first_start.name")->setText(QStringLiteral("ada"));
    QCOMPARE(missing(), 0);
    QVERIFY(create->isEnabled());
    QVERIFY(!station.site.exists()); // nothing is made before it is sent
}

/// Refused before anything is made, so that the next try begins anew.
void TestFirstStart::aNameThatCannotBeStoredMakesNoSite() {
    QTemporaryDir folder;
    const std::string file = folder.filePath(QStringLiteral("site.db")).toStdString();
    for (const std::string& name : {std::string("North\nSouth"), std::string(81, 'n')}) {
        const auto made = desktop::makeSite(file, cheap(), nullptr, {"ada", "", kPassword, name});
        QVERIFY(!made && made.error().code == core::ErrorCode::badInput);
        QVERIFY(QDir(folder.path()).isEmpty());
    }
    const auto made = desktop::makeSite(file, cheap(), nullptr, {"ada", "", kPassword, std::string(80, 'n')});
    QVERIFY2(made.has_value(), made ? "" : made.error().message.c_str());
}

void TestFirstStart::siteWithoutPeopleAsksForItsAdministrator() {
    EmptyStation station;
    QVERIFY(
        database::Database::create(station.file().toStdString(), cheap()).has_value()); // and closed again
    station.show("login");
    station.context.openSite();
    QTRY_COMPARE_WITH_TIMEOUT(station.context.navigator().current().screen, QStringLiteral("first_start"),
                              kPatience_ms);
    QVERIFY(!station.find<QPushButton>("first_start.demonstration")->isVisible());
    QTRY_COMPARE_WITH_TIMEOUT(focusName(), QStringLiteral("first_start.set_up"), kPatience_ms);
    press(Qt::Key_Space);
    fillForm(QStringLiteral("ada"));
    QTRY_VERIFY_WITH_TIMEOUT(station.find<QLabel>("recovery.code"), kPatience_ms);
    QCOMPARE(database::AccountService(station.site.database()).listLoginNames()->size(), std::size_t{1});
}

void TestFirstStart::codeSurvivesAnotherLanguage() {
    EmptyStation station;
    station.show("first_start");
    QTRY_COMPARE_WITH_TIMEOUT(focusName(), QStringLiteral("first_start.set_up"), kPatience_ms);
    press(Qt::Key_Space);
    fillForm(QStringLiteral("ada"));
    QTRY_VERIFY_WITH_TIMEOUT(station.find<QLabel>("recovery.code"), kPatience_ms);
    const QString code = station.find<QLabel>("recovery.code")->text();
    station.settings.setLanguage(QStringLiteral("de"));
    station.context.applyAppearance();
    QTRY_VERIFY_WITH_TIMEOUT(station.find<QLabel>("recovery.code"), kPatience_ms);
    QCOMPARE(station.find<QLabel>("recovery.code")->text(), code);
}

void TestFirstStart::demonstrationIsStoppedWithoutATrace() {
    EmptyStation station;
    station.show("first_start");
    const QString file = desktop::FirstStartScreen::demonstrationFile(station.file());
    QTest::mouseClick(station.find<QPushButton>("first_start.demonstration"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(file), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(station.find<QPushButton>("state.cancel") &&
                                 station.find<QPushButton>("state.cancel")->isVisible(),
                             kPatience_ms);
    picture(station.window.get(), QStringLiteral("first_start_demonstration"));
    QTest::mouseClick(station.find<QPushButton>("state.cancel"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(station.find<QPushButton>("first_start.set_up"),
                             kPatience_ms); // the session that runs ends early
    QVERIFY(!QFile::exists(file) && !QFile::exists(file + QStringLiteral(".site")));
    QVERIFY(!station.site.exists() && !station.site.isOpen());
}

void TestFirstStart::demonstrationOpensWithItsHint() {
    EmptyStation station;
    {
        database::DatabaseOptions options = cheap();
        options.demonstration = true;
        const auto made = database::Database::create(
            desktop::FirstStartScreen::demonstrationFile(station.file()).toStdString(), options);
        QVERIFY(made.has_value());
        QVERIFY(database::AccountService(**made)
                    .createFirstAdministrator("amalia", session::kDemoPassword, "Amalia Administrator")
                    .has_value());
    }
    station.show("first_start");
    QTest::mouseClick(station.find<QPushButton>("first_start.demonstration"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(station.context.navigator().current().screen, QStringLiteral("login"),
                              kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(station.find<QListWidget>("login.people") &&
                                 station.find<QListWidget>("login.people")->count() == 1,
                             kPatience_ms);
    bool told = false;
    for (const QLabel* label : station.window->screen()->findChildren<QLabel*>())
        told = told || label->text().contains(QLatin1String(session::kDemoPassword));
    QVERIFY(told);
    picture(station.window.get(), QStringLiteral("login_demonstration"));
    QVERIFY(!QFile::exists(station.file())); // the station's own site is still to be set up
}

void TestFirstStart::fitsAtEveryScale_data() {
    QTest::addColumn<double>("scale");
    QTest::addColumn<int>("theme");
    QTest::newRow("100 %") << 1.0 << 0;
    QTest::newRow("200 % dark") << 2.0 << 1;
}

void TestFirstStart::fitsAtEveryScale() {
    QFETCH(double, scale);
    QFETCH(int, theme);
    EmptyStation station;
    station.settings.setScale(scale);
    station.settings.setTheme(static_cast<desktop::ThemeName>(theme));
    station.context.applyAppearance();
    station.show("first_start");
    VERIFY_READABLE(station.window->screen());
    picture(station.window.get(), QStringLiteral("first_start_%1").arg(scale));
    QTest::mouseClick(station.find<QPushButton>("first_start.set_up"), Qt::LeftButton);
    QTest::qWait(50);
    VERIFY_READABLE(station.window->screen());
    picture(station.window.get(), QStringLiteral("first_start_form_%1").arg(scale));
}

void TestFirstStart::theButtonOfAFormIsInSight_data() {
    QTest::addColumn<double>("scale");
    QTest::newRow("100 %") << 1.0;
    QTest::newRow("200 %") << 2.0;
}

/// In the smallest window, without scrolling.
void TestFirstStart::theButtonOfAFormIsInSight() {
    QFETCH(double, scale);
    EmptyStation station;
    station.settings.setScale(scale);
    station.context.applyAppearance();
    station.window->resize(1280, 720);
    station.show("first_start");
    const auto inSight = [&](const char* name) {
        const auto* button = station.find<QPushButton>(name);
        return button && button->isVisible() && button->visibleRegion().boundingRect() == button->rect();
    };
    QTRY_COMPARE_WITH_TIMEOUT(focusName(), QStringLiteral("first_start.set_up"), kPatience_ms);
    press(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(inSight("first_start.create") && inSight("first_start.back"), kPatience_ms);
    QCOMPARE(station.window->size(), QSize(1280, 720));
    // Tab comes to it after the fields.
    QVERIFY(tabTo(QStringLiteral("first_start.repeat")));
    press(Qt::Key_Tab);
    QCOMPARE(focusName(), QStringLiteral("first_start.show"));
    press(Qt::Key_Tab);
    QCOMPARE(focusName(), QStringLiteral("first_start.back"));
    station.find<QLineEdit>("first_start.name")->setFocus();
    fillForm(QStringLiteral("ada"));
    QTRY_VERIFY_WITH_TIMEOUT(inSight("recovery.continue"), kPatience_ms);
    settle();
    QVERIFY(!station.find<QPushButton>("first_start.create")); // its form is gone
    station.find<QCheckBox>("recovery.written")->click();
    station.find<QPushButton>("recovery.continue")->click();
    QTRY_VERIFY_WITH_TIMEOUT(station.context.loggedIn(), kPatience_ms);
}

QTEST_MAIN(TestFirstStart)
#include "test_first_start.moc"
