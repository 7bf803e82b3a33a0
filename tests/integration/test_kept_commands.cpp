// SPDX-License-Identifier: GPL-3.0-or-later
// What the commands answer about content, sessions, studies, laws and data, against what was read and kept: a
// word, a unit, a row or a figure that is no longer said. A change that is meant is kept anew, and the
// difference is read in review: CHIRON_STORE_COMMANDS=1 build/release/tests/integration/test_kept_commands
#include "catalogue/catalogue.h"
#include "cli_process.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace {

const QString kKept = QStringLiteral(CHIRON_SOURCE_DIR "/tests/integration/kept_commands.txt");
constexpr int kMostLines = 250; ///< of one answer or file
constexpr double kSame = 1e-6;  ///< relative: libraries of mathematics round differently on other processors,
                                ///< and a session lasts long

/// Points as a table with a header, for a law or a fit.
QByteArray table(const QByteArray& header, std::initializer_list<const char*> rows) {
    QByteArray text = header + '\n';
    for (const char* row : rows)
        text += QByteArray(row) + '\n';
    return text;
}

/// What is of the day, the computer or a draw becomes one 0.
QString masked(QString text, const QString& folder) {
    text.replace(folder, QStringLiteral("DIR"));
    static const QRegularExpression digest(QStringLiteral("\\b(?=[0-9a-f]*[0-9])[0-9a-f]{7,}\\b")),
        time(QStringLiteral("\\b20[0-9]{2}-[0-9]{2}-[0-9]{2}([T ][0-9:.]+Z?)?")),
        code(QStringLiteral("\\b[0-9A-Z]{3}-[0-9A-Z]{3}\\b")),
        recovery(QStringLiteral("\\b[0-9A-Za-z]{4,}(-[0-9A-Za-z]{4,}){3,}\\b")),
        build(QStringLiteral("\\+g?[0-9a-f]{6,}(-dirty|\\.dirty)?")),
        processor(QStringLiteral("\\b(x86-64|aarch64)(\\+[0-9a-z]+)*"));
    for (const QRegularExpression& ofToday : {recovery, code, time, build, digest, processor})
        text.replace(ofToday, QStringLiteral("0"));
    return text;
}

/// A table as its columns: how many cells they have, the mean of numbers, how many different words.
QString summaryOf(const QByteArray& bytes, QChar separator) {
    struct Column {
        double sum = 0.0, squares = 0.0;
        int numbers = 0;
        QSet<QString> words;
    };
    const QStringList lines = QString::fromUtf8(bytes).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    const QStringList names = lines.value(0).split(separator);
    std::vector<Column> columns(static_cast<std::size_t>(names.size()));
    for (const QString& line : lines.mid(1)) {
        const QStringList cells = line.split(separator);
        for (qsizetype i = 0; i < names.size(); ++i) {
            Column& column = columns[static_cast<std::size_t>(i)];
            const QString cell = cells.value(i);
            bool isNumber = false;
            const double x = cell.toDouble(&isNumber);
            if (isNumber) {
                ++column.numbers;
                column.sum += x;
                column.squares += x * x;
            } else {
                column.words << cell;
            }
        }
    }
    QString text = QStringLiteral("%1 rows\n").arg(lines.size() - 1);
    for (qsizetype i = 0; i < names.size(); ++i) {
        const Column& column = columns[static_cast<std::size_t>(i)];
        text += QStringLiteral("  %1: ").arg(names[i]);
        text += column.numbers > 0 ? QStringLiteral("%1 numbers, mean %2, rms %3; ")
                                         .arg(column.numbers)
                                         .arg(column.sum / column.numbers, 0, 'g', 7)
                                         .arg(std::sqrt(column.squares / column.numbers), 0, 'g', 7)
                                   : QString();
        text += QStringLiteral("%1 words\n").arg(column.words.size());
    }
    return text;
}

/// Lines whose words are the same and whose numbers are nearly.
bool alike(const QString& a, const QString& b) {
    if (a == b)
        return true;
    static const QRegularExpression number(QStringLiteral("[-+]?[0-9]+(\\.[0-9]+)?([eE][-+]?[0-9]+)?"));
    const auto parts = [](const QString& text, QStringList& words, std::vector<double>& numbers) {
        qsizetype from = 0;
        for (auto it = number.globalMatch(text); it.hasNext();) {
            const auto match = it.next();
            words << text.mid(from, match.capturedStart() - from).simplified();
            numbers.push_back(match.captured().toDouble());
            from = match.capturedEnd();
        }
        words << text.mid(from).simplified();
    };
    QStringList wordsA, wordsB;
    std::vector<double> x, y;
    parts(a, wordsA, x);
    parts(b, wordsB, y);
    if (wordsA != wordsB || x.size() != y.size())
        return false;
    for (std::size_t i = 0; i < x.size(); ++i)
        if (std::abs(x[i] - y[i]) > kSame * std::max(std::abs(x[i]), std::abs(y[i])) + 1e-9)
            return false;
    return true;
}

/// Ids, in the order of the content; empty where it cannot be read.
const QStringList& everyExercise() {
    static const QStringList ids = [] {
        QStringList all;
        if (const auto content = chiron::catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content"))
            for (const chiron::catalogue::Exercise& exercise : content->exercises())
                all << QString::fromStdString(exercise.id);
        return all;
    }();
    return ids;
}

struct Command {
    QString words; ///< as typed, without the program; SITE, DIR: the test's
    QByteArray input = {};
};

} // namespace

class TestKeptCommands : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void answers_data();
    void answers();
    void cleanupTestCase();

private:
    static std::vector<Command> commands();
    void write(const QString& name, const QByteArray& bytes) {
        QFile file(m_folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
    }
    QString answer(const Command& command);

    QTemporaryDir m_folder;
    std::map<QString, QStringList> m_kept;
    std::vector<std::pair<QString, QStringList>> m_now;
};

/// In the order in which they are run: later ones ask about what earlier ones made.
std::vector<Command> TestKeptCommands::commands() {
    const QByteArray hemisphere = table("px_m,py_m,pz_m,vx_m_per_s,vy_m_per_s,vz_m_per_s",
                                        {"0,0,0.019,0,0,-0.01", "0.01,0.002,0.016,0.02,0,0",
                                         "0.005,-0.012,0.014,0,0.03,-0.02", "0,0,0.03,0,0,0"});
    std::vector<Command> all{
        {"exercise list"},
        {"exercise list --json"},
        {"device list"},
        {"device list --json"},
        {"evaluate --list"},
        {"evaluate hemisphere --with-inputs", hemisphere},
        {"evaluate hemisphere --json", hemisphere},
        {"psychophysics fit DIR/levels.csv"},
        {"psychophysics fit DIR/levels.csv --function weibull --method ml --lapse 0.02 --threshold-at 0.75 "
         "--reference 10 --json"},
        {"psychophysics fit DIR/levels.csv --function logistic --method ml --bootstrap 50 --seed 3"},
        {"psychophysics fit DIR/groups.csv --by who --curve 5"},
        {"psychophysics fit DIR/yesno.csv --guess 0 --function gauss --monte-carlo 40 --json"},
        {"psychophysics compare DIR/groups.csv --by who"},
        {"psychophysics compare DIR/groups.csv --by who --test threshold --shared width,lapse --monte-carlo "
         "20 --json"},
        {"psychophysics dprime --task 2afc --correct 38 --total 50"},
        {"psychophysics dprime --task yes-no --hits 40 --misses 10 --false-alarms 7 --correct-rejections 43 "
         "--json"},
        {"psychophysics dprime --task same-different --hits 30 --misses 20 --false-alarms 5 "
         "--correct-rejections 45"},
        {"psychophysics rank DIR/rankings.csv --order soft,medium,hard"},
        {"psychophysics rank DIR/rankings.csv --json"},
        {"metrics DIR/trace.csv"},
        {"metrics DIR/trace.csv --force-limit 2 --json"},
        {"mesh check DIR/cube.obj"},
        {"mesh check DIR/cube.obj --unit mm --json"},
        {"device check --seed 1 --poses 4"},
        {"device check --mechanism gimbal_hprd --json"},
        {"init --admin ada --database SITE"},
        {"user add tina --role trainee --database SITE --as ada"},
        {"user list --database SITE --as ada"},
    };
    for (const QString& exercise : everyExercise())
        all.push_back({QStringLiteral("exercise show %1").arg(exercise)});
    for (const char* session : {"elastic_tube --level 1 --operator expert --seed 11",
                                "object_handling --level 1 --operator unsafe --seed 12",
                                "urethra_insertion --level 2 --operator novice --seed 13",
                                "palpation --level 1 --operator intermediate --seed 14",
                                "elastic_tube --level 5 --operator novice --seed 15 --familiarisation"})
        all.push_back({QStringLiteral("train %1 --database SITE --as ada%2")
                           .arg(QLatin1String(session), QLatin1String(session[0] == 'u' ? " --json" : ""))});
    all.push_back({"session list --database SITE --as ada"});
    all.push_back({"session list --json --database SITE --as ada"});
    for (int session = 1; session <= 5; ++session) {
        all.push_back({QStringLiteral("session show %1 --database SITE --as ada").arg(session)});
        all.push_back({QStringLiteral("score %1 --database SITE --as ada%2")
                           .arg(session)
                           .arg(QLatin1String(session % 2 ? " --json" : ""))});
        all.push_back(
            {QStringLiteral(
                 "session export %1 --format csv,json,bids --folder DIR/session --database SITE --as ada")
                 .arg(session)});
    }
    for (const char* words :
         {"session show 3 --json --database SITE --as ada",
          "replay 3 --database SITE --as ada",
          "replay 1 --json --database SITE --as ada",
          "verify --database SITE --as ada",
          "study new stiffness_2afc --database SITE --as ada",
          "study show 1 --database SITE --as ada",
          "study list --database SITE --as ada",
          "study run stiffness_2afc --participant S01 --observer weber:0.12,lapse:0.02 --seed 7 --quick "
          "--database DIR/study.db",
          "study run stiffness_2afc --participant S02 --observer weber:0.18,lapse:0.02 --seed 8 --quick "
          "--database DIR/study.db",
          "study run friction --participant S01 --observer weber:0.2 --seed 9 --quick --json --database "
          "DIR/study.db",
          "study list --database DIR/study.db",
          "study show 1 --database DIR/study.db",
          "study show 2 --json --database DIR/study.db",
          "study analyse 1 --database DIR/study.db",
          "study analyse 1 --json --database DIR/study.db",
          "study analyse 2 --database DIR/study.db",
          "study rerun 1 --database DIR/study.db",
          "study export 1 --format csv,bids --out DIR/study/data --database DIR/study.db",
          "study plan stiffness_2afc --observer weber:0.12,lapse:0.02 --runs 6",
          "study plan stiffness_2afc --observer weber:0.12 --runs 6 --power --ratio 1.3 --participants 6 "
          "--json",
          "study new surgeons --database SITE --as ada",
          "study freeze 2 --database SITE --as ada",
          "study questionnaire template 2 --out DIR/study/template/answers.csv --database SITE --as ada"})
        all.push_back({QString::fromLatin1(words)});
    int study = 2;
    for (const char* key : {"apex", "deformation", "mass", "roughness", "stiffness_adjustment",
                            "stiffness_descending", "stiffness_magnitude", "viscosity"}) {
        all.push_back({QStringLiteral("study new %1 --database SITE --as ada").arg(QLatin1String(key))});
        all.push_back({QStringLiteral("study show %1 --database SITE --as ada").arg(++study)});
    }
    return all;
}

void TestKeptCommands::initTestCase() {
    QVERIFY(m_folder.isValid());
    QVERIFY(!everyExercise().isEmpty());
    write("levels.csv", table("intensity,n_correct,n_total",
                              {"1,21,40", "2,24,40", "3,29,40", "4,33,40", "5,37,40", "7,39,40"}));
    write("yesno.csv",
          table("intensity,n_correct,n_total", {"-3,2,30", "-1.5,6,30", "0,13,30", "1.5,24,30", "3,28,30"}));
    write("groups.csv",
          table("who,intensity,n_correct,n_total", {"a,1,11,20", "a,2,14,20", "a,3,17,20", "a,4,19,20",
                                                    "b,1,10,20", "b,2,11,20", "b,3,14,20", "b,4,17,20"}));
    write("rankings.csv", table("soft,medium,hard",
                                {"1,2,3", "1,3,2", "1,2,3", "2,1,3", "1,2,3", "1,2,3", "3,2,1", "1,2,3"}));
    QByteArray trace = "t_s,x_mm,y_mm,z_mm,fx_N,fy_N,fz_N\n";
    for (int i = 0; i <= 2000; ++i) {
        const double t = 0.001 * i, s = t / 2.0, way = s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
        trace +=
            QString::asprintf("%.3f,%.6f,%.6f,%.6f,%.4f,%.4f,%.4f\n", t, 40.0 * way, 5.0 * std::sin(3.0 * t),
                              2.0 * std::cos(2.0 * t), 0.3 * std::sin(5.0 * t), 0.1, 2.5 * way)
                .toUtf8();
    }
    write("trace.csv", trace);
    write("cube.obj", "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 0 0 10\nv 10 0 10\nv 10 10 10\nv 0 10 10\nf "
                      "1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    QFile file(kKept);
    QString name;
    if (!file.open(QIODevice::ReadOnly))
        return;
    for (const QString& line : QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'))) {
        if (line.startsWith(QLatin1String("$ ")))
            name = line.mid(2);
        else if (!name.isEmpty())
            m_kept[name] << line;
    }
}

/// The exit status, both streams, and what files were written.
QString TestKeptCommands::answer(const Command& command) {
    QString words = command.words;
    QDir().mkpath(m_folder.filePath(QStringLiteral("study/template")));
    words.replace(QStringLiteral("SITE"), m_folder.filePath(QStringLiteral("site.db")))
        .replace(QStringLiteral("DIR"), m_folder.path());
    const CliRun run = runCli(
        words.split(QLatin1Char(' ')), command.input,
        {{"CHIRON_PASSWORD", "a long password for tests"}, {"CHIRON_NEW_PASSWORD", "another long password"}});
    QString text = QStringLiteral("exit status %1\n").arg(run.ended ? run.exitCode : -1) +
                   QString::fromUtf8(run.out) + QString::fromUtf8(run.err);
    for (const QString& folder : {QStringLiteral("session"), QStringLiteral("study")}) {
        QStringList written;
        for (QDirIterator it(m_folder.filePath(folder), QDir::Files, QDirIterator::Subdirectories);
             it.hasNext();)
            written << it.next();
        written.sort();
        for (const QString& path : written) {
            QFile file(path);
            if (!file.open(QIODevice::ReadOnly))
                continue;
            const QByteArray bytes = file.readAll();
            const bool commas = path.endsWith(QLatin1String(".csv")),
                       tabs = path.endsWith(QLatin1String(".tsv"));
            text += QStringLiteral("file ") + path + QLatin1Char('\n') +
                    (commas || tabs ? summaryOf(bytes, QLatin1Char(commas ? ',' : '\t'))
                                    : QString::fromUtf8(bytes)) +
                    QLatin1Char('\n');
        }
        QDir(m_folder.filePath(folder)).removeRecursively();
    }
    return masked(text, m_folder.path());
}

void TestKeptCommands::answers_data() {
    QTest::addColumn<int>("index");
    int index = 0;
    for (const Command& command : commands())
        QTest::addRow("%s", qPrintable(command.words)) << index++;
}

void TestKeptCommands::answers() {
    QFETCH(int, index);
    const Command command = commands()[static_cast<std::size_t>(index)];
    QStringList now;
    for (const QString& line : answer(command).split(QLatin1Char('\n')))
        if (now.size() < kMostLines && !line.trimmed().isEmpty())
            now << (line.startsWith(QLatin1String("$ ")) ? QLatin1Char(' ') + line : line);
    m_now.emplace_back(command.words, now);
    if (qEnvironmentVariableIsSet("CHIRON_STORE_COMMANDS"))
        return;
    QStringList kept = m_kept[command.words];
    kept.removeAll(QString());
    QVERIFY2(!kept.isEmpty(), "nothing is kept of this command: see the head of this file");
    for (qsizetype i = 0; i < std::max(kept.size(), now.size()); ++i)
        QVERIFY2(alike(kept.value(i), now.value(i)),
                 qPrintable(QStringLiteral("line %1\n   was: %2\n   is:  %3")
                                .arg(i + 1)
                                .arg(kept.value(i).left(300), now.value(i).left(300))));
}

void TestKeptCommands::cleanupTestCase() {
    if (!qEnvironmentVariableIsSet("CHIRON_STORE_COMMANDS"))
        return;
    QFile file(kKept);
    QVERIFY(file.open(QIODevice::WriteOnly));
    for (const auto& [words, lines] : m_now)
        file.write((QStringLiteral("$ ") + words + QLatin1Char('\n') + lines.join(QLatin1Char('\n')) +
                    QLatin1Char('\n'))
                       .toUtf8());
}

QTEST_GUILESS_MAIN(TestKeptCommands)
#include "test_kept_commands.moc"
