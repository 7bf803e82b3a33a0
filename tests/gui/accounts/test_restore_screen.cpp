// SPDX-License-Identifier: GPL-3.0-or-later
#include "hands.h"

#include "database/accounts/account_service.h"
#include "database/upkeep/upkeep.h"
#include "desktop/frame/app_context.h"
#include "desktop/frame/main_window.h"
#include "desktop/frame/program.h"
#include "desktop/restore/restore_screen.h"
#include "session/backup_list.h"
#include "support/damaged_file.h"
#include "support/kept_text.h"
#include "support/languages.h"
#include "support/patience.h"
#include "support/screen_outline.h"

#include <QDialog>
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QListWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <sys/mount.h>

using namespace chiron;
using namespace chiron::tests;

namespace {

constexpr const char* kPassword = "eleven-fine-horses";

database::DatabaseOptions cheap() {
    database::DatabaseOptions options;
    options.passwordCost = database::PasswordCost::minimalForTests();
    return options;
}

/// A site with two backups in the usual folder, closed; and the program on it, as it starts.
class LostSite {
public:
    LostSite() {
        settings.setLanguage(QStringLiteral("en"));
        desktop::applyAppearance(*qApp, context);
        auto made = database::Database::create(file().toStdString(), cheap());
        if (!made)
            qFatal("%s", made.error().message.c_str());
        database::AccountService accounts(**made);
        (void)accounts.createFirstAdministrator("ada", kPassword, "Ada Lovelace");
        const auto ada = accounts.login("ada", kPassword);
        QDir().mkpath(place());
        const auto byHand = database::Upkeep::backup(**made, *ada, place().toStdString() + "/by_hand");
        const auto daily =
            database::Upkeep::dailyBackup(**made, database::Actor::maintenance(), place().toStdString(), 14);
        if (!byHand || !daily)
            qFatal("no backups");
        automatic = QString::fromStdString(daily->made.folder);
        window = std::make_unique<desktop::MainWindow>(context);
        QObject::connect(&context.messages(), &desktop::Messages::told, window.get(),
                         [this](const desktop::Message& message) { said = message; });
    }
    ~LostSite() {
        context.background().cancelAndWait();
        window.reset();
    }
    /// As the program does.
    void start() {
        context.navigator().replace(desktop::firstPlace(site));
        window->show();
        window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window.get()));
        if (site.exists())
            context.openSite();
    }
    /// The screen, once every backup was looked at; null where it did not come.
    desktop::RestoreScreen* screen() {
        (void)QTest::qWaitFor(
            [this] { return qobject_cast<desktop::RestoreScreen*>(window->screen()) != nullptr; },
            kPatience_ms);
        auto* found = qobject_cast<desktop::RestoreScreen*>(window->screen());
        if (found)
            (void)QTest::qWaitFor([this] { return context.background().idle(); }, kPatience_ms);
        return found;
    }
    void answer(const char* name, const char* password) {
        find<QPushButton>("restore.restore")->click();
        auto* field = window->findChild<QLineEdit*>(QStringLiteral("restore.name"));
        auto* secret = window->findChild<QLineEdit*>(QStringLiteral("restore.password"));
        auto* confirm = window->findChild<QPushButton*>(QStringLiteral("restore.accept"));
        QVERIFY(field && secret && confirm && !confirm->isEnabled());
        field->setText(QLatin1String(name));
        secret->setText(QLatin1String(password));
        confirm->click();
        settle();
    }
    template <class W> W* find(const char* name) const { return window->findChild<W*>(QLatin1String(name)); }
    QString state(int row) const { return find<QTableWidget>("restore.backups")->item(row, 4)->text(); }
    QString file() const { return folder.filePath(QStringLiteral("site.db")); }
    QString place() const { return folder.filePath(QStringLiteral("backups")); }

    QTemporaryDir folder;
    desktop::Settings settings{folder.filePath(QStringLiteral("desktop.ini"))};
    desktop::DesktopSite site{file(), cheap()};
    desktop::AppContext context{site, settings};
    std::unique_ptr<desktop::MainWindow> window;
    QString automatic;
    desktop::Message said;
};

QByteArray contentOf(const QString& name) {
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

/// A site that cannot be opened: what is said, and the way back.
class TestRestoreScreen : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { qputenv("CHIRON_CONTENT", CHIRON_SOURCE_DIR "/curriculum/content"); }
    void isMadeAsItWas();
    void aDamagedSiteComesBack_data();
    void aDamagedSiteComesBack();
    void aMissingSiteComesBack();
    void aMissingSiteMayBeBegunAnew();
    void aWrongPasswordChangesNothing();
    void aDamagedBackupIsMarkedAndRefused();
    void aLostKeyIsTold();
    void withoutBackupsAFileIsChosen();
    void whatIsNoBackupIsTold();
    void aFolderThatCannotBeWrittenIsTold();
    void whatIsNotDamagedOffersNoRestore();
    void fitsAtEveryScale_data();
    void fitsAtEveryScale();
};

/// Against what was read and kept: CHIRON_STORE_OUTLINES=1 QT_QPA_PLATFORM=offscreen
/// build/release/tests/gui/accounts/test_restore_screen
void TestRestoreScreen::isMadeAsItWas() {
    KeptText kept(QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/accounts/kept_restore.txt"));
    QStringList different;
    for (const bool backup : {true, false}) {
        LostSite lost;
        QVERIFY(QDir(lost.automatic).removeRecursively()); // two of one second have no order
        if (!backup)
            QVERIFY(QDir(lost.place()).removeRecursively());
        QVERIFY(damage(lost.file(), QStringLiteral("cut off")));
        lost.start();
        QVERIFY(lost.screen());
        if (backup)
            QTRY_COMPARE_WITH_TIMEOUT(lost.state(0), QStringLiteral("Intact"), kPatience_ms);
        else
            QTRY_COMPARE_WITH_TIMEOUT(lost.find<QLabel>("state.title")->text(),
                                      QStringLiteral("No backup was found"), kPatience_ms);
        // Whether the last column fills the table depends on how wide the digits of the time are.
        const QStringList outline = ScreenOutline::of(*lost.window->screen())
                                        .replaceInStrings(QStringLiteral(" fills the last"), QString());
        different << kept.differs(backup ? QStringLiteral("a backup") : QStringLiteral("no backup"), outline);
    }
    different.removeAll(QString());
    QVERIFY2(different.isEmpty(), qPrintable(different.join(QLatin1Char('\n'))));
    QCOMPARE(kept.unseen(), QStringList());
}

void TestRestoreScreen::aDamagedSiteComesBack_data() {
    QTest::addColumn<QString>("how");
    for (const QString& how : kDamages)
        QTest::newRow(qPrintable(how)) << how;
}

void TestRestoreScreen::aDamagedSiteComesBack() {
    QFETCH(QString, how);
    LostSite lost;
    QVERIFY(damage(lost.file(), how));
    const QByteArray damaged = contentOf(lost.file());
    lost.start();
    QVERIFY2(lost.screen(), qPrintable(lost.window->screen()->objectName()));
    QCOMPARE(lost.find<QLabel>("restore.title")->text(), QStringLiteral("The site's file is damaged"));
    auto* table = lost.find<QTableWidget>("restore.backups");
    QCOMPARE(table->rowCount(), 2);
    for (int row : {0, 1}) {
        QTRY_COMPARE_WITH_TIMEOUT(lost.state(row), QStringLiteral("Intact"), kPatience_ms);
        for (int column = 0; column < table->columnCount(); ++column)
            QVERIFY2(!table->item(row, column)->text().isEmpty(), qPrintable(QString::number(column)));
    }
    QCOMPARE((QSet<QString>{table->item(0, 3)->text(), table->item(1, 3)->text()}),
             (QSet<QString>{QStringLiteral("Automatic"), QStringLiteral("By hand")}));
    QCOMPARE(contentOf(lost.file()), damaged); // looked at only
    picture(lost.window.get(), QStringLiteral("restore_") + how);
    lost.answer("ada", kPassword);
    QTRY_COMPARE_WITH_TIMEOUT(lost.context.navigator().current().screen, QStringLiteral("login"),
                              kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(lost.site.isOpen(), kPatience_ms);
    const QStringList kept = QDir(lost.folder.path())
                                 .entryList({QStringLiteral("site.db.before-restore*")}, QDir::Files)
                                 .filter(QRegularExpression(QStringLiteral("restore(-[0-9]+)?$")));
    QCOMPARE(kept.size(), 1);
    QCOMPARE(contentOf(lost.folder.filePath(kept.front())), damaged);
    QVERIFY2(lost.said.text.contains(kept.front()), qPrintable(lost.said.text));
    QVERIFY(database::AccountService(lost.site.database()).login("ada", kPassword));
}

void TestRestoreScreen::aMissingSiteComesBack() {
    LostSite lost;
    QVERIFY(QFile::remove(lost.file()));
    lost.start();
    QVERIFY(lost.screen());
    QCOMPARE(lost.find<QLabel>("restore.title")->text(), QStringLiteral("The site's file is missing"));
    lost.find<QPushButton>("restore.again")->click(); // still not there: nothing is made in its place
    QVERIFY(!QFile::exists(lost.file()) && lost.said.text.contains(QStringLiteral("still missing")));
    lost.answer("ada", kPassword);
    QTRY_VERIFY_WITH_TIMEOUT(lost.site.isOpen(), kPatience_ms);
    QCOMPARE(lost.context.navigator().current().screen, QStringLiteral("login"));
}

void TestRestoreScreen::aMissingSiteMayBeBegunAnew() {
    LostSite lost;
    QVERIFY(QFile::remove(lost.file()));
    lost.start();
    QVERIFY(lost.screen());
    lost.find<QPushButton>("restore.anew")->click();
    QCOMPARE(lost.context.navigator().current().screen, QStringLiteral("first_start"));
    // On a station that never had a site, that is where it begins.
    desktop::DesktopSite none(lost.folder.filePath(QStringLiteral("none.db")), cheap());
    QCOMPARE(desktop::firstPlace(none).screen, QStringLiteral("first_start"));
}

void TestRestoreScreen::aWrongPasswordChangesNothing() {
    LostSite lost;
    QVERIFY(damage(lost.file(), QStringLiteral("zeroed header")));
    const QByteArray damaged = contentOf(lost.file());
    lost.start();
    QVERIFY(lost.screen());
    lost.answer("ada", "twelve-fine-horses");
    // The dialog stays, says it at the field, and nothing of what was chosen is lost.
    QTRY_VERIFY_WITH_TIMEOUT(lost.find<QLabel>("restore.password.note") &&
                                 lost.find<QLabel>("restore.password.note")->isVisible(),
                             kPatience_ms);
    QVERIFY(lost.find<QLabel>("restore.password.note")
                ->text()
                .contains(QStringLiteral("Passwords are case-sensitive")));
    QVERIFY(lost.find<QDialog>("restore")->isVisible());
    QVERIFY(lost.find<QLabel>("restore.explanation")
                ->text()
                .contains(QStringLiteral("the day it was made"))); // which password is meant
    QVERIFY(lost.find<QLabel>("restore.why_other")->text().contains(QStringLiteral("has to agree")));
    QCOMPARE(lost.find<QLineEdit>("restore.name")->text(), QStringLiteral("ada"));
    QTRY_COMPARE_WITH_TIMEOUT(focusName(), QStringLiteral("restore.password"), kPatience_ms);
    QVERIFY(contentOf(lost.file()) == damaged);
    QCOMPARE(QDir(lost.folder.path()).entryList({QStringLiteral("*restor*")}, QDir::Files), QStringList());
    QVERIFY(lost.screen()->mayLeave());
    // Typed anew, the word goes, and with the right one it is done.
    lost.find<QLineEdit>("restore.password")->setText(QString::fromLatin1(kPassword));
    QVERIFY(!lost.find<QLabel>("restore.password.note")->isVisible());
    lost.find<QPushButton>("restore.accept")->click();
    QTRY_VERIFY_WITH_TIMEOUT(lost.site.isOpen(), kPatience_ms);
}

void TestRestoreScreen::aDamagedBackupIsMarkedAndRefused() {
    LostSite lost;
    QVERIFY(damage(lost.file(), QStringLiteral("empty")));
    QVERIFY(damage(lost.automatic + QStringLiteral("/chiron.db"), QStringLiteral("cut off")));
    lost.start();
    QVERIFY(lost.screen());
    auto* table = lost.find<QTableWidget>("restore.backups");
    const int bad = table->item(0, 3)->text() == QLatin1String("Automatic") ? 0 : 1;
    QTRY_COMPARE_WITH_TIMEOUT(lost.state(bad), QStringLiteral("Cannot be used"), kPatience_ms);
    QTRY_COMPARE_WITH_TIMEOUT(lost.state(1 - bad), QStringLiteral("Intact"), kPatience_ms);
    QVERIFY(!table->item(bad, 4)->toolTip().isEmpty());
    table->selectRow(bad);
    QVERIFY(!lost.find<QPushButton>("restore.restore")->isEnabled());
    QVERIFY(lost.find<QLabel>("restore.reason")->isVisible() &&
            lost.find<QLabel>("restore.reason")->text().contains(QStringLiteral("chiron.db")));
    table->selectRow(1 - bad);
    QVERIFY(!lost.find<QLabel>("restore.reason")->isVisible() && !lost.find<QFrame>("restore.key"));
    QVERIFY(lost.find<QPushButton>("restore.restore")->isEnabled());
}

void TestRestoreScreen::aLostKeyIsTold() {
    LostSite lost;
    QVERIFY(damage(lost.file(), QStringLiteral("cut off")));
    QVERIFY(QFile::remove(lost.file() + QStringLiteral(".site/site.key")));
    lost.start();
    QVERIFY(lost.screen());
    QVERIFY(lost.find<QFrame>("restore.key"));
    QTRY_COMPARE_WITH_TIMEOUT(lost.state(0), QStringLiteral("Cannot be used"), kPatience_ms);
    QTRY_COMPARE_WITH_TIMEOUT(lost.state(1), QStringLiteral("Cannot be used"), kPatience_ms);
}

void TestRestoreScreen::withoutBackupsAFileIsChosen() {
    LostSite lost;
    const QString elsewhere = lost.folder.filePath(QStringLiteral("usb"));
    QVERIFY(QDir().rename(lost.place(), elsewhere));
    QVERIFY(damage(lost.file(), QStringLiteral("cut off")));
    lost.start();
    QVERIFY(lost.screen());
    QTRY_COMPARE_WITH_TIMEOUT(lost.find<QLabel>("state.title")->text(), QStringLiteral("No backup was found"),
                              kPatience_ms);
    QVERIFY(!lost.find<QPushButton>("restore.restore")->isEnabled());
    lost.find<QPushButton>("restore.choose")->click();
    auto* dialog = lost.window->findChild<QFileDialog*>();
    QVERIFY(dialog && dialog->fileMode() == QFileDialog::ExistingFile);
    emit dialog->fileSelected(elsewhere + QStringLiteral("/by_hand/manifest.json"));
    dialog->close();
    QTRY_COMPARE_WITH_TIMEOUT(lost.find<QTableWidget>("restore.backups")->rowCount(), 1, kPatience_ms);
    QTRY_COMPARE_WITH_TIMEOUT(lost.state(0), QStringLiteral("Intact"), kPatience_ms);
    lost.answer("ada", kPassword);
    QTRY_VERIFY_WITH_TIMEOUT(lost.site.isOpen(), kPatience_ms);
}

void TestRestoreScreen::whatIsNoBackupIsTold() {
    LostSite lost;
    QVERIFY(damage(lost.file(), QStringLiteral("cut off")));
    lost.start();
    QVERIFY(lost.screen());
    lost.find<QPushButton>("restore.choose")->click();
    auto* dialog = lost.window->findChild<QFileDialog*>();
    emit dialog->fileSelected(lost.file());
    dialog->close();
    QTRY_VERIFY_WITH_TIMEOUT(lost.said.text.contains(QStringLiteral("is not a backup")), kPatience_ms);
    QCOMPARE(lost.find<QTableWidget>("restore.backups")->rowCount(), 2);
}

// The disk with the site can be read only: what is there is kept, and the reason said.
void TestRestoreScreen::aFolderThatCannotBeWrittenIsTold() {
    LostSite lost;
    QVERIFY(damage(lost.file(), QStringLiteral("zeroed header")));
    const QByteArray path = lost.folder.path().toLocal8Bit();
    if (mount(path.constData(), path.constData(), nullptr, MS_BIND, nullptr) != 0)
        QSKIP("mounting is not permitted here");
    const bool readOnly =
        mount(nullptr, path.constData(), nullptr, MS_BIND | MS_REMOUNT | MS_RDONLY, nullptr) == 0;
    lost.start();
    const bool came = lost.screen() != nullptr;
    if (came) {
        lost.answer("ada", kPassword);
        (void)QTest::qWaitFor([&] { return lost.said.kind == desktop::MessageKind::error; }, kPatience_ms);
    }
    QCOMPARE(umount2(path.constData(), MNT_DETACH), 0);
    QVERIFY(readOnly && came);
    QVERIFY2(lost.said.text.contains(QStringLiteral("Nothing was restored")), qPrintable(lost.said.text));
    QVERIFY(!contentOf(lost.file()).isEmpty());
}

void TestRestoreScreen::whatIsNotDamagedOffersNoRestore() {
    LostSite lost;
    QFile file(lost.file());
    QVERIFY(file.open(QIODevice::ReadWrite) && file.seek(63) && file.putChar(99)); // a newer program's
    file.close();
    lost.start();
    QTRY_VERIFY_WITH_TIMEOUT(
        lost.find<QLabel>("state.title") && lost.find<QLabel>("state.title")->isVisible(), kPatience_ms);
    QCOMPARE(lost.context.navigator().current().screen, QStringLiteral("login"));
    QVERIFY(lost.find<QLabel>("state.text")->text().contains(QStringLiteral("newer")));
}

void TestRestoreScreen::fitsAtEveryScale_data() {
    QTest::addColumn<double>("scale");
    QTest::addColumn<QString>("language");
    for (const double scale : {1.0, 2.0})
        for (const char* language : tests::languageIds())
            QTest::addRow("%s %.0f", language, scale * 100) << scale << QString::fromLatin1(language);
}

void TestRestoreScreen::fitsAtEveryScale() {
    QFETCH(double, scale);
    QFETCH(QString, language);
    LostSite lost;
    QVERIFY(damage(lost.file(), QStringLiteral("cut off")));
    lost.settings.setScale(scale);
    lost.settings.setLanguage(language);
    lost.context.applyAppearance();
    desktop::applyAppearance(*qApp, lost.context);
    lost.start();
    QVERIFY(lost.screen());
    VERIFY_READABLE(lost.window->screen());
    picture(lost.window.get(), QStringLiteral("restore_%1_%2").arg(language).arg(scale));
    lost.settings.setScale(1.0);
    lost.settings.setLanguage(QStringLiteral("en"));
    lost.context.applyAppearance();
    desktop::applyAppearance(*qApp, lost.context);
}

QTEST_MAIN(TestRestoreScreen)
#include "test_restore_screen.moc"
