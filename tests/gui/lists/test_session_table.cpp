// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/people/people_model.h"
#include "desktop/sessions/people_names.h"
#include "desktop/sessions/plain_cell_delegate.h"
#include "desktop/sessions/session_table_model.h"
#include "desktop/sessions/sessions_csv.h"
#include "gui/lists/many_sessions.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QtTest>
#include <algorithm>

using namespace chiron;
using namespace chiron::desktop;

namespace {

const ExerciseTitles kTitles{{QStringLiteral("sphere_apex"), QStringLiteral("Find the apex")}};

struct Table {
    Theme theme = Theme::load(ThemeName::light, 1.0).value();
    SessionTableModel model{theme, QLocale(QLocale::English, QLocale::UnitedKingdom)};
    QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::QtTest};
};

/// Whether a model says before it changes that it will, as a view needs that keeps its place.
class Announced {
public:
    explicit Announced(QAbstractItemModel& model)
        : m_begun{&model, &QAbstractItemModel::modelAboutToBeReset},
          m_done{&model, &QAbstractItemModel::modelReset},
          m_layoutBegun{&model, &QAbstractItemModel::layoutAboutToBeChanged},
          m_layoutDone{&model, &QAbstractItemModel::layoutChanged} {}
    /// Since it was last asked something changed, and every change was announced.
    bool once() {
        const qsizetype changes = m_done.count() + m_layoutDone.count();
        const bool all = m_begun.count() == m_done.count() && m_layoutBegun.count() == m_layoutDone.count();
        return std::exchange(m_changes, changes) < changes && all;
    }

private:
    QSignalSpy m_begun, m_done, m_layoutBegun, m_layoutDone;
    qsizetype m_changes = 0;
};

/// How many of the rows a plain predicate leaves.
template <class Is> int count(const std::vector<SessionRow>& rows, Is is) {
    return static_cast<int>(std::count_if(rows.begin(), rows.end(), [&](const SessionRow& row) {
        return !row.summary.archived && is(row.summary);
    }));
}

} // namespace

/// The list of sessions: what the filters leave, in which order.
class TestSessionTable : public QObject {
    Q_OBJECT
private slots:
    void eachFilterLeavesItsOwn() {
        const auto rows = tests::madeRows(400, kTitles);
        Table table;
        table.model.setRows(rows);
        const auto shown = [&table](const SessionListFilter& filter) {
            table.model.setFilter(filter);
            return table.model.rowCount();
        };
        SessionListFilter filter;
        QCOMPARE(shown(filter), count(rows, [](const auto&) { return true; }));
        QVERIFY(table.model.rowCount() < 400); // archived ones are out
        filter.archived = true;
        QCOMPARE(shown(filter), 400);
        filter = {};
        filter.person = 4;
        QCOMPARE(shown(filter), count(rows, [](const auto& s) { return s.person == 4; }));
        filter = {};
        filter.exercise = QStringLiteral("other_exercise");
        filter.level = 2;
        QCOMPARE(shown(filter),
                 count(rows, [](const auto& s) { return s.exercise == "other_exercise" && s.level == 2; }));
        filter = {};
        filter.state = database::SessionState::interrupted;
        QCOMPARE(shown(filter),
                 count(rows, [](const auto& s) { return s.state == database::SessionState::interrupted; }));
        QVERIFY(table.model.rowCount() > 0);
        filter = {};
        filter.felt = false;
        QCOMPARE(shown(filter), count(rows, [](const auto& s) { return !s.felt; }));
        filter = {};
        filter.outcome = Outcome::passed;
        QCOMPARE(shown(filter),
                 count(rows, [](const auto& s) { return !s.familiarisation && s.passed.value_or(false); }));
        filter.outcome = Outcome::practice;
        QCOMPARE(shown(filter), count(rows, [](const auto& s) { return s.familiarisation; }));
        filter = {};
        filter.review = ReviewState::reviewed;
        QCOMPARE(shown(filter), count(rows, [](const auto& s) { return s.reviewed; }));
        filter.review = ReviewState::toReview;
        QCOMPARE(shown(filter), 0); // whoever reads these has nothing to do
        filter = {};
        filter.commented = true;
        QCOMPARE(shown(filter), count(rows, [](const auto& s) { return s.comments > 0; }));
        QVERIFY(table.model.rowCount() > 0);
        filter = {};
        filter.text = QStringLiteral("APEX  person3");
        QCOMPARE(shown(filter),
                 count(rows, [](const auto& s) { return s.person == 5 && s.exercise == "sphere_apex"; }));
        filter.text = QStringLiteral("nobody at all");
        QCOMPARE(shown(filter), 0);
    }

    /// The stored name of who is no person is no word of any language.
    void aScriptIsNamedInWords() {
        database::SessionSummary session;
        session.person = database::Actor::kSimulatedPerson;
        session.personName = "simulated";
        QCOMPARE(PeopleNames().of(session), std::string("Scripted hand"));
        session.person = database::Actor::kSimulatedPerson + 1;
        session.personName = "Theo";
        QCOMPARE(PeopleNames().of(session), std::string("Theo"));
    }

    /// What has no level is of none that was chosen, whatever is stored with it.
    void aLevelLeavesStudiesOut() {
        database::SessionSummary session;
        session.id = 3;
        session.level = 1;
        session.exercise = "comparison";
        const SessionRow study = makeSessionRow(session, kTitles);
        SessionListFilter filter;
        QVERIFY(SessionMatcher(filter).matches(study));
        filter.level = 1;
        QVERIFY(!SessionMatcher(filter).matches(study));
        session.exercise = "sphere_apex";
        QVERIFY(SessionMatcher(filter).matches(makeSessionRow(session, kTitles)));
    }

    void daysAreThoseOfThePlace() {
        database::SessionSummary session;
        session.id = 1;
        session.startedUtc = "2026-03-01T23:30:00.000Z";
        session.utcOffset_min = 60; // half past midnight on the second
        const SessionRow east = makeSessionRow(session, kTitles);
        session.startedUtc = "2026-03-02T00:30:00.000Z";
        session.utcOffset_min = -120; // half past ten in the evening of the first
        const SessionRow west = makeSessionRow(session, kTitles);
        SessionListFilter filter;
        filter.from = filter.to = QDate(2026, 3, 2);
        QVERIFY(SessionMatcher(filter).matches(east));
        QVERIFY(!SessionMatcher(filter).matches(west));
        filter.from = filter.to = QDate(2026, 3, 1);
        QVERIFY(!SessionMatcher(filter).matches(east));
        QVERIFY(SessionMatcher(filter).matches(west));
        filter.to = {};
        QVERIFY(SessionMatcher(filter).matches(east));
        session.startedUtc = "broken";
        QVERIFY(!SessionMatcher(filter).matches(makeSessionRow(session, kTitles)));
    }

    void filterTravelsInAPlace() {
        SessionListFilter filter;
        filter.text = QStringLiteral("a b");
        filter.person = 7;
        filter.exercise = QStringLiteral("sphere_apex");
        filter.level = 3;
        filter.state = database::SessionState::faulted;
        filter.felt = false;
        filter.outcome = Outcome::notScored;
        filter.from = QDate(2026, 1, 2);
        filter.to = QDate(2026, 3, 4);
        filter.archived = true;
        filter.review = ReviewState::reviewed;
        filter.commented = true;
        QVERIFY(SessionListFilter::fromMap(filter.toMap()) == filter);
        QVERIFY(SessionListFilter{}.toMap().isEmpty());
        QVERIFY(SessionListFilter::fromMap({{QStringLiteral("state"), QStringLiteral("nonsense")},
                                            {QStringLiteral("level"), QStringLiteral("x")}})
                    .isEmpty());
    }

    void everyColumnSorts() {
        Table table;
        table.model.setRows(tests::madeRows(300, kTitles));
        for (int column = 0; column < SessionTableModel::columns; ++column) {
            table.model.sort(column, Qt::AscendingOrder);
            const database::SessionId first = table.model.at(0).summary.id;
            table.model.sort(column, Qt::DescendingOrder);
            QVERIFY2(table.model.at(0).summary.id != first,
                     qPrintable(table.model.headerData(column, Qt::Horizontal).toString()));
        }
        table.model.sort(SessionTableModel::length, Qt::AscendingOrder);
        for (int row = 1; row < table.model.rowCount(); ++row)
            QVERIFY(table.model.at(row - 1).summary.ticks <= table.model.at(row).summary.ticks);
        std::vector<SessionRow> judged = tests::madeRows(60, kTitles);
        for (std::size_t i = 0; i < judged.size(); ++i) { // of each session as many marks as its level has
            judged[i].summary.gates = static_cast<int>(i % 6);
            judged[i].summary.gatesMet = static_cast<int>(i / 6 % (i % 6 + 1));
        }
        Table byScore;
        byScore.model.setRows(judged);
        byScore.model.sort(SessionTableModel::score, Qt::AscendingOrder);
        const auto share = [&byScore](int row) {
            const database::SessionSummary& of = byScore.model.at(row).summary;
            return static_cast<double>(of.gatesMet) / std::max(1, of.gates);
        };
        for (int row = 1; row < byScore.model.rowCount(); ++row)
            QVERIFY(share(row - 1) <= share(row));
        table.model.sort(SessionTableModel::person, Qt::AscendingOrder); // among equals the newest first
        for (int row = 1; row < table.model.rowCount(); ++row) {
            const SessionRow& a = table.model.at(row - 1);
            const SessionRow& b = table.model.at(row);
            QVERIFY(a.person < b.person || (a.person == b.person && a.summary.id > b.summary.id));
        }
    }

    void pagesFollowInAnyOrder() {
        const auto rows = tests::madeRows(5000, kTitles);
        const std::vector<SessionRow> newest(rows.begin(), rows.begin() + 100);
        const std::vector<SessionRow> rest(rows.begin() + 100, rows.end());
        Table whole;
        whole.model.setRows(rows);
        for (const int column :
             {static_cast<int>(SessionTableModel::number), static_cast<int>(SessionTableModel::person)}) {
            for (const Qt::SortOrder order : {Qt::DescendingOrder, Qt::AscendingOrder}) {
                Table paged;
                paged.model.sort(column, order);
                whole.model.sort(column, order);
                paged.model.setRows(newest);
                paged.model.append(rest);
                QCOMPARE(paged.model.rowCount(), whole.model.rowCount());
                QCOMPARE(paged.model.total(), 5000);
                for (int row = 0; row < whole.model.rowCount(); ++row)
                    QCOMPARE(paged.model.at(row).summary.id, whole.model.at(row).summary.id);
            }
        }
    }

    void everyChangeIsAnnounced() {
        Table table;
        Announced announced(table.model);
        table.model.setRows(tests::madeRows(20, kTitles));
        QVERIFY(announced.once());
        table.model.sort(SessionTableModel::person, Qt::AscendingOrder);
        QVERIFY(announced.once());
        table.model.append(tests::madeRows(5, kTitles));
        QVERIFY(announced.once());
        SessionListFilter filter;
        filter.archived = true;
        table.model.setFilter(filter);
        QVERIFY(announced.once());
        table.model.setFilter(filter); // nothing new
        QVERIFY(!announced.once());
        table.model.replace(table.model.at(0));
        QVERIFY(announced.once());
        PeopleModel people(table.theme, nullptr);
        Announced ofPeople(people);
        people.setPeople(std::vector<database::Person>(2));
        QVERIFY(ofPeople.once());
        QCOMPARE(people.rowCount(), 2);
    }

    void aChangedRowMovesOrLeaves() {
        Table table;
        table.model.setRows(tests::madeRows(50, kTitles));
        SessionRow row = table.model.at(0);
        const database::SessionId id = row.summary.id;
        row.summary.archived = true;
        table.model.replace(row);
        QCOMPARE(table.model.rowOf(id), -1);
        SessionListFilter filter;
        filter.archived = true;
        table.model.setFilter(filter);
        const QModelIndex state = table.model.index(table.model.rowOf(id), SessionTableModel::result);
        QVERIFY(state.data().toString().contains(QStringLiteral("archived"))); // a word, not only a colour
        QVERIFY(!state.data(Qt::DecorationRole).value<QIcon>().isNull());
    }

    void everyColumnSaysWhatItIs() {
        Table table;
        database::SessionSummary s;
        s.id = 7;
        s.personName = "Theodora Papadopoulou";
        s.exercise = "sphere_apex";
        s.state = database::SessionState::completed;
        s.passed = false;
        s.gates = 5;
        s.gatesMet = 3;
        s.comments = 2;
        s.level = 4;
        s.attempt = 3;
        s.toReview = true;
        s.ticks = 61'000;
        table.model.setRows({makeSessionRow(s, kTitles)});
        const auto text = [&](SessionTableModel::Column column) {
            return table.model.index(0, column).data().toString();
        };
        QCOMPARE(text(SessionTableModel::person), QStringLiteral("Theodora Papadopoulou"));
        QCOMPARE(text(SessionTableModel::operatorName), QStringLiteral("Own hand"));
        QCOMPARE(text(SessionTableModel::result), QStringLiteral("Not passed"));
        QCOMPARE(text(SessionTableModel::score), QStringLiteral("3 of 5"));
        QCOMPARE(text(SessionTableModel::comments), QStringLiteral("2"));
        QCOMPARE(text(SessionTableModel::review),
                 QStringLiteral("To review")); // both by the person themselves
        QCOMPARE(text(SessionTableModel::attempt), QStringLiteral("3"));
        const QString tip = table.model.index(0, 0).data(Qt::ToolTipRole).toString();
        QVERIFY2(tip.startsWith(QStringLiteral("Attempt 3 at level 4")), qPrintable(tip));
        QVERIFY2(tip.contains(QStringLiteral("3 of 5")) && tip.contains(QStringLiteral("1 min 01 s")) &&
                     tip.contains(QStringLiteral("Session 7")),
                 qPrintable(tip));
        s.reviewed = true;
        s.toReview = false;
        s.attempt = 0;
        s.state = database::SessionState::stopped; // says how it ended, instead of what it was not
        s.operatorName = "expert";
        s.gates = s.gatesMet = s.comments = 0;
        table.model.replace(makeSessionRow(s, kTitles));
        QCOMPARE(text(SessionTableModel::result), QStringLiteral("Stopped"));
        QCOMPARE(text(SessionTableModel::review), QStringLiteral("Reviewed"));
        QVERIFY(text(SessionTableModel::score).isEmpty() && text(SessionTableModel::comments).isEmpty() &&
                text(SessionTableModel::attempt).isEmpty());
        QCOMPARE(text(SessionTableModel::operatorName), QStringLiteral("Expert"));
        const auto ofPerson = [&](int role) {
            return table.model.index(0, SessionTableModel::person).data(role).toString();
        };
        QVERIFY(ofPerson(PlainCellDelegate::kSecondLine).isEmpty()); // it has a column of its own
        table.model.setOperatorWithPerson(true);
        QCOMPARE(ofPerson(PlainCellDelegate::kSecondLine), QStringLiteral("Expert"));
        QCOMPARE(ofPerson(Qt::AccessibleTextRole), QStringLiteral("Theodora Papadopoulou, Expert"));
        QCOMPARE(ofPerson(Qt::DisplayRole), QStringLiteral("Theodora Papadopoulou"));
        s.operatorName.clear(); // somebody's own hand needs no word
        table.model.replace(makeSessionRow(s, kTitles));
        QVERIFY(ofPerson(PlainCellDelegate::kSecondLine).isEmpty() &&
                ofPerson(Qt::AccessibleTextRole).isEmpty());
        s.familiarisation = true; // a practice is ended when there was enough of it
        s.gates = 5;
        s.gatesMet = 2;
        table.model.replace(makeSessionRow(s, kTitles));
        QCOMPARE(text(SessionTableModel::result), QStringLiteral("Familiarisation"));
        QVERIFY(text(SessionTableModel::score).isEmpty());
        s.state = database::SessionState::faulted;
        table.model.replace(makeSessionRow(s, kTitles));
        QCOMPARE(text(SessionTableModel::result), QStringLiteral("Faulted"));
    }

    void csvQuotesAndKeepsToTokens() {
        auto rows = tests::madeRows(2, kTitles);
        rows[0].summary.personName = "Smith, \"Jo\"";
        const QByteArrayList lines = sessionsCsv(rows).split('\n');
        QVERIFY(lines[0].startsWith("session,started_utc,person"));
        QVERIFY(lines[1].contains("\"Smith, \"\"Jo\"\"\""));
        QVERIFY(lines[1].contains(",completed,false,shown,"));
        QVERIFY(lines[1].trimmed().contains(",17.919,3,1,1,false"));
        QVERIFY(!writeSessionsCsv(rows, QStringLiteral("/nowhere/at/all.csv")));
        for (const auto& [name, field] : {std::pair{"Smith; Jo", "Smith; Jo"},
                                          {"Smith, Jo", "\"Smith, Jo\""},
                                          {"Jo \"J\" Smith", "\"Jo \"\"J\"\" Smith\""},
                                          {"Jo\nSmith", "\"Jo\nSmith\""},
                                          {"Jo\rSmith", "\"Jo\rSmith\""}}) {
            rows[0].summary.personName = name;
            QVERIFY2(sessionsCsv(rows).contains(QByteArray(",") + field + ','), name);
        }
    }
};

QTEST_MAIN(TestSessionTable)
#include "test_session_table.moc"
