// SPDX-License-Identifier: GPL-3.0-or-later
// A study of the apex on the data screen, as P2's figure 4; and the run screen, where it is begun.
// CHIRON_KEEP_PICTURES=<folder> keeps pictures of both.
#include "desktop/study_data/study_data_screen.h"
#include "report/plot_view.h"
#include "session/study/mark_sessions.h"
#include "support/every_place.h"
#include "support/kept_text.h"
#include "support/languages.h"
#include "support/patience.h"
#include "support/picture_look.h"
#include "support/screen_outline.h"

#include <QDir>
#include <QFrame>
#include <QLabel>
#include <QTabBar>
#include <QTableWidget>

using chiron::tests::kPatience_ms;

using namespace chiron;
using tests::DesktopFixture;

class TestApexPage : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        m_site = std::make_unique<DesktopFixture>();
        tests::applyLook(*m_site);
        m_site->logIn("rhea");
        const database::Actor rhea = m_site->actor("rhea");
        m_study = tests::addDraft(*m_site, rhea, m_design);
        tests::writeAs(*m_site, rhea,
                       [&](database::StudyRepository& studies) { return studies.freezeStudy(m_study); });
        m_person =
            QString::fromStdString(tests::addParticipant(*m_site, rhea, m_study, m_design, "somebody").code);
    }
    void cleanupTestCase() { m_site.reset(); }

    void nobodyYet() {
        go("study_data");
        QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QTabBar>(QStringLiteral("data.tabs")), kPatience_ms);
        QVERIFY(!m_site->find<QTableWidget>(QStringLiteral("data.runs")));
        keep("empty");
        hold("nobody yet");
    }
    void theRunScreenBeginsIt() {
        m_site->go(QStringLiteral("study_run"), {{QStringLiteral("study"), qlonglong(m_study)},
                                                 {QStringLiteral("participant"), m_person}});
        QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("run.begin")), kPatience_ms);
        keep("run");
        hold("to be begun");
    }
    void marksOfEverybody() {
        addRuns(4);
        go("study_data");
        QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QTableWidget>(QStringLiteral("data.runs")), kPatience_ms);
        const auto* table = m_site->find<QTableWidget>(QStringLiteral("data.runs"));
        QCOMPARE(table->rowCount(), 4);
        for (int row = 0; row < table->rowCount(); ++row)
            for (int column = 0; column < table->columnCount(); ++column) {
                const auto* cell = table->item(row, column);
                QVERIFY2(cell && !cell->text().isEmpty(),
                         qPrintable(table->horizontalHeaderItem(column)->text()));
                if (column > 0 &&
                    column < table->columnCount() - 2) // bias, SD (of which there is no share) and error
                    QVERIFY2(cell->text().contains(column == 3 || column == 4 ? QStringLiteral("mm")
                                                                              : QStringLiteral("mm (")),
                             qPrintable(cell->text()));
            }
        const auto* marks = m_site->find<report::PlotView>(QStringLiteral("data.apex_marks"));
        QVERIFY(marks);
        const QStringList legend = marks->legendTexts();
        for (int row = 0; row < table->rowCount(); ++row)
            QVERIFY2(legend.contains(table->item(row, 0)->text()), qPrintable(legend.join(u' ')));
        QVERIFY(m_site->find<report::PlotView>(QStringLiteral("data.apex_errors")));
        keep("group");
        hold("everybody");
    }
    void onePersonAndBackAgain() {
        auto* table = m_site->find<QTableWidget>(QStringLiteral("data.runs"));
        emit table->activated(table->model()->index(1, 0));
        QTRY_COMPARE_WITH_TIMEOUT(m_site->find<QTabBar>(QStringLiteral("data.tabs"))->currentIndex(),
                                  int(desktop::StudyDataScreen::personTab), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QComboBox>(QStringLiteral("data.run")), kPatience_ms);
        QVERIFY(m_site->find<report::PlotView>(QStringLiteral("data.apex_marks")));
        keep("person");
        hold("one person");
    }
    void nothingElseIsKept() {
        if (m_held > 1) // not of one test alone
            QCOMPARE(m_kept.unseen(), QStringList());
    }
    void otherLooksAndLanguages() {
        for (const char* language : tests::otherLanguages()) {
            m_site->settings.setLanguage(QLatin1String(language));
            m_site->settings.setTheme(desktop::ThemeName::dark);
            m_site->context.applyAppearance();
            go("study_data");
            QTRY_VERIFY_WITH_TIMEOUT(m_site->find<report::PlotView>(QStringLiteral("data.apex_marks")),
                                     kPatience_ms);
            keep(language);
        }
    }

private:
    void go(const char* screen) {
        m_site->go(QLatin1String(screen), {{QStringLiteral("study"), qlonglong(m_study)}});
        QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    }
    /// Marks of seeds of their own: those that the runner draws follow a participant's code, which is another
    /// each time.
    void addRuns(int people) {
        const database::Actor rhea = m_site->actor("rhea");
        const std::string condition = m_design.conditions.front().id;
        const double radius_m = m_design.conditions.front().stimulus.reference;
        for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(people); ++seed) {
            const auto participant = tests::writeAs(*m_site, rhea, [&](database::StudyRepository& studies) {
                return studies.enrolParticipant(m_study, {}, 0, "weber:0.1");
            });
            auto progress = session::StudyProgress::begin(m_design, condition, seed);
            QVERIFY2(progress, progress ? "" : progress.error().message.c_str());
            const database::StudyRunNumber run =
                *tests::writeAs(*m_site, rhea, [&](database::StudyRepository& studies) {
                    return studies.beginRun({participant->id, condition, 0, seed, progress->procedureIds()});
                });
            while (!progress->done()) {
                if (progress->breakDue())
                    progress->breakTaken();
                auto trial = progress->record(session::plannedMark(radius_m, seed, progress->next().ordinal));
                QVERIFY2(trial, trial ? "" : trial.error().message.c_str());
                trial->run = run;
                tests::writeAs(*m_site, rhea, [&](database::StudyRepository& studies) {
                    return studies.storeStudyTrial(*trial);
                });
            }
            tests::writeAs(*m_site, rhea, [&](database::StudyRepository& studies) {
                return studies.finishRun(run, database::StudyRunState::completed);
            });
        }
    }
    void keep(const char* name) {
        if (qEnvironmentVariableIsSet("CHIRON_KEEP_PICTURES"))
            m_site->window->resize(1280, 1200);
        tests::keepPicture(*m_site, QStringLiteral("apex_%1").arg(QLatin1String(name)));
    }

    /// How the screen is made, against what was read and kept: CHIRON_STORE_OUTLINES=1
    /// QT_QPA_PLATFORM=offscreen build/release/tests/gui/studies/test_apex_page
    void hold(const char* name) {
        QVERIFY(tests::waitUntilLoaded(*m_site));
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        const QString differs =
            m_kept.differs(QLatin1String(name), tests::ScreenOutline::of(*m_site->window->screen()));
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
        ++m_held;
    }

    std::unique_ptr<DesktopFixture> m_site;
    const psychophysics::StudyDesign m_design = tests::apexStudy("apex_small", 10);
    database::StudyNumber m_study = 0;
    QString m_person;
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/studies/kept_apex_page.txt")};
    int m_held = 0;
};

QTEST_MAIN(TestApexPage)
#include "test_apex_page.moc"
