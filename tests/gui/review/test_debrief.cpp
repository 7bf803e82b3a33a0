// SPDX-License-Identifier: GPL-3.0-or-later
// What a debrief says of a session that passed, failed, or did not come to its end.
#include "database/repositories/score_repository.h"
#include "database/repositories/session_repository.h"
#include "desktop/debrief/band_bar.h"
#include "desktop/debrief/debrief_screen.h"
#include "desktop/debrief/verdict.h"
#include "report/plot_view.h"
#include "review_sessions.h"
#include "session_report/metric_words.h"
#include "support/patience.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>

using chiron::tests::kPatience_ms;

using namespace chiron;
using tests::DesktopFixture;
using tests::MadeSession;

class TestDebrief : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void passed();
    void failedSaysWhichMarkAndByHowMuch();
    void everyMissedMarkHasAdvice();
    void aLowerLevelToPractiseOnIsOffered();
    void aCauseIsToldBeforeWhatItLeadsTo();
    void whatChangedSinceTheLastAttempt();
    void afterADemonstrationItIsOnesOwnTurn();
    void worstMomentIsOneClickAway();
    void aTrainersCommentArrives();
    void unfinished_data();
    void unfinished();
    void familiarisationNeverCounts();
    void voidedGivesTheReason();
    void countedAgainTellsBothDecisions();
    void shownIsSaidAndHasNoFeltBand();
    void erasedRecordingKeepsTheScores();
    void notMine();
    void metricsSayWhatTheyMean();
    void writesTheReport();
    void unknownSession();
    void nothingClippedOrUnnamed();

private:
    void open(database::SessionId id, bool details = true);
    QString text(const char* name) { return m_site->find<QLabel>(QLatin1String(name))->text(); }
    QStringList texts(const char* name) {
        QStringList found;
        for (const QLabel* label : m_site->window->screen()->findChildren<QLabel*>(QLatin1String(name)))
            found << label->text();
        return found;
    }

    std::unique_ptr<DesktopFixture> m_site;
    std::unique_ptr<tests::ReviewSessions> m_made;
    std::optional<database::Actor> m_tina;
    database::SessionId m_good = 0;
    database::SessionId m_bad = 0;
};

void TestDebrief::initTestCase() {
    m_site = std::make_unique<DesktopFixture>();
    m_made = std::make_unique<tests::ReviewSessions>(m_site->database());
    m_tina = m_site->actor("tina");
    m_good = tests::store(m_site->database(), *m_tina, m_made->good);
    m_bad = tests::store(m_site->database(), *m_tina, m_made->bad);
    m_site->context.logIn(*m_tina);
}

void TestDebrief::open(database::SessionId id, bool details) {
    m_site->go(QStringLiteral("debrief"), {{QStringLiteral("session"), qlonglong(id)}});
    QTRY_VERIFY_WITH_TIMEOUT(tests::isLoaded(*m_site), kPatience_ms);
    if (details)
        QTRY_VERIFY_WITH_TIMEOUT(
            m_site->window->screen()->findChild<QWidget*>(QStringLiteral("debrief.scatter")), kPatience_ms);
}

void TestDebrief::passed() {
    open(m_good);
    QCOMPARE(text("debrief.verdict"), QStringLiteral("Passed"));
    QVERIFY(texts("debrief.reason").isEmpty());
    QVERIFY(m_site->find<QPushButton>(QStringLiteral("debrief.next")));
    QCOMPARE(m_site->window->screen()->findChildren<desktop::BandBar*>().size(), 3);
    for (const QString& verdict : texts("headline.verdict"))
        QVERIFY2(verdict.startsWith(QStringLiteral("Met")), qPrintable(verdict));
    QVERIFY(text("debrief.facts").contains(QStringLiteral("Force felt")));
    tests::takePictures(*m_site, QStringLiteral("debrief_passed"), [this] { open(m_good); });
}

void TestDebrief::failedSaysWhichMarkAndByHowMuch() {
    open(m_bad);
    QCOMPARE(text("debrief.verdict"), QStringLiteral("Not passed yet"));
    const QStringList reasons = texts("debrief.reason");
    QVERIFY(!reasons.isEmpty());
    auto connection = m_site->database().openReader();
    const auto card = database::ScoreRepository(**connection, *m_tina).scores(m_bad);
    double broken = 0.0; // the pass mark is none
    for (const scoring::MetricValue& metric : card->metrics)
        if (metric.id == "critical_errors")
            broken = *metric.value;
    QVERIFY(broken > 0.0);
    const QString by = QStringLiteral("Critical errors: %1, but").arg(broken, 0, 'f', 0);
    QVERIFY2(reasons.join(QLatin1Char('|')).contains(by), qPrintable(reasons.join(QLatin1Char('|')) + by));
    QVERIFY(!m_site->find<QPushButton>(QStringLiteral("debrief.next")));
    QVERIFY(m_site->find<QPushButton>(QStringLiteral("debrief.again")));
    tests::takePictures(*m_site, QStringLiteral("debrief_failed"), [this] { open(m_bad); });
}

void TestDebrief::everyMissedMarkHasAdvice() {
    open(m_bad);
    const QStringList reasons = texts("debrief.reason"), advice = texts("debrief.advice");
    QCOMPARE(advice.size(), reasons.size());
    const catalogue::Exercise* exercise = m_site->site.catalogue().find("sphere_apex");
    QVERIFY(exercise);
    const auto card = [&] {
        auto connection = m_site->database().openReader();
        return *database::ScoreRepository(**connection, *m_tina).scores(m_bad);
    }();
    QStringList expected;
    for (const catalogue::Advice& one : exercise->advice)
        for (const scoring::MetricValue& metric : card.metrics)
            if (metric.id == one.metric && metric.passed == std::optional<bool>(false)) {
                QVERIFY2(reasons[expected.size()].startsWith(
                             QStringLiteral("•  ") +
                             session_report::metricTitle(QString::fromStdString(metric.id))),
                         qPrintable(reasons.join(QLatin1Char('|'))));
                expected << QString::fromStdString(one.text.at("en"));
            }
    QCOMPARE(advice.size(), expected.size());
    for (qsizetype i = 0; i < advice.size();
         ++i) { // each beside its own mark, after what the recording shows
        QVERIFY2(advice[i].endsWith(QLatin1Char(' ') + expected[i]), qPrintable(advice[i]));
        QVERIFY2(advice[i].contains(QStringLiteral("in trial ")), qPrintable(advice[i]));
        QVERIFY2(!advice[i].contains(QLatin1Char('{')), qPrintable(advice[i]));
    }
    open(m_good);
    QVERIFY(texts("debrief.advice").isEmpty());
}

// The level below trains the same metrics; whoever looks at somebody else's session cannot go there.
void TestDebrief::aLowerLevelToPractiseOnIsOffered() {
    const auto offers = [&] {
        QStringList words;
        for (const QPushButton* button :
             m_site->window->screen()->findChildren<QPushButton*>(QStringLiteral("debrief.practise")))
            words << button->text();
        return words;
    };
    open(m_bad);
    const int level = m_made->bad.setup.level.number;
    QCOMPARE(level, 2);
    QCOMPARE(offers(), QStringList{QStringLiteral("Practise it on level 1")}); // once for all
    auto* practise = m_site->find<QPushButton>(QStringLiteral("debrief.practise"));
    QCOMPARE(practise->toolTip(), QStringLiteral("Visible sphere"));
    practise->click();
    const desktop::Place place = m_site->context.navigator().current();
    QCOMPARE(place.screen, QStringLiteral("exercise_setup"));
    QCOMPARE(place.parameters.value(QStringLiteral("exercise")).toString(), QStringLiteral("sphere_apex"));
    QCOMPARE(place.parameters.value(QStringLiteral("level")).toInt(), 1);
    open(m_good);
    QCOMPARE(offers(), QStringList());
    m_site->logIn("tom");
    open(m_bad);
    QCOMPARE(offers(), QStringList());
    m_site->context.logIn(*m_tina);
}

// A miss counts as a large error: who marked in the air is told so before they read of the error. What has no
// advice comes last.
void TestDebrief::aCauseIsToldBeforeWhatItLeadsTo() {
    desktop::DebriefHead head;
    head.record.summary.state = database::SessionState::completed;
    head.report.passed = false;
    for (const auto& [id, met] : {std::pair{"time", false},
                                  {"apex_error_mean", false},
                                  {"path_length", true},
                                  {"apex_misses", false}}) {
        report::MetricRow row;
        row.id = QLatin1String(id);
        row.value = 2.0;
        row.gateMaximum = met ? 3.0 : 1.0;
        row.passed = met;
        head.report.metrics.push_back(row);
    }
    std::vector<desktop::MetricAdvice> advice;
    for (const catalogue::Advice& one : m_site->site.catalogue().find("sphere_apex")->advice)
        advice.push_back({one.metric, QString::fromStdString(one.text.at("en"))});
    const desktop::Verdict verdict = desktop::verdictOf(head, QLocale(QLocale::English), advice);
    QCOMPARE(verdict.reasons.size(), 3);
    const QStringList order{QStringLiteral("apex_misses"), QStringLiteral("apex_error_mean"),
                            QStringLiteral("time")};
    for (qsizetype i = 0; i < order.size(); ++i)
        QVERIFY2(verdict.reasons[i].startsWith(session_report::metricTitle(order[i])),
                 qPrintable(verdict.reasons.join(QLatin1Char('|'))));
    QCOMPARE(verdict.advice.size(), std::size_t(3));
    for (std::size_t i = 0; i < 3; ++i)
        QCOMPARE(QString::fromStdString(verdict.advice[i].metric), order[static_cast<qsizetype>(i)]);
    QVERIFY(verdict.advice[0].text.startsWith(QStringLiteral("Before you mark")));
    QVERIFY(verdict.advice[1].text.startsWith(QStringLiteral("Move over the top")));
    QVERIFY(verdict.advice[2].text.isEmpty());
}

void TestDebrief::whatChangedSinceTheLastAttempt() {
    open(m_good);
    QVERIFY(texts("debrief.change").isEmpty()); // the first attempt
    open(m_bad);
    const QString change = texts("debrief.change").value(0);
    QVERIFY2(change.startsWith(QStringLiteral("Since your last attempt:")) &&
                 change.contains(QStringLiteral("Critical errors 0 → ")),
             qPrintable(change));
    QVERIFY(change.count(QStringLiteral(" → ")) <= 3);
    // Shown force is another series: what was felt before is no attempt before it.
    const auto shown = tests::store(m_site->database(), *m_tina, tests::ReviewSessions::shown(m_made->bad));
    open(shown);
    QVERIFY(texts("debrief.change").isEmpty());
}

void TestDebrief::afterADemonstrationItIsOnesOwnTurn() {
    MadeSession made = m_made->good;
    made.operatorName = "expert";
    (void)tests::store(m_site->database(), database::Actor::simulated(), made);
    const auto id = tests::store(m_site->database(), database::Actor::simulated(), made);
    open(id);
    QVERIFY(texts("debrief.change").isEmpty()); // a script's earlier demonstration is nobody's last attempt
    auto* now = m_site->find<QPushButton>(QStringLiteral("debrief.now_you"));
    QVERIFY(now && now->isEnabled());
    QVERIFY(!m_site->window->screen()->findChild<QPushButton*>(QStringLiteral("debrief.again")));
    now->click();
    QCOMPARE(m_site->context.navigator().current().screen, QStringLiteral("exercise_setup"));
    QCOMPARE(m_site->context.navigator().current().parameters.value(QStringLiteral("level")).toInt(),
             m_made->good.setup.level.number);
    open(m_bad); // and who failed is offered to watch
    QVERIFY(!m_site->window->screen()->findChild<QPushButton*>(QStringLiteral("debrief.now_you")));
    auto* watch = m_site->window->screen()->findChild<QPushButton*>(QStringLiteral("debrief.watch"));
    QVERIFY(watch);
    open(m_good);
    QVERIFY(!m_site->window->screen()->findChild<QPushButton*>(QStringLiteral("debrief.watch")));
}

void TestDebrief::worstMomentIsOneClickAway() {
    open(m_bad);
    const QString where = text("debrief.worst_text");
    QVERIFY2(where.startsWith(QStringLiteral("Worst moment: ")) &&
                 where.contains(QStringLiteral("in trial")) &&
                 where.endsWith(QStringLiteral(" after it began")),
             qPrintable(where));
    auto* worst = m_site->find<QPushButton>(QStringLiteral("debrief.worst"));
    QVERIFY(worst->isEnabled());
    QVERIFY2(worst->toolTip().contains(QStringLiteral("in the recording")), qPrintable(worst->toolTip()));
    worst->click();
    const desktop::Place place = m_site->context.navigator().current();
    QCOMPARE(place.screen, QStringLiteral("playback"));
    QCOMPARE(place.parameters.value(QStringLiteral("session")).toLongLong(), m_bad);
    QCOMPARE(place.parameters.value(QStringLiteral("caption")).toString(), where); // said in the scene there
    const double worst_s = place.parameters.value(QStringLiteral("caption_s")).toDouble();
    QVERIFY(worst_s > 0.0);
    QCOMPARE(place.parameters.value(QStringLiteral("at_s")).toDouble(),
             std::max(0.0, worst_s - 3.0)); // to see how it came about
}

void TestDebrief::aTrainersCommentArrives() {
    const auto id = tests::store(m_site->database(), *m_tina, m_made->good);
    const auto comment = [&](const database::Actor& author, const char* text,
                             std::optional<std::uint64_t> tick) {
        QVERIFY(m_site->database().write([&](database::WriteContext& write) {
            return database::SessionRepository(write.connection(), author).addComment(id, text, tick);
        }));
    };
    const auto atHome = [&] {
        m_site->go(QStringLiteral("home"));
        if (!QTest::qWaitFor([&] { return m_site->context.background().idle(); }, kPatience_ms))
            qFatal("the home screen is not read");
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        return m_site->window->screen()->findChild<QWidget*>(QStringLiteral("home.commented.%1").arg(id));
    };
    comment(*m_tina, "note to myself", {});
    QVERIFY(!atHome()); // one's own is no news
    comment(m_site->actor("tom"), "Go round the top once more.", 1500);
    comment(m_site->actor("tom"), "Good start.", {});
    const auto badge = [&] { return m_site->find<QPushButton>(QStringLiteral("nav.home"))->text(); };
    QCOMPARE(badge(), QStringLiteral("Home"));
    QWidget* notice = atHome();
    QVERIFY(notice);
    QCOMPARE(badge(), QStringLiteral("Home (1)"));
    QStringList words;
    for (const QLabel* label : notice->findChildren<QLabel*>())
        words << label->text();
    QVERIFY2(words.join(QLatin1Char('|'))
                 .contains(QStringLiteral("Tom Trainer commented on your session %1").arg(id)),
             qPrintable(words.join(QLatin1Char('|'))));
    notice->findChild<QPushButton*>()->click();
    QCOMPARE(m_site->context.navigator().current().screen, QStringLiteral("debrief"));
    open(id);
    const QStringList comments = texts("debrief.comment");
    QCOMPARE(comments.size(), 3);
    QCOMPARE(badge(), QStringLiteral("Home")); // read
    QVERIFY(comments.contains(QStringLiteral("Tom Trainer: Good start.")));
    QVERIFY2(comments.last().startsWith(QStringLiteral("Tom Trainer · ")) &&
                 comments.last().contains(QStringLiteral(" before the start: ")) &&
                 comments.last().endsWith(QStringLiteral(": Go round the top once more.")),
             qPrintable(comments.last()));
    auto* watch = m_site->window->screen()->findChild<QPushButton*>(QStringLiteral("debrief.comment_watch"));
    QVERIFY(watch);
    auto* reply = m_site->window->screen()->findChild<QPushButton*>(QStringLiteral("debrief.comment_reply"));
    QVERIFY(reply);
    reply->click();
    QCOMPARE(m_site->context.navigator().current().screen, QStringLiteral("playback"));
    m_site->context.navigator().back();
    open(id);
    watch = m_site->window->screen()->findChild<QPushButton*>(QStringLiteral("debrief.comment_watch"));
    QVERIFY(watch);
    watch->click();
    const desktop::Place place = m_site->context.navigator().current();
    QCOMPARE(place.screen, QStringLiteral("playback"));
    const double moment_s = place.parameters.value(QStringLiteral("caption_s")).toDouble();
    QVERIFY(moment_s > 1.0);
    QCOMPARE(place.parameters.value(QStringLiteral("at_s")).toDouble(),
             std::max(0.0, moment_s - 3.0)); // how it came about
    QCOMPARE(place.parameters.value(QStringLiteral("caption")).toString(), comments.last());
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QTabWidget>(QStringLiteral("playback.tabs")), kPatience_ms);
    auto* tabs = m_site->find<QTabWidget>(QStringLiteral("playback.tabs"));
    QVERIFY(tabs->tabText(tabs->currentIndex()).startsWith(QStringLiteral("Comments")));
    QVERIFY(!atHome()); // it was read
    comment(m_site->actor("tom"), "And press less.", {});
    QVERIFY(atHome()); // the next one is news again
    open(id);
    comment(*m_tina, "I will.", {});
    QVERIFY(!atHome()); // one's own answer is none
    const database::Actor tom = m_site->actor("tom");
    m_site->context.logIn(tom);
    QWidget* answered = atHome(); // but to whoever wrote before it
    QVERIFY(answered);
    QStringList told;
    for (const QLabel* label : answered->findChildren<QLabel*>())
        told << label->text();
    QVERIFY2(
        told.join(QLatin1Char('|')).contains(QStringLiteral("answered your comment on session %1").arg(id)),
        qPrintable(told.join(QLatin1Char('|'))));
    QCOMPARE(badge(), QStringLiteral("Home (1)"));
    open(id);
    QVERIFY(!atHome());
    QCOMPARE(badge(), QStringLiteral("Home"));
    m_site->context.logIn(*m_tina);
}

void TestDebrief::unfinished_data() {
    QTest::addColumn<int>("state");
    QTest::addColumn<QString>("title");
    using database::SessionState;
    QTest::newRow("stopped") << static_cast<int>(SessionState::stopped) << "Stopped before the end";
    QTest::newRow("interrupted") << static_cast<int>(SessionState::interrupted) << "Interrupted";
    QTest::newRow("incomplete") << static_cast<int>(SessionState::incomplete) << "Incomplete recording";
    QTest::newRow("faulted") << static_cast<int>(SessionState::faulted) << "Ended by a fault";
}

void TestDebrief::unfinished() {
    QFETCH(int, state);
    QFETCH(QString, title);
    const auto wanted = static_cast<database::SessionState>(state);
    MadeSession made = m_made->good;
    if (wanted == database::SessionState::incomplete)
        made.ending.dropped = 3;
    else
        tests::cutFrames(made.frames, made.frames.size() / 2);
    made.ending.stopped = wanted == database::SessionState::stopped;
    made.ending.interrupted = wanted == database::SessionState::interrupted;
    if (wanted == database::SessionState::faulted)
        made.frames.back().header.force = core::ForceState::fault;
    const auto id = tests::store(m_site->database(), *m_tina, made);
    open(id);
    QCOMPARE(text("debrief.verdict"), title);
    QVERIFY(text("debrief.verdict_text").contains(QStringLiteral("kept")) ||
            text("debrief.verdict_text").contains(QStringLiteral("saved")));
    QVERIFY(!m_site->find<QPushButton>(QStringLiteral("debrief.next")));
    QVERIFY(m_site->find<QPushButton>(QStringLiteral("debrief.playback"))->isEnabled());
    if (wanted == database::SessionState::interrupted)
        tests::takePictures(*m_site, QStringLiteral("debrief_interrupted"), [this, id] { open(id); });
}

void TestDebrief::familiarisationNeverCounts() {
    MadeSession made = m_made->good;
    made.familiarisation = true;
    open(tests::store(m_site->database(), *m_tina, made));
    QVERIFY(text("debrief.verdict_text").startsWith(QStringLiteral("Familiarisation")));
}

void TestDebrief::voidedGivesTheReason() {
    const auto id = tests::store(m_site->database(), *m_tina, m_made->good);
    const auto tom = m_site->actor("tom");
    const auto voided = m_site->database().write([&](database::WriteContext& write) {
        return database::SessionRepository(write.connection(), tom).voidSession(id, "the table shook");
    });
    QVERIFY(voided);
    open(id);
    QCOMPARE(text("debrief.verdict"), QStringLiteral("Voided"));
    QVERIFY(text("debrief.verdict_text").contains(QStringLiteral("the table shook")));
    QVERIFY(!m_site->find<QPushButton>(QStringLiteral("debrief.next")));
}

void TestDebrief::countedAgainTellsBothDecisions() {
    const auto id = tests::store(m_site->database(), *m_tina, m_made->good);
    const auto tom = m_site->actor("tom");
    const auto decided = m_site->database().write([&](database::WriteContext& write) {
        database::SessionRepository sessions(write.connection(), tom);
        auto done = sessions.voidSession(id, "the table shook");
        return done ? sessions.reinstateSession(id, "it was another table") : done;
    });
    QVERIFY(decided);
    open(id);
    QCOMPARE(text("debrief.verdict"), QStringLiteral("Passed")); // as if nothing had been
    const QStringList told = texts("debrief.decision");
    QCOMPARE(told.size(), 2);
    QVERIFY2(told.first().contains(QStringLiteral("Voided")) &&
                 told.first().endsWith(QStringLiteral("Tom Trainer: the table shook")),
             qPrintable(told.first()));
    QVERIFY2(told.last().contains(QStringLiteral("Set to count again")) &&
                 told.last().endsWith(QStringLiteral("it was another table")),
             qPrintable(told.last()));
    open(m_good);
    QVERIFY(texts("debrief.decision").isEmpty());
}

void TestDebrief::shownIsSaidAndHasNoFeltBand() {
    open(m_good);
    auto* table = m_site->find<QTableWidget>(QStringLiteral("debrief.metrics"));
    QVERIFY(!table->item(0, 3)->text().isEmpty()); // the published band, of people who felt the force
    open(tests::store(m_site->database(), *m_tina, tests::ReviewSessions::shown(m_made->good)));
    QVERIFY(text("debrief.facts").contains(QStringLiteral("Force shown, not felt")));
    table = m_site->find<QTableWidget>(QStringLiteral("debrief.metrics"));
    QCOMPARE(table->item(0, 3)->text(), QString());
}

void TestDebrief::erasedRecordingKeepsTheScores() {
    const auto theo = m_site->actor("theo");
    const auto id = tests::store(m_site->database(), theo, m_made->good);
    const auto tom = m_site->actor("tom");
    QVERIFY(m_site->database().write([&](database::WriteContext& write) {
        return database::SessionRepository(write.connection(), tom).addComment(id, "Well held.", {});
    }));
    const auto ada = m_site->actor("ada");
    auto erased = database::AccountService(m_site->database())
                      .erasePerson(ada, tests::kTestPassword, theo.personId(), "withdrew", true);
    QVERIFY2(erased, erased ? "" : erased.error().message.c_str());
    m_site->context.logIn(ada);
    open(id, false);
    QCOMPARE(text("debrief.verdict"), QStringLiteral("Passed"));
    QVERIFY(!m_site->find<QPushButton>(QStringLiteral("debrief.playback"))->isEnabled());
    bool said = false;
    for (const QString& title : texts("state.title"))
        said = said || title == QStringLiteral("The recording was erased");
    QVERIFY(said);
    QCOMPARE(texts("debrief.comment").size(), 1); // that there was one is still told
    m_site->context.logIn(*m_tina);
}

void TestDebrief::notMine() {
    m_site->logIn("tom");
    open(m_bad);
    QVERIFY2(texts("debrief.change").value(0).startsWith(QStringLiteral("Since the previous attempt: ")),
             qPrintable(texts("debrief.change").value(0)));
    open(m_good);
    QVERIFY(!m_site->find<QPushButton>(QStringLiteral("debrief.again")));
    QVERIFY(m_site->find<QPushButton>(QStringLiteral("debrief.playback")));
    m_site->context.logIn(*m_tina);
}

void TestDebrief::metricsSayWhatTheyMean() {
    open(m_good);
    auto* table = m_site->find<QTableWidget>(QStringLiteral("debrief.metrics"));
    QCOMPARE(table->rowCount(), 17);
    for (int row = 0; row < table->rowCount(); ++row) {
        QVERIFY2(!table->item(row, 0)->data(Qt::AccessibleDescriptionRole).toString().isEmpty(),
                 qPrintable(table->item(row, 0)->text()));
        QVERIFY(table->rowHeight(row) > 2 * table->fontMetrics().height()); // title and meaning
    }
    QVERIFY(table->horizontalHeader()->height() + table->rowViewportPosition(table->rowCount() - 1) +
                table->rowHeight(table->rowCount() - 1) <=
            table->height());
    for (int column = 0; column < table->columnCount(); ++column) { // nothing but headings is no column
        bool empty = true;
        for (int row = 0; row < table->rowCount(); ++row)
            empty = empty && table->item(row, column)->text().isEmpty();
        QCOMPARE(table->isColumnHidden(column), empty);
    }
}

void TestDebrief::writesTheReport() {
    open(m_good);
    const QString path = QDir(m_site->folder()).filePath(QStringLiteral("report.pdf"));
    m_site->screen<desktop::DebriefScreen>()->writeReport(path);
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path), kPatience_ms);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.read(4) == "%PDF");
}

void TestDebrief::unknownSession() {
    m_site->go(QStringLiteral("debrief"), {{QStringLiteral("session"), qlonglong(9999)}});
    QTRY_COMPARE_WITH_TIMEOUT(tests::panelOf(*m_site)->state(), desktop::StatePanel::State::error,
                              kPatience_ms);
    QVERIFY(!texts("state.text").isEmpty());
}

void TestDebrief::nothingClippedOrUnnamed() {
    const QStringList findings = tests::findingsOn(*m_site, [this] { open(m_bad); });
    QVERIFY2(findings.isEmpty(), qPrintable(findings.join(QLatin1Char('\n'))));
}

QTEST_MAIN(TestDebrief)
#include "test_debrief.moc"
