// SPDX-License-Identifier: GPL-3.0-or-later
// Forms that come and go, against what was read and kept: how each is made, what becomes of it as it is
// filled in, what it hands over and when, what it says while something works and where it is refused. A
// change that is meant is kept anew, and the difference is read in review: CHIRON_STORE_OUTLINES=1
// QT_QPA_PLATFORM=offscreen build/release/tests/gui/accounts/test_kept_forms
#include "database/accounts/account_service.h"
#include "desktop/accounts/notice_area.h"
#include "desktop/accounts/recovery_code_panel.h"
#include "desktop/accounts/wait_countdown.h"
#include "desktop/first_start/administrator_page.h"
#include "desktop/first_start/site_maker.h"
#include "desktop/frame/app_context.h"
#include "desktop/frame/background.h"
#include "desktop/lock/lock_cover.h"
#include "desktop/login/login_form.h"
#include "desktop/login/new_password_page.h"
#include "desktop/login/recovery_page.h"
#include "desktop/people/password_choice.h"
#include "desktop/people/role_choice.h"
#include "desktop/sessions/void_dialog.h"
#include "desktop/storage/restore_dialog.h"
#include "desktop/storage/task_strip.h"
#include "desktop/theme/theme.h"
#include "desktop/widgets/state_panel.h"
#include "session/backup_list.h"
#include "support/kept_text.h"
#include "support/patience.h"
#include "support/screen_outline.h"

#include <QCheckBox>
#include <QClipboard>
#include <QGuiApplication>
#include <QListWidget>
#include <QPushButton>
#include <QTemporaryDir>
#include <QtTest>

using chiron::tests::kPatience_ms;

using namespace chiron;
using namespace chiron::desktop;

class TestKeptForms : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom)); }
    void init() {
        m_lines.clear();
        m_changes.forget();
    }

    void logIn() {
        LoginForm form(m_theme);
        begin(form);
        connect(&form, &LoginForm::submitted, &form, [this](const QString& name, const QString& password) {
            say(QStringLiteral("hands over %1 %2").arg(name, password));
        });
        connect(&form, &LoginForm::forgotten, &form, [this] { say(QStringLiteral("forgotten")); });
        std::vector<database::LoginName> names;
        for (const auto& [name, full] :
             {std::pair{"ada", "Ada Lovelace"}, {"tina", "Tina Trainee"}, {"theo", "theo"}, {"tom", ""}}) {
            database::LoginName each;
            each.id = static_cast<database::PersonId>(names.size()) + 1;
            each.name = name;
            each.displayName = full;
            names.push_back(each);
        }
        form.setNames(names);
        form.focusFirst();
        take("with names");
        auto* field = form.findChild<QLineEdit*>(QStringLiteral("login.name"));
        auto* list = form.findChild<QListWidget*>(QStringLiteral("login.people"));
        auto* password = form.findChild<QLineEdit*>(QStringLiteral("login.password"));
        const auto shown = [&] {
            QStringList all;
            for (int i = 0; i < list->count(); ++i)
                if (!list->item(i)->isHidden())
                    all << list->item(i)->text();
            say(QStringLiteral("typed \"%1\", shown %2, focus on %3")
                    .arg(field->text(), all.join(QLatin1Char('/')),
                         QApplication::focusWidget() ? QApplication::focusWidget()->objectName()
                                                     : QStringLiteral("nothing")));
        };
        shown();
        for (const char* typed : {"t", "TR", "zz", " lace ", "ti"}) {
            field->clear();
            QTest::keyClicks(field, QLatin1String(typed));
            shown();
            take("then");
        }
        QTest::keyClick(field, Qt::Key_Return); // the only one that fits
        shown();
        field->clear();
        QTest::keyClicks(field, QStringLiteral("t"));
        QTest::keyClick(field, Qt::Key_Return); // one of several: as it was typed
        shown();
        field->clear();
        QTest::keyClick(field, Qt::Key_Return);
        shown();
        field->setFocus();
        QTest::keyClicks(field, QStringLiteral("t"));
        QTest::keyClick(field, Qt::Key_Down); // the first that is shown
        shown();
        QTest::keyClick(list, Qt::Key_Down);
        shown();
        QTest::keyClick(list, Qt::Key_Return);
        shown();
        emit list->itemClicked(list->item(0));
        shown();
        password->setText(QStringLiteral("a word"));
        take("name and password");
        field->clear();
        take("no name");
        form.setName(QStringLiteral("tom"));
        QTest::keyClick(password, Qt::Key_Return);
        form.setWorking(true);
        take("working");
        QTest::keyClick(password, Qt::Key_Return); // not twice
        form.showRefusal(refusal(database::Refusal::Kind::wrong, 0));
        take("refused");
        form.showRefusal(refusal(database::Refusal::Kind::mustWait, 90'000'000'000));
        take("has to wait");
        QTest::keyClick(password, Qt::Key_Return);
        form.findChild<QPushButton*>(QStringLiteral("login.forgotten"))->click();
        form.showDemonstrationHint(QStringLiteral("A hint"));
        take("a hint");
        hold("log in");
    }

    void lock() {
        QWidget window;
        LockCover cover(m_theme, QStringLiteral("tina"), &window);
        window.resize(900, 700);
        window.show();
        begin(cover);
        connect(&cover, &LockCover::submitted, &cover,
                [this](const QString& password) { say(QStringLiteral("hands over ") + password); });
        connect(&cover, &LockCover::switchAsked, &cover, [this] { say(QStringLiteral("switches")); });
        cover.focusFirst();
        fill(cover, "lock.password", "a word");
        click(cover, "lock.unlock");
        cover.setWorking(true);
        take("working");
        click(cover, "lock.unlock");
        cover.showRefusal(refusal(database::Refusal::Kind::disabled, 0));
        take("refused");
        cover.showRefusal(refusal(database::Refusal::Kind::mustWait, 90'000'000'000));
        take("has to wait");
        click(cover, "lock.switch");
        hold("lock");
    }

    void newPassword() {
        NewPasswordPage page(m_theme, QStringLiteral("tina"));
        begin(page);
        connect(&page, &NewPasswordPage::submitted, &page,
                [this](const QString& password) { say(QStringLiteral("hands over ") + password); });
        connect(&page, &NewPasswordPage::backAsked, &page, [this] { say(QStringLiteral("goes back")); });
        for (const auto& [password, again] : {std::pair{"short", "short"},
                                              {"aaaaaaaaaaaaaaaa", "aaaaaaaaaaaaaaaa"},
                                              {"tina", "tina"},
                                              {"a good long word", "another one"},
                                              {"a good long word", "a good long word"}}) {
            fill(page, "change.password", password);
            fill(page, "change.repeat", again);
            click(page, "change.save");
        }
        page.findChild<QCheckBox*>(QStringLiteral("change.show"))->click();
        take("to be read");
        page.findChild<QCheckBox*>(QStringLiteral("change.show"))->click();
        take("no more");
        page.setWorking(true);
        take("working");
        page.setWorking(false);
        page.showProblem(QStringLiteral("It is not so."));
        take("a problem");
        clickAll(page);
        hold("new password");
    }

    void recovery() {
        RecoveryPage page(m_theme, QStringLiteral("ada"));
        begin(page);
        connect(&page, &RecoveryPage::submitted, &page,
                [this](const QString& name, const QString& code, const QString& password) {
                    say(QStringLiteral("hands over %1 %2 %3").arg(name, code, password));
                });
        connect(&page, &RecoveryPage::backAsked, &page, [this] { say(QStringLiteral("goes back")); });
        fill(page, "recovery.code_field", "AAAAA-BBBBB-CCCCC-DDDDD-EEEEE");
        fill(page, "recovery.password", "a good long word");
        fill(page, "recovery.repeat", "a good long word");
        click(page, "recovery.save");
        fill(page, "recovery.name", "");
        fill(page, "recovery.name", "ada");
        page.setWorking(true);
        take("working");
        click(page, "recovery.save");
        page.showRefusal(refusal(database::Refusal::Kind::wrong, 0));
        take("refused");
        page.showRefusal(refusal(database::Refusal::Kind::mustWait, 90'000'000'000));
        take("has to wait");
        click(page, "recovery.back");
        hold("recovery");
    }

    void administrator() {
        AdministratorPage page(m_theme);
        begin(page);
        connect(&page, &AdministratorPage::submitted, &page, [this](const AdministratorRequest& request) {
            say(QStringLiteral("hands over %1 \"%2\" %3")
                    .arg(QString::fromStdString(request.name), QString::fromStdString(request.displayName),
                         QString::fromStdString(request.password)));
        });
        connect(&page, &AdministratorPage::backAsked, &page, [this] { say(QStringLiteral("goes back")); });
        QStringList fields;
        for (const auto* field : page.findChildren<QLineEdit*>())
            fields << field->objectName();
        for (const char* name : {"a name, and more", "ada"})
            for (const QString& field : fields) {
                const bool secret = page.findChild<QLineEdit*>(field)->echoMode() == QLineEdit::Password;
                fill(page, qPrintable(field), secret ? "a good long word" : name);
            }
        clickAll(page);
        page.setWorking(true);
        take("working");
        clickAll(page);
        page.setWorking(false);
        page.showProblem(QStringLiteral("It is not so."));
        take("a problem");
        hold("administrator");
    }

    void codes() {
        RecoveryCodePanel panel(m_theme, QStringLiteral("ada"), QStringLiteral("AAAAA-BBBBB"),
                                RecoveryCodePanel::Backups::haveEarlierCode);
        QVERIFY(
            panel.printedText().startsWith(QStringLiteral("Chiron: recovery code of ada\n\nAAAAA-BBBBB\n")));
        begin(panel);
        connect(&panel, &RecoveryCodePanel::finished, &panel, [this] { say(QStringLiteral("finished")); });
        click(panel, "recovery.continue");
        click(panel, "recovery.copy");
        say(QStringLiteral("copied ") + QGuiApplication::clipboard()->text());
        say(panel.isConfirmed() ? QStringLiteral("written down") : QStringLiteral("not written down"));
        panel.findChild<QCheckBox*>(QStringLiteral("recovery.written"))->click();
        take("written down");
        say(panel.isConfirmed() ? QStringLiteral("written down") : QStringLiteral("not written down"));
        click(panel, "recovery.continue");
        std::unique_ptr<QWidget> handed(handedPassword(
            m_theme, QStringLiteral("A headline"), QStringLiteral("uma"), QStringLiteral("a drawn word")));
        begin(*handed);
        click(*handed, "handed.copy");
        say(QStringLiteral("copied ") + QGuiApplication::clipboard()->text());
        hold("codes");
    }

    void choices() {
        PasswordChoice passwords(m_theme, QStringLiteral("add"));
        begin(passwords);
        int changes = 0;
        connect(&passwords, &PasswordChoice::changed, &passwords, [&changes] { ++changes; });
        const auto told = [&] {
            say(QStringLiteral("changed %1%2%3 %4")
                    .arg(changes)
                    .arg(passwords.isGood() ? QStringLiteral(" good") : QString(),
                         passwords.isGenerated() ? QStringLiteral(" made up") : QString(),
                         passwords.isGenerated() ? QString::number(passwords.password().size())
                                                 : QString::fromStdString(passwords.password())));
        };
        told();
        passwords.setLoginName(QStringLiteral("a good long word"));
        passwords.findChild<QRadioButton*>(QStringLiteral("add.type"))->click();
        take("typed");
        told();
        fill(passwords, "add.password", "a good long word");
        fill(passwords, "add.repeat", "a good long word");
        told();
        passwords.setLoginName(QStringLiteral("uma"));
        take("of another name");
        told();
        passwords.findChild<QRadioButton*>(QStringLiteral("add.generate"))->click();
        take("made up again");
        told();
        RoleChoice roles(m_theme, QStringLiteral("add"), {database::Role::trainee});
        begin(roles);
        for (const char* role : {"add.admin", "add.trainee", "add.admin"}) {
            roles.findChild<QCheckBox*>(QLatin1String(role))->click();
            QStringList chosen;
            for (const database::Role each : database::kAllRoles)
                if (roles.roles().contains(each))
                    chosen << QString::number(static_cast<int>(each));
            say(QLatin1String(role) + QStringLiteral(": ") + chosen.join(QLatin1Char(' ')));
        }
        hold("choices");
    }

    void voids() {
        VoidSessionDialog dialog(m_theme, 12, QStringLiteral("Tina Trainee"),
                                 QStringLiteral("Find the apex, level 2 · Not passed"), nullptr);
        begin(dialog);
        dialog.show();
        for (const char* reason : {"   ", " wrong hand \n"}) {
            dialog.findChild<QPlainTextEdit*>()->setPlainText(QLatin1String(reason));
            take("a reason");
        }
        say(QStringLiteral("reason \"%1\"").arg(dialog.reason()));
        for (auto* button : dialog.findChildren<QPushButton*>()) {
            dialog.show();
            button->click();
            say(QStringLiteral("%1 ends it with %2").arg(button->objectName()).arg(dialog.result()));
        }
        hold("voids");
    }

    void restore() {
        QTemporaryDir folder;
        Settings settings(folder.filePath(QStringLiteral("desktop.ini")));
        settings.setLanguage(QStringLiteral("en"));
        DesktopSite site(folder.filePath(QStringLiteral("site.db")), {});
        AppContext context(site, settings);
        session::BackupEntry backup;
        backup.createdUtc =
            QDateTime::currentDateTimeUtc().addDays(-2).toString(Qt::ISODateWithMs).toStdString();
        RestoreDialog dialog(context, backup, RestoreDialog::Replaces::working, nullptr, {});
        begin(dialog);
        const auto told = [&] {
            const database::RestoreRequest request = dialog.request();
            say(QStringLiteral("%1 / %2, today's %3 / %4")
                    .arg(QString::fromStdString(request.name), QString::fromStdString(request.password),
                         QString::fromStdString(request.presentName),
                         QString::fromStdString(request.presentPassword)));
        };
        told();
        for (const auto* field : dialog.findChildren<QLineEdit*>())
            say(QStringLiteral("field ") + field->objectName());
        const auto fillAll = [&](const char* prefix) {
            for (auto* field : dialog.findChildren<QLineEdit*>())
                if (field->isVisibleTo(&dialog)) {
                    field->setText(QLatin1String(prefix) + field->objectName());
                    take("filled");
                }
            told();
        };
        fillAll("one ");
        for (auto* box : dialog.findChildren<QCheckBox*>()) {
            box->click();
            take("of another database");
        }
        told();
        fillAll("two ");
        for (auto* field : dialog.findChildren<QLineEdit*>()) {
            const QString was = field->text();
            field->clear();
            take("without");
            field->setText(was);
        }
        hold("restore");
    }

    void works() {
        TaskStrip strip(m_theme);
        begin(strip);
        const auto token = std::make_shared<WorkToken>();
        const auto told = [&] {
            const auto* bar = strip.findChild<QProgressBar*>();
            say(QStringLiteral("%1 of %2 to %3%4%5")
                    .arg(bar->value())
                    .arg(bar->minimum())
                    .arg(bar->maximum())
                    .arg(strip.isRunning() ? QStringLiteral(" runs") : QString(),
                         token->cancelled() ? QStringLiteral(" cancelled") : QString()));
        };
        token->setProgress(3, 10);
        strip.start(QStringLiteral("A backup"), token);
        take("begun");
        told();
        token->setProgress(7, 10);
        QTRY_COMPARE_WITH_TIMEOUT(strip.findChild<QProgressBar*>()->value(), 7, kPatience_ms);
        told();
        click(strip, "task.cancel");
        told();
        strip.stop();
        take("ended");
        told();
        strip.start(QStringLiteral("Nothing to cancel"));
        take("another");
        told();
        hold("works");
    }

    void states() {
        StatePanel panel(m_theme);
        panel.setContent(new QLabel(QStringLiteral("content")));
        begin(panel);
        int acted = 0;
        const auto token = std::make_shared<WorkToken>();
        panel.showLoading(QStringLiteral("Reading …"), token);
        take("loading");
        say(QString::number(static_cast<int>(panel.state())));
        QTRY_VERIFY_WITH_TIMEOUT(
            panel.findChild<QProgressBar*>() && !panel.findChild<QProgressBar*>()->isHidden(), kPatience_ms);
        token->setProgress(40, 100);
        QTRY_COMPARE_WITH_TIMEOUT(panel.findChild<QProgressBar*>()->value(), 40, kPatience_ms);
        auto* cancel = panel.findChild<QPushButton*>(QStringLiteral("state.cancel"));
        QVERIFY(cancel && cancel->isHidden()); // only where it takes long
        QTRY_VERIFY_WITH_TIMEOUT(!cancel->isHidden(), kPatience_ms);
        cancel->click();
        say(QStringLiteral("%1%2").arg(token->cancelled() ? QStringLiteral("cancelled") : QString(),
                                       cancel->isEnabled() ? QStringLiteral(" again") : QString()));
        panel.showLoading(QStringLiteral("Once more …"), token);
        QVERIFY(cancel->isEnabled() && cancel->isHidden() && panel.findChild<QProgressBar*>()->isHidden());
        for (const auto& [title, action] : {std::pair{"Nothing here", "Make one"}, {"Nothing at all", ""}}) {
            panel.showEmpty(QLatin1String(title), QStringLiteral("Words about it"), QLatin1String(action),
                            [&acted] { ++acted; });
            take(title);
            say(QString::number(static_cast<int>(panel.state())));
            click(panel, "state.action");
        }
        panel.showError(QStringLiteral("It failed"), {core::ErrorCode::locked, "by another"}, [&] {
            ++acted;
            panel.showContent();
        });
        take("failed");
        say(QString::number(static_cast<int>(panel.state())));
        click(panel, "state.action");
        say(QStringLiteral("acted %1, state %2").arg(acted).arg(static_cast<int>(panel.state())));
        panel.showError(QStringLiteral("For good"), {core::ErrorCode::doesNotHold, "damaged"});
        take("failed for good");
        NoticeArea notice(m_theme);
        begin(notice);
        for (const auto& [kind, text] :
             {std::pair{"bad", "Bad news"}, {"good", "Good news"}, {"info", ""}, {"warning", "Beware"}}) {
            notice.say(kind, QLatin1String(text));
            take(kind);
            say(notice.text());
        }
        notice.clear();
        take("cleared");
        hold("states");
    }

    void nothingElseIsKept() {
        if (m_held > 1)
            QCOMPARE(m_kept.unseen(), QStringList());
    }

private:
    void say(const QString& line) { m_lines << (line.isEmpty() ? QStringLiteral("nothing") : line); }
    void begin(QWidget& widget) {
        m_widget = &widget;
        m_changes.forget();
        widget.resize(700, 600);
        widget.show();
        widget.activateWindow();
        take("as it is made");
    }
    /// What has changed since it was looked at last; all of it at first.
    void take(const char* moment) {
        say(QStringLiteral("-- ") + QLatin1String(moment));
        static const QRegularExpression seconds(QStringLiteral("[0-9]+ second")); // that are left
        const QStringList now =
            tests::ScreenOutline::of(*m_widget).replaceInStrings(seconds, QStringLiteral("… second"));
        for (const QString& line : m_changes.of(now))
            say(line);
    }
    void fill(QWidget& in, const char* name, const char* text) {
        auto* field = in.findChild<QLineEdit*>(QLatin1String(name));
        QVERIFY2(field, name);
        field->setText(QLatin1String(text));
        take(name);
    }
    void click(QWidget& in, const char* name) {
        auto* button = in.findChild<QAbstractButton*>(QLatin1String(name));
        QVERIFY2(button, name);
        button->click();
        take(name);
    }
    void clickAll(QWidget& in) {
        for (auto* button : in.findChildren<QPushButton*>()) {
            say(QStringLiteral("clicks ") + button->objectName());
            button->click();
            take("then");
        }
    }
    static database::Refusal refusal(database::Refusal::Kind kind, std::int64_t wait_ns) {
        database::Refusal refused;
        refused.kind = kind;
        refused.wait_ns = wait_ns;
        refused.error = {core::ErrorCode::storage, "no room"};
        return refused;
    }
    void hold(const char* name) {
        const QString differs = m_kept.differs(QLatin1String(name), m_lines);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
        ++m_held;
    }

    Theme m_theme = *Theme::load(ThemeName::light, 1.0);
    QWidget* m_widget = nullptr;
    QStringList m_lines;
    tests::LineChanges m_changes;
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/accounts/kept_forms.txt")};
    int m_held = 0;
};

QTEST_MAIN(TestKeptForms)
#include "test_kept_forms.moc"
