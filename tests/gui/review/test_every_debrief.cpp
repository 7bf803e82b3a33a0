// SPDX-License-Identifier: GPL-3.0-or-later
// Every exercise, however a session of it ended, through debrief, playback, results and the printed report,
// in each language: no word and no plot of another exercise, and its own where there is something to show. By
// default one level of each exercise; CHIRON_EVERY_LEVEL=1: all of them. CHIRON_PICTURES=<folder> keeps what
// is seen.
#include "app/exercises/palpation/session/palpation_marks.h"
#include "app/exercises/urethra_insertion/session/insertion_marks.h"
#include "desktop/debrief/debrief_data.h"
#include "desktop/debrief/report_words.h"
#include "desktop/plots/session_token_words.h"
#include "report/plot_view.h"
#include "report/report_writer.h"
#include "report/session_plots.h"
#include "review_sessions.h"
#include "session/session_view.h"
#include "session/station.h"
#include "support/languages.h"
#include "support/patience.h"
#include "support/pdf_text.h"

#include <QAbstractButton>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QListWidget>
#include <QRegularExpression>
#include <QTableWidget>
#include <map>
#include <optional>

using chiron::tests::kPatience_ms;

using namespace chiron;
using tests::DesktopFixture;
using tests::MadeSession;

namespace {

/// `unmarked`: completed by nobody: every trial ran out of time under a hand that did nothing. `nothing`: the
/// person stopped before there was a trial.
enum class Ending { completed, stopped, timedOut, unmarked, nothing };

bool isLate(Ending ending) {
    return ending == Ending::timedOut || ending == Ending::unmarked;
}

/// Whether there is something that the plots of this exercise can show: an answer on a sphere is a finished
/// trial's; what was begun of the others is shown.
bool hasPlots(const std::string& exercise, Ending ending) {
    return ending != Ending::nothing && !(ending == Ending::stopped && exercise == "sphere_apex");
}

/// A text of the program, as it is before it is translated.
struct Said {
    QByteArray context;
    QByteArray text;

    QString translated() const {
        return text.isEmpty() ? QString() : QCoreApplication::translate(context, text);
    }
};

/// What only one exercise talks about, as a pattern a language; what only its debrief draws; the titles of
/// what is drawn on paper; what is said of a trial that time ended.
struct Own {
    std::map<QString, QString> words;
    QStringList plots;
    std::vector<Said> paper;
    Said lateInDebrief; ///< empty: the debrief's plots show how it went, and its metrics say that it was not
                        ///< completed
    Said lateInPlayback;
};

Said saidIn(const QJsonArray& pair) {
    return {pair.at(0).toString().toUtf8(), pair.at(1).toString().toUtf8()};
}

Own ownOf(const QJsonObject& json) {
    Own own;
    const QJsonObject words = json["words"].toObject();
    for (const QString& language : words.keys())
        own.words[language] = words[language].toString();
    for (const QJsonValue& plot : json["plots"].toArray())
        own.plots << plot.toString();
    for (const QJsonValue& title : json["paper"].toArray())
        own.paper.push_back(saidIn(title.toArray()));
    const QJsonObject late = json["time_was_up"].toObject();
    own.lateInDebrief = saidIn(late["debrief"].toArray());
    own.lateInPlayback = saidIn(late["playback"].toArray());
    return own;
}

/// From each exercise's folder beside the tests.
const std::map<std::string, Own>& owners() {
    static const std::map<std::string, Own> kOwners = [] {
        std::map<std::string, Own> all;
        const QDir folder(QStringLiteral(CHIRON_SOURCE_DIR "/tests/exercises"));
        for (const QString& id : folder.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
            QFile file(folder.filePath(id + QStringLiteral("/debrief.json")));
            if (!file.open(QIODevice::ReadOnly))
                continue;
            const QJsonDocument json = QJsonDocument::fromJson(file.readAll());
            if (!json.isObject())
                qFatal("%s is no JSON object", qPrintable(file.fileName()));
            all[id.toStdString()] = ownOf(json.object());
        }
        return all;
    }();
    return kOwners;
}

QString wordsIn(const Own& own, const QString& language) {
    return own.words.at(language);
}

/// The level with one trial, of at most so long where that is said.
catalogue::ExerciseLevel shortened(const catalogue::ExerciseLevel& shipped, std::optional<double> limit_s) {
    QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(shipped.resolvedJson)).object();
    QJsonObject inner = json["level"].toObject();
    QJsonObject parameters = inner["parameters"].toObject();
    if (!parameters.contains("trial_limit_s"))
        qFatal("the resolved level does not say how long a trial may take");
    if (limit_s)
        parameters["trial_limit_s"] = *limit_s;
    if (parameters.contains("trials"))
        parameters["trials"] = 1;
    inner["parameters"] = parameters;
    json["level"] = inner;
    auto changed =
        catalogue::fromResolvedJson(QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString());
    return changed ? *changed : shipped;
}

/// All that a person can read on a screen: labels, buttons, tables with their tips, lists, plots.
QStringList readable(const QWidget* screen) {
    QStringList texts;
    for (const QLabel* label : screen->findChildren<QLabel*>())
        texts << label->text() << label->toolTip();
    for (const QAbstractButton* button : screen->findChildren<QAbstractButton*>())
        texts << button->text() << button->toolTip();
    for (const QTableWidget* table : screen->findChildren<QTableWidget*>())
        for (int column = 0; column < table->columnCount(); ++column) {
            if (const QTableWidgetItem* head = table->horizontalHeaderItem(column))
                texts << head->text();
            for (int row = 0; row < table->rowCount(); ++row)
                if (const QTableWidgetItem* item = table->item(row, column))
                    texts << item->text() << item->toolTip()
                          << item->data(Qt::AccessibleDescriptionRole).toString();
        }
    for (const QListWidget* list : screen->findChildren<QListWidget*>())
        for (int row = 0; row < list->count(); ++row)
            texts << list->item(row)->text();
    for (const QWidget* widget : screen->findChildren<QWidget*>()) // a plot has no meta-object of its own
        if (const auto* plot = dynamic_cast<const report::PlotView*>(widget))
            texts << plot->accessibleName() << plot->legendTexts();
    texts.removeAll(QString());
    return texts;
}

/// The words of other exercises among these texts.
QStringList foreignWords(const QStringList& texts, const std::string& exercise, const QString& language) {
    QStringList found;
    for (const auto& [id, own] : owners()) {
        if (id == exercise)
            continue;
        const QRegularExpression words(wordsIn(own, language),
                                       QRegularExpression::CaseInsensitiveOption |
                                           QRegularExpression::UseUnicodePropertiesOption);
        for (const QString& text : texts)
            if (const auto match = words.match(text); match.hasMatch())
                found << QStringLiteral("\"%1\" of %2 in: %3")
                             .arg(match.captured(), QString::fromStdString(id), text);
    }
    return found;
}

bool hasOwnWord(const QStringList& texts, const std::string& exercise, const QString& language) {
    const QRegularExpression words(wordsIn(owners().at(exercise), language),
                                   QRegularExpression::CaseInsensitiveOption |
                                       QRegularExpression::UseUnicodePropertiesOption);
    return std::any_of(texts.begin(), texts.end(),
                       [&](const QString& text) { return words.match(text).hasMatch(); });
}

bool isSaid(const QStringList& texts, const QString& words) {
    return std::any_of(texts.begin(), texts.end(), [&](const QString& text) { return text.contains(words); });
}

} // namespace

class TestEveryDebrief : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void speaksOfItsOwnExercise_data();
    void speaksOfItsOwnExercise();
    void paperMarksTheCriticalErrorsOfTheScore();
    void paperHasEveryTool();

private:
    MadeSession scripted(const std::string& exercise, int level, std::optional<double> limit_s,
                         const std::string& operatorName = "expert");
    MadeSession untouched(const std::string& exercise, int level, double limit_s);
    MadeSession made(session::TrainingRequest request, core::Result<session::Station> station);
    MadeSession madeFor(const std::string& exercise, int level, Ending ending);
    report::ReportData reportOf(database::SessionId id, const std::string& exercise, const QString& language);
    QString print(const report::ReportData& data, const QString& name);
    void debrief(database::SessionId id, const std::string& exercise, Ending ending, const QString& language);
    void playback(database::SessionId id, const std::string& exercise, Ending ending,
                  const QString& language);
    void isUnmarked(database::SessionId id);
    void results(const std::string& exercise, int level, const QString& language);
    void paper(database::SessionId id, const std::string& exercise, Ending ending, const QString& language);
    QWidget* screen() { return m_site->window->screen(); }

    std::unique_ptr<DesktopFixture> m_site;
    std::optional<database::Actor> m_tina;
    qsizetype m_row = 0;
    std::map<std::string, MadeSession>
        m_done; ///< of exercise and level: a session that its operator finished
};

void TestEveryDebrief::initTestCase() {
    m_site = std::make_unique<DesktopFixture>();
    m_tina = m_site->actor("tina");
    m_site->context.logIn(*m_tina);
}

void TestEveryDebrief::speaksOfItsOwnExercise_data() {
    QTest::addColumn<QString>("exercise");
    QTest::addColumn<int>("level");
    QTest::addColumn<int>("ending");
    const bool all = qEnvironmentVariableIntValue("CHIRON_EVERY_LEVEL") != 0;
    const std::pair<Ending, const char*> endings[] = {{Ending::completed, "completed"},
                                                      {Ending::stopped, "stopped"},
                                                      {Ending::timedOut, "timed out"},
                                                      {Ending::unmarked, "nothing marked"},
                                                      {Ending::nothing, "stopped at once"}};
    int known = 0;
    for (const catalogue::Exercise& exercise : m_site->context.site().catalogue().exercises()) {
        known += owners().count(exercise.id) > 0 ? 1 : 0;
        for (const catalogue::ExerciseLevel& level : exercise.levels)
            for (const auto& [ending, name] : endings)
                if (all || level.number == 1)
                    QTest::addRow("%s %d %s", exercise.id.c_str(), level.number, name)
                        << QString::fromStdString(exercise.id) << level.number << static_cast<int>(ending);
    }
    QCOMPARE(
        known,
        static_cast<int>(
            m_site->context.site().catalogue().exercises().size())); // a new exercise has words of its own
}

MadeSession TestEveryDebrief::scripted(const std::string& exercise, int level, std::optional<double> limit_s,
                                       const std::string& operatorName) {
    session::TrainingRequest request;
    request.level = shortened(*m_site->context.site().catalogue().find(exercise, level), limit_s);
    request.seed = 11;
    auto station = session::scriptedStation(**session::exerciseKind(exercise), request.level, operatorName,
                                            request.seed);
    return made(std::move(request), std::move(station));
}

/// Whoever began it left the mouse alone until it was over.
MadeSession TestEveryDebrief::untouched(const std::string& exercise, int level, double limit_s) {
    session::TrainingRequest request;
    request.level = shortened(*m_site->context.site().catalogue().find(exercise, level), limit_s);
    auto station = session::keyboardMouseStation({}, **session::exerciseKind(exercise), request.level);
    if (station)
        station->operatorName = "nobody"; // the account that records it has no hand of its own
    return made(std::move(request), std::move(station));
}

MadeSession TestEveryDebrief::made(session::TrainingRequest request, core::Result<session::Station> station) {
    if (!station)
        qFatal("%s", station.error().message.c_str());
    request.ringFolder = recording::defaultRingFolder();
    request.station = std::move(*station);
    auto result = session::runTraining(m_site->database(), database::Actor::simulated(), std::move(request));
    if (!result)
        qFatal("%s", result.error().message.c_str());
    MadeSession made = tests::copyOf(m_site->database(), result->session);
    made.operatorName.clear();
    return made;
}

/// Made once for all endings that need it.
MadeSession TestEveryDebrief::madeFor(const std::string& exercise, int level, Ending ending) {
    constexpr double kShort_s = 4.0;
    const char* kind = ending == Ending::completed  ? ""
                       : ending == Ending::unmarked ? " untouched"
                                                    : " short";
    const std::string key = exercise + std::to_string(level) + kind;
    if (m_done.count(key) == 0)
        m_done.emplace(key, ending == Ending::unmarked
                                ? untouched(exercise, level, kShort_s)
                                : scripted(exercise, level,
                                           ending == Ending::completed ? std::optional<double>() : kShort_s));
    return m_done.at(key);
}

void TestEveryDebrief::speaksOfItsOwnExercise() {
    QFETCH(QString, exercise);
    QFETCH(int, level);
    QFETCH(int, ending);
    const std::string id = exercise.toStdString();
    const auto wanted = static_cast<Ending>(ending);
    MadeSession made = madeFor(id, level, wanted);
    if (wanted == Ending::stopped)
        tests::cutFrames(made.frames, made.frames.size() * 2 / 3, core::CommandKind::end);
    if (wanted == Ending::nothing)
        tests::cutFrames(made.frames, 40, core::CommandKind::end);
    if (wanted == Ending::timedOut) // an operator on a sphere marks before its time is up
        for (auto& frame : made.frames)
            if ((frame.header.events & core::event_bits::kMarked) != 0)
                frame.header.events =
                    (frame.header.events & ~core::event_bits::kMarked) | core::event_bits::kTimedOut;
    made.ending.stopped = wanted == Ending::stopped || wanted == Ending::nothing;
    const database::SessionId session = tests::store(m_site->database(), *m_tina, made);
    if (wanted == Ending::unmarked)
        isUnmarked(session);
    // One language a row, by turns; all of them where all levels are walked.
    QStringList languages;
    for (const char* language : tests::languageIds())
        languages << QLatin1String(language);
    if (qEnvironmentVariableIntValue("CHIRON_EVERY_LEVEL") == 0)
        languages = {languages[m_row++ % languages.size()]};
    for (const QString& language : languages) {
        m_site->settings.setLanguage(language);
        m_site->context.applyAppearance();
        debrief(session, id, wanted, language);
        playback(session, id, wanted, language);
        results(id, level, language);
        paper(session, id, wanted, language);
        if (QTest::currentTestFailed())
            break;
    }
    m_site->settings.setLanguage(QStringLiteral("en"));
    m_site->context.applyAppearance();
    tests::takePictures(
        *m_site,
        QStringLiteral("debrief_%1")
            .arg(QString::fromUtf8(QTest::currentDataTag()).replace(QLatin1Char(' '), QLatin1Char('_'))),
        [&] {
            m_site->go(QStringLiteral("debrief"), {{QStringLiteral("session"), qlonglong(session)}});
            QTRY_VERIFY_WITH_TIMEOUT(tests::isLoaded(*m_site), kPatience_ms);
            m_site->window->resize(1280, 1500);
            QTest::qWait(600);
        });
    tests::takePictures(
        *m_site,
        QStringLiteral("playback_%1")
            .arg(QString::fromUtf8(QTest::currentDataTag()).replace(QLatin1Char(' '), QLatin1Char('_'))),
        [&] {
            m_site->go(QStringLiteral("playback"), {{QStringLiteral("session"), qlonglong(session)}});
            QTRY_VERIFY_WITH_TIMEOUT(tests::isLoaded(*m_site), kPatience_ms);
        });
}

void TestEveryDebrief::debrief(database::SessionId id, const std::string& exercise, Ending ending,
                               const QString& language) {
    m_site->go(QStringLiteral("debrief"), {{QStringLiteral("session"), qlonglong(id)}});
    QTRY_VERIFY_WITH_TIMEOUT(tests::isLoaded(*m_site), kPatience_ms);
    // The felt line is there as soon as the recording was looked through.
    QTRY_VERIFY_WITH_TIMEOUT(!screen()->findChild<QLabel*>(QStringLiteral("debrief.felt"))->text().isEmpty(),
                             kPatience_ms);
    const QStringList texts = readable(screen());
    const QStringList foreign = foreignWords(texts, exercise, language);
    QVERIFY2(foreign.isEmpty(), qPrintable(foreign.join(QLatin1Char('\n'))));
    if (ending != Ending::nothing) // of what was not begun there is little to say
        QVERIFY2(hasOwnWord(texts, exercise, language), qPrintable(texts.join(QLatin1Char('|'))));
    for (const auto& [other, own] : owners())
        for (const QString& plot : own.plots)
            QCOMPARE(screen()->findChild<QWidget*>(plot) != nullptr,
                     other == exercise && hasPlots(exercise, ending));
    if (const QString late = owners().at(exercise).lateInDebrief.translated(); !late.isEmpty())
        QVERIFY2(
            isSaid(texts, late) == isLate(ending),
            qPrintable(late + QStringLiteral(": ") + texts.mid(texts.size() - 12).join(QLatin1Char('|'))));
    // What did not come to its end has no verdict: neither a card nor a mark that was met or not.
    const bool judged = ending == Ending::completed || isLate(ending);
    QCOMPARE(!screen()->findChildren<QLabel*>(QStringLiteral("headline.verdict")).isEmpty(), judged);
    if (const auto* table = screen()->findChild<QTableWidget*>(QStringLiteral("debrief.metrics")))
        for (int row = 0; row < table->rowCount(); ++row)
            QVERIFY(judged || table->item(row, 4)->text().isEmpty());
}

void TestEveryDebrief::playback(database::SessionId id, const std::string& exercise, Ending ending,
                                const QString& language) {
    m_site->go(QStringLiteral("playback"), {{QStringLiteral("session"), qlonglong(id)}});
    QTRY_VERIFY_WITH_TIMEOUT(tests::isLoaded(*m_site), kPatience_ms);
    const QStringList texts = readable(screen());
    const QStringList foreign = foreignWords(texts, exercise, language);
    QVERIFY2(foreign.isEmpty(), qPrintable(foreign.join(QLatin1Char('\n'))));
    const QString unnamed = QCoreApplication::translate("PlaybackMarks", "The next stage begins");
    QVERIFY2(texts.filter(unnamed).isEmpty(), "a stage began, and the events do not say which");
    QVERIFY2(isSaid(texts, owners().at(exercise).lateInPlayback.translated()) == isLate(ending),
             qPrintable(texts.join(QLatin1Char('|'))));
}

void TestEveryDebrief::results(const std::string& exercise, int level, const QString& language) {
    m_site->go(QStringLiteral("results"), {{QStringLiteral("exercise"), QString::fromStdString(exercise)},
                                           {QStringLiteral("level"), level}});
    QTRY_VERIFY_WITH_TIMEOUT(tests::isLoaded(*m_site), kPatience_ms);
    const QStringList foreign = foreignWords(readable(screen()), exercise, language);
    QVERIFY2(foreign.isEmpty(), qPrintable(foreign.join(QLatin1Char('\n'))));
}

report::ReportData TestEveryDebrief::reportOf(database::SessionId id, const std::string& exercise,
                                              const QString& language) {
    auto connection = m_site->database().openReader();
    auto data = desktop::loadReport(**connection, *m_tina, id, language.toStdString());
    if (!data)
        qFatal("%s", data.error().message.c_str());
    desktop::translateReport(*data,
                             {QStringLiteral("Tina"),
                              desktop::exerciseTitle(m_site->context.site().catalogue(), exercise, language),
                              QStringLiteral("device")});
    return *data;
}

QString TestEveryDebrief::print(const report::ReportData& data, const QString& name) {
    const QString pictures = qEnvironmentVariable("CHIRON_PICTURES");
    const QString pdf =
        QDir(pictures.isEmpty() ? m_site->folder() : pictures).filePath(name + QStringLiteral(".pdf"));
    const auto written = report::writeSessionPdf(pdf, data, report::lightTheme(m_site->context.locale()));
    if (!written)
        qFatal("%s", written.error().message.c_str());
    return pdf;
}

void TestEveryDebrief::paper(database::SessionId id, const std::string& exercise, Ending ending,
                             const QString& language) {
    const QString name =
        QStringLiteral("report_%1_%2")
            .arg(QString::fromUtf8(QTest::currentDataTag()).replace(QLatin1Char(' '), QLatin1Char('_')),
                 language);
    const report::ReportData data = reportOf(id, exercise, language);
    const QString pdf = print(data, name);
    const QStringList lines = tests::pdfLines(pdf);
    const QStringList foreign = foreignWords(lines, exercise, language);
    QVERIFY2(foreign.isEmpty(), qPrintable(foreign.join(QLatin1Char('\n'))));
    // Whoever copies from it gets the text that is seen: all of a real report, in every language.
    tests::PaintedPages pages;
    QVERIFY(report::paintSession(pages, data, report::lightTheme(m_site->context.locale())));
    QVERIFY(tests::wordsIn(pages.shapes()).size() > 20);
    const QStringList lost = tests::notCopied(pages.shapes(), pdf);
    QVERIFY2(lost.isEmpty(), qPrintable(lost.join(QLatin1Char('\n'))));
    if (ending != Ending::nothing)
        QVERIFY2(hasOwnWord(lines, exercise, language), qPrintable(lines.join(QLatin1Char('|'))));
    if (!hasPlots(exercise, ending))
        return;
    const QString drawn = tests::pdfText(pdf, tests::PdfOrder::drawn).simplified();
    QVERIFY(!owners().at(exercise).paper.empty());
    for (const Said& title : owners().at(exercise).paper)
        QVERIFY2(drawn.contains(title.translated()),
                 qPrintable(title.translated() + QStringLiteral(" in: ") + drawn));
}

/// It is complete, and yet nobody marked, found, took hold of or saw anything.
void TestEveryDebrief::isUnmarked(database::SessionId id) {
    using namespace session::mark_kinds;
    auto connection = m_site->database().openReader();
    const auto view = session::SessionView::open(**connection, *m_tina, id);
    QVERIFY2(view, view ? "" : view.error().message.c_str());
    QVERIFY((*view)->record().summary.state == database::SessionState::completed);
    const auto track = (*view)->track();
    QVERIFY2(track, track ? "" : track.error().message.c_str());
    const auto has = [&](const session::PlaybackMarkKind& kind) {
        return std::any_of((*track)->marks.begin(), (*track)->marks.end(),
                           [&kind](const session::PlaybackMark& mark) { return mark.kind == kind; });
    };
    QVERIFY(has(kTimedOut));
    for (const session::PlaybackMarkKind& kind :
         {kMarked, kFound, kFalseAlarm, kTakenBack, kGrasped, kLandmarkSeen, kCompleted, kFailed, kYielded})
        QVERIFY2(!has(kind), std::string(kind.id).c_str());
}

// What a page marks is what the score counts: of a hand that breaks tissue, and of one that does not.
void TestEveryDebrief::paperMarksTheCriticalErrorsOfTheScore() {
    for (const char* name : {"unsafe", "expert"}) {
        const MadeSession made = scripted("urethra_insertion", 3, 30.0, name);
        const database::SessionId id = tests::store(m_site->database(), *m_tina, made);
        const report::ReportData data = reportOf(id, "urethra_insertion", QStringLiteral("en"));
        const auto counted = std::find_if(data.metrics.begin(), data.metrics.end(), [](const auto& row) {
            return row.id == QLatin1String("critical_errors");
        });
        QVERIFY(counted != data.metrics.end() && counted->value);
        QCOMPARE(static_cast<double>(data.series.criticalErrors.size()), *counted->value);
        QCOMPARE(*counted->value > 0.0,
                 QLatin1String(name) == QLatin1String("unsafe")); // or the test has nothing to show
        for (const report::CriticalError& error : data.series.criticalErrors)
            QVERIFY(!error.words.isEmpty() && !error.words.startsWith(QStringLiteral("Critical error")));
        const bool marked =
            report::forcePlot(data.series, data.forceLimit_N, report::lightTheme(QLocale::c()))
                ->legendTexts()
                .contains(QStringLiteral("critical error"));
        QCOMPARE(marked, *counted->value > 0.0);
        const QString pdf = print(data, QStringLiteral("critical_%1").arg(QLatin1String(name)));
        QCOMPARE(isSaid(tests::pdfLines(pdf), QStringLiteral("What happened")), *counted->value > 0.0);
    }
}

void TestEveryDebrief::paperHasEveryTool() {
    const MadeSession made = scripted("elastic_tube", 6, 25.0);
    const database::SessionId id = tests::store(m_site->database(), *m_tina, made);
    m_site->settings.setLanguage(QStringLiteral("de"));
    m_site->context.applyAppearance();
    const report::ReportData data = reportOf(id, "elastic_tube", QStringLiteral("de"));
    print(data, QStringLiteral("tools_de"));
    const QStringList names{QStringLiteral("Rechtes Instrument"), QStringLiteral("Linkes Instrument"),
                            QStringLiteral("Instrument 3")};
    QCOMPARE(data.series.tools.size(), std::size_t{3});
    const report::PlotTheme theme = report::lightTheme(QLocale(QLocale::German));
    std::vector<std::unique_ptr<report::PlotView>> plots = report::positionPlots(data.series, theme);
    QCOMPARE(plots.size(), std::size_t{3});
    plots.push_back(report::forcePlot(data.series, data.forceLimit_N, theme));
    plots.push_back(report::feltForcePlot(data.series, data.forceLimit_N, theme));
    plots.push_back(report::speedPlot(data.series, theme));
    for (const auto& plot : plots) {
        QVERIFY(plot);
        for (const QString& name : names)
            QVERIFY2(plot->legendTexts().contains(name),
                     qPrintable(plot->legendTexts().join(QLatin1Char('|'))));
    }
    QVERIFY(data.series.tools[0].tissue_N !=
            data.series.tools[2].tissue_N); // the two hands pull on one tube with one force
    QVERIFY(data.series.tools[0].x_mm != data.series.tools[1].x_mm &&
            data.series.tools[1].x_mm != data.series.tools[2].x_mm);
    m_site->settings.setLanguage(QStringLiteral("en"));
    m_site->context.applyAppearance();
}

QTEST_MAIN(TestEveryDebrief)
#include "test_every_debrief.moc"
