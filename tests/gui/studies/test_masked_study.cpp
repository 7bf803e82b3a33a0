// SPDX-License-Identifier: GPL-3.0-or-later
// A blinded study as its author sees it and as somebody sees it who may not know: codes instead of
// conditions, on every page, and runs all the same.
#include "desktop/sessions/session_table_model.h"
#include "desktop/sessions/session_words.h"
#include "desktop/studies/study_screen.h"
#include "desktop/study_run/trials_screen.h"
#include "session/study/study_runner.h"
#include "support/every_place.h"
#include "support/languages.h"
#include "support/patience.h"
#include "support/settled.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QTableWidget>

using chiron::tests::kPatience_ms;

using namespace chiron;

class TestMaskedStudy : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void cleanupTestCase() { m_site.reset(); }
    void theAuthorSeesTheDesign();
    void othersSeeCodes();
    void unblindingIsReadable();
    void sealedSittingsAreToldAsSuch();
    void othersRunIt(); // the last: it leaves a sitting that runs

private:
    /// `look` in every language, at 100 and 200 %, in the light and the dark theme;
    /// CHIRON_KEEP_PICTURES=<folder> keeps the pictures.
    template <class Look> void everyLook(Look look) {
        for (const char* language : tests::languagesEnglishLast())
            for (const double scale : {2.0, 1.0})
                for (const auto theme : {desktop::ThemeName::dark, desktop::ThemeName::light}) {
                    m_site->settings.setLanguage(QLatin1String(language));
                    m_site->settings.setScale(scale);
                    m_site->settings.setTheme(theme);
                    m_site->context.applyAppearance();
                    m_site->window->resize(1280, 720);
                    look(QStringLiteral("%1_%2_%3")
                             .arg(QLatin1String(language))
                             .arg(100 * scale)
                             .arg(theme == desktop::ThemeName::dark ? "dark" : "light"));
                    if (QTest::currentTestFailed())
                        return;
                }
        m_site->settings.setLanguage(QStringLiteral("en"));
        m_site->settings.setScale(1.0);
        m_site->context.applyAppearance();
    }
    static void keep(QWidget* widget, const QString& name) {
        if (const QString folder = qEnvironmentVariable("CHIRON_KEEP_PICTURES"); !folder.isEmpty())
            widget->grab().save(folder + QLatin1Char('/') + name + QStringLiteral(".png"));
    }
    /// Everything that can be read on the screen.
    QString told() const {
        QStringList all;
        const QWidget* screen = m_site->window->screen();
        for (const auto* label : screen->findChildren<QLabel*>())
            all << label->text();
        for (const auto* button : screen->findChildren<QAbstractButton*>())
            all << button->text();
        for (const auto* field : screen->findChildren<QLineEdit*>()) // of spin boxes, too
            all << field->text();
        for (const auto* field : screen->findChildren<QComboBox*>())
            all << field->currentText();
        for (const auto* table : screen->findChildren<QTableWidget*>())
            for (int i = 0; i < table->rowCount() * table->columnCount(); ++i)
                all << (table->item(i / table->columnCount(), i % table->columnCount())
                            ? table->item(i / table->columnCount(), i % table->columnCount())->text()
                            : QString());
        return all.join(QLatin1Char('\n'));
    }
    void show(const char* screen, int tab) {
        m_site->go(QLatin1String(screen), {{QStringLiteral("study"), qlonglong(m_study)},
                                           {QStringLiteral("tab"), tab},
                                           {QStringLiteral("participant"), m_code}});
        QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    }
    std::unique_ptr<tests::DesktopFixture> m_site;
    database::StudyNumber m_study = 0;
    QString m_code;
};

void TestMaskedStudy::initTestCase() {
    m_site = std::make_unique<tests::DesktopFixture>();
    const auto ada = m_site->actor("ada");
    QVERIFY(database::AccountService(m_site->database())
                .createPerson(
                    ada, {"rob", "Rob Runner", {database::Role::researcher}, tests::kTestPassword, false}));
    m_study = tests::addVisitedStudies(*m_site).blind;
    const auto rhea = m_site->actor("rhea");
    m_code = QString::fromStdString(
        tests::addParticipant(*m_site, rhea, m_study, tests::smallStudy("jnd_blind", true), "resident 2")
            .code);
}

void TestMaskedStudy::theAuthorSeesTheDesign() {
    m_site->logIn("rhea");
    show("study", desktop::StudyScreen::conditionsTab);
    QVERIFY(told().contains(QStringLiteral("Stiffness of a tube")));
    QVERIFY(m_site->find<QPushButton>(QStringLiteral("study.export")));
}

void TestMaskedStudy::othersSeeCodes() {
    m_site->logIn("rob");
    for (int tab = 0; tab < desktop::StudyScreen::tabs; ++tab) {
        show("study", tab);
        for (const char* condition : {"Stiffness of a tube", "Mass of an object", "300", "N/m", " kg"})
            QVERIFY2(!told().contains(QLatin1String(condition)),
                     qPrintable(QStringLiteral("%1: %2").arg(tab).arg(told())));
    }
    QVERIFY(
        !m_site->find<QPushButton>(QStringLiteral("study.export"))); // no file of a design that nobody froze
    QVERIFY(!m_site->find<QPushButton>(QStringLiteral("preview.start")));
    show("study", desktop::StudyScreen::conditionsTab);
    auto connection = m_site->database().openReader();
    QStringList codes;
    const auto sealed = database::StudyReader(**connection, m_site->context.actor()).conditionCodes(m_study);
    QVERIFY(sealed);
    for (const database::SealedCondition& each : *sealed)
        codes << QString::fromStdString(each.sealedCode);
    QCOMPARE(m_site->find<QLabel>(QStringLiteral("conditions.codes"))->text(),
             codes.join(QStringLiteral(" · ")));
    const QString folder = qEnvironmentVariable("CHIRON_KEEP_PICTURES");
    if (!folder.isEmpty())
        m_site->window->grab().save(folder + QStringLiteral("/masked_conditions.png"));
    show("study_data", 0);
    QVERIFY2(!told().contains(QStringLiteral("Stiffness of")), qPrintable(told()));
}

void TestMaskedStudy::othersRunIt() {
    m_site->logIn("rob");
    show("study_run", 0);
    m_site->find<QPushButton>(QStringLiteral("run.begin"))->click();
    auto* screen = m_site->screen<desktop::TrialsScreen>();
    QVERIFY(screen);
    QVERIFY(screen->live()); // rendered by its own condition, which the list does not tell
    QVERIFY(!told().contains(QStringLiteral("Stiffness of")) && !told().contains(QStringLiteral("Mass of")));
}

void TestMaskedStudy::unblindingIsReadable() {
    m_site->logIn("rhea");
    everyLook([this](const QString& name) {
        show("study_data", 0);
        QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("data.unblind")), kPatience_ms);
        m_site->find<QPushButton>(QStringLiteral("data.unblind"))->click();
        QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QDialog>(QStringLiteral("data.ask_unblind")), kPatience_ms);
        auto* dialog = m_site->find<QDialog>(QStringLiteral("data.ask_unblind"));
        const QStringList findings = tests::settledFindings(dialog);
        QVERIFY2(findings.isEmpty(),
                 qPrintable(name + QStringLiteral(": ") + findings.join(QLatin1Char('\n'))));
        keep(dialog, QStringLiteral("unblind_") + name);
        QVERIFY2(
            dialog->width() <= 1280 && dialog->height() <= 720,
            qPrintable(QStringLiteral("%1: %2 × %3").arg(name).arg(dialog->width()).arg(dialog->height())));
        auto* reason = dialog->findChild<QLineEdit*>(QStringLiteral("data.ask_unblind.reason"));
        auto* accept = dialog->findChild<QPushButton*>(QStringLiteral("data.ask_unblind.accept"));
        QVERIFY(accept && !accept->isEnabled());
        QVERIFY(reason->mapToGlobal(QPoint(0, reason->height())).y() <=
                accept->mapToGlobal(QPoint()).y()); // asked for before it is decided
        QTest::keyClick(dialog, Qt::Key_Escape);    // it stays blind
        QTRY_VERIFY_WITH_TIMEOUT(!m_site->find<QDialog>(QStringLiteral("data.ask_unblind")), kPatience_ms);
    });
}

void TestMaskedStudy::sealedSittingsAreToldAsSuch() {
    session::StudyRunRequest request;
    request.study = m_study;
    request.trialsAtMost = 1;
    request.observer.weber = 0.12;
    const auto simulated =
        tests::writeAs(*m_site, m_site->actor("rhea"), [&](database::StudyRepository& studies) {
            return studies.enrolParticipant(m_study, {}, 0, "weber:0.12", "SIM01");
        });
    request.participantCode = simulated->code;
    const auto run = session::runStudyHeadless(m_site->database(), m_site->actor("rhea"), request);
    QVERIFY2(run, run ? "" : run.error().message.c_str());
    everyLook([this](const QString& name) {
        m_site->go(QStringLiteral("sessions"));
        QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
        auto* table = m_site->find<QTableView>(QStringLiteral("sessions.table"));
        QTRY_VERIFY_WITH_TIMEOUT(table && table->model()->rowCount() > 0, kPatience_ms);
        const QStringList findings = tests::settledFindings(m_site->window->screen());
        QVERIFY2(findings.isEmpty(),
                 qPrintable(name + QStringLiteral(": ") + findings.join(QLatin1Char('\n'))));
        keep(m_site->window.get(), QStringLiteral("sealed_sessions_") + name);
        const auto cell = [&](int column) {
            return table->model()->index(table->currentIndex().row(), column).data().toString();
        };
        QCOMPARE(cell(desktop::SessionTableModel::exercise),
                 desktop::SessionWords::study()); // and not its token
        QCOMPARE(cell(desktop::SessionTableModel::length), desktop::SessionTableModel::tr("sealed"));
        // Nobody is led to what stays closed: neither by a button nor by Enter.
        for (const char* button : {"sessions.open", "sessions.play"})
            QVERIFY(!m_site->find<QPushButton>(QLatin1String(button))->isEnabled() &&
                    !m_site->find<QPushButton>(QLatin1String(button))->toolTip().isEmpty());
        emit table->activated(table->currentIndex());
        QCOMPARE(m_site->context.navigator().current().screen, QStringLiteral("sessions"));
    });
}

QTEST_MAIN(TestMaskedStudy)
#include "test_masked_study.moc"
