// SPDX-License-Identifier: GPL-3.0-or-later
// An error is passed on by CHIRON_TRY alone. What passes one on by hand, since something else has to happen
// first, is listed here with the reason.
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>
#include <map>

namespace {

/// Source and how often it passes on an error by hand.
const std::map<QString, int> kByHand{
    // Something is undone before the error is returned.
    {"app/session/demo_site.cpp", 1},
    {"app/session/live_recording.cpp", 1},
    {"app/session/training_run.cpp", 1},
    {"database/database.cpp", 3},
    {"database/schema/migration_runner.cpp", 2},
    {"database/upkeep/daily_backup.cpp", 3},
    {"database/upkeep/restorable.cpp", 1},
    {"database/upkeep/restore.cpp", 3},
    // The error becomes a finding of a report that goes on.
    {"database/integrity/audit_check.cpp", 1},
    {"database/integrity/study_check.cpp", 1},
    {"database/integrity/verifier.cpp", 2},
    // The error is kept until a session has ended, or becomes part of what is returned.
    {"app/desktop/debrief/debrief_screen.cpp", 1},
    {"app/desktop/login/login_screen.cpp", 1},
    {"app/desktop/study_data/study_data_actions.cpp", 1},
    {"app/exercises/sphere_apex/session/apex_director.cpp", 1},
    {"app/exercises/sphere_apex/session/live_apex_state.cpp", 3},
    {"app/session/backup_schedule.cpp", 2},
    {"app/session/study/live_study_state.cpp", 2},
    {"app/session/study/study_director.cpp", 1},
    {"app/session/study/study_runner.cpp", 1},
    {"app/station/main.cpp", 1},
    {"database/writer_thread.cpp", 1},
    // Certain failures are answered in a loop, and others are passed on.
    {"app/cli/psychophysics/fit_data.cpp", 1},
    {"app/session/recovery.cpp", 1},
    {"app/session/study_export_bids.cpp", 1},
    // A reader that collects its faults makes the error of them.
    {"app/cli/study/questionnaire_import.cpp", 1},
    {"app/session/device_json.cpp", 3},
    {"app/session/safety_json.cpp", 1},
};

/// How often a source passes on an error as it is.
int passedByHand(const QString& source) {
    static const QRegularExpression byHand(QStringLiteral(R"(\bunexpected\([^;,{}]*\berror\(\)\))"));
    static const QRegularExpression changed(QStringLiteral(R"(\bunexpected\(\s*\w+\(.*\berror\(\)\))"));
    int count = 0;
    for (const QString& line : source.split(u'\n'))
        count += line.contains(byHand) && !line.contains(changed);
    return count;
}

} // namespace

class TestErrorPassing : public QObject {
    Q_OBJECT
private slots:
    void onlyByTheMacro() {
        const QDir root(QStringLiteral(CHIRON_SOURCE_DIR));
        std::map<QString, int> found;
        int sources = 0;
        for (const char* folder : {"app", "curriculum", "database", "modules"}) {
            QDirIterator files(root.filePath(QLatin1String(folder)), {"*.cpp", "*.h"}, QDir::Files,
                               QDirIterator::Subdirectories);
            while (files.hasNext()) {
                QFile file(files.next());
                QVERIFY(file.open(QIODevice::ReadOnly));
                ++sources;
                if (const int count = passedByHand(QString::fromUtf8(file.readAll())); count > 0)
                    found[root.relativeFilePath(file.fileName())] = count;
            }
        }
        QVERIFY(sources > 1000);
        found.erase(QStringLiteral("modules/core/result.h")); // the macro itself
        for (const auto& [file, count] : found)
            QVERIFY2(kByHand.contains(file) && kByHand.at(file) == count,
                     qPrintable(QStringLiteral("%1 passes on %2 errors by hand: expected CHIRON_TRY, or %3")
                                    .arg(file)
                                    .arg(count)
                                    .arg(kByHand.contains(file) ? kByHand.at(file) : 0)));
        for (const auto& [file, count] : kByHand)
            QVERIFY2(found.contains(file),
                     qPrintable(file + QStringLiteral(" passes on none: remove it here")));
    }

    void whatTheTestTells() {
        QCOMPARE(passedByHand("return tl::unexpected(row.error());"), 1);
        QCOMPARE(passedByHand("x = row ? 1 : core::Result<int>(tl::unexpected(row.error()));"), 1);
        QCOMPARE(passedByHand("return tl::unexpected((*director)->recorded().error());"), 1);
        QCOMPARE(passedByHand("return tl::unexpected(refused(same.error(), DeviceRefusal::rendersLess));"),
                 0);
        QCOMPARE(passedByHand("return tl::unexpected(sealed(sitting, state.error()));"), 0);
        QCOMPARE(passedByHand("CHIRON_TRY(row);"), 0);
    }
};

QTEST_GUILESS_MAIN(TestErrorPassing)
#include "test_error_passing.moc"
