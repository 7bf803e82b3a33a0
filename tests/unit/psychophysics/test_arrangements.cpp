// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/study/arrangement.h"

#include <QtTest>

#include <algorithm>
#include <numeric>
#include <set>
#include <string>

using namespace chiron::psychophysics;

namespace {

Task taskOf(int i) {
    return static_cast<Task>(i);
}

/// All arrangements that a task's definition allows, found by trying every combination.
std::set<Places> everyWay(Task task) {
    const int places = placesOf(task);
    const int most = ranksThree(task) ? 2 : 1;
    std::set<Places> found;
    Places each(static_cast<std::size_t>(places), 0);
    for (;;) {
        const int sum = std::accumulate(each.begin(), each.end(), 0);
        const auto ones = std::count(each.begin(), each.end(), 1);
        bool asked = true;
        switch (task) {
        case Task::rank3:
        case Task::rank3Ties:
            asked = sum == 3 && ones == 1; // one reference, one D, one 2D
            break;
        case Task::twoAfc:
        case Task::threeAfc:
            asked = ones == 1;
            break;
        case Task::oddity:
            asked = ones == 1 || ones == 2; // one differs from the two others
            break;
        case Task::adjustment:
            asked = each == Places{0, 1};
            break;
        case Task::magnitude:
            asked = each == Places{1};
            break;
        case Task::sameDifferent:
        case Task::yesNo:
            break;
        }
        if (asked)
            found.insert(each);
        std::size_t digit = 0;
        while (digit < each.size() && ++each[digit] > most)
            each[digit++] = 0;
        if (digit == each.size())
            return found;
    }
}

} // namespace

/// Arrangements of the objects, possible answers, and which answer is right.
class TestArrangements : public QObject {
    Q_OBJECT
private slots:
    void tokensReadBack();
    void everyWayIsThereOnce();
    void theRightAnswer();
    void whatATaskDoesNotHaveHasNoOutcome();
    void rankingsAreOrdersWithTies();
    void ranksAreOfTheObjects();
};

void TestArrangements::tokensReadBack() {
    std::set<std::string_view> tokens;
    for (int i = 0; i < kTasks; ++i) {
        QCOMPARE(taskFromToken(token(taskOf(i))), std::optional(taskOf(i)));
        tokens.insert(token(taskOf(i)));
    }
    QCOMPARE(tokens.size(), std::size_t{kTasks});
    QVERIFY(!taskFromToken("") && !taskFromToken("2AFC") && !taskFromToken("rank3 "));
}

void TestArrangements::everyWayIsThereOnce() {
    for (int i = 0; i < kTasks; ++i) {
        const auto& all = arrangements(taskOf(i));
        QVERIFY(all.size() <= 16);
        QCOMPARE(std::set<Places>(all.begin(), all.end()).size(), all.size());
        QVERIFY2(std::set<Places>(all.begin(), all.end()) == everyWay(taskOf(i)),
                 std::string(token(taskOf(i))).c_str());
    }
    QVERIFY(std::is_sorted(arrangements(Task::rank3).begin(),
                           arrangements(Task::rank3).end())); // lexicographic, as stored trials count them
    QCOMPARE(arrangements(Task::rank3Ties), arrangements(Task::rank3));
    QCOMPARE(arrangements(Task::oddity)[3], (Places{0, 1, 1}));
}

void TestArrangements::theRightAnswer() {
    for (const Task task : {Task::twoAfc, Task::threeAfc, Task::oddity, Task::sameDifferent, Task::yesNo}) {
        for (int a = 0; a < static_cast<int>(arrangements(task).size()); ++a) {
            const Places& at = arrangements(task)[static_cast<std::size_t>(a)];
            const int right = correctAnswer(task, a);
            QVERIFY(right >= 0 && right < answers(task));
            if (task == Task::twoAfc || task == Task::threeAfc)
                QCOMPARE(at[static_cast<std::size_t>(right)], 1);
            if (task == Task::oddity)
                QCOMPARE(std::count(at.begin(), at.end(), at[static_cast<std::size_t>(right)]),
                         std::ptrdiff_t{1});
            if (task == Task::sameDifferent)
                QCOMPARE(right == 0, at[0] == at[1]);
            if (task == Task::yesNo)
                QCOMPARE(right == 1, at[0] == 1);
            for (int answer = 0; answer < answers(task); ++answer)
                QCOMPARE(outcomeOf(task, a, answer), answer == right ? 1 : 0);
        }
    }
    for (const Task task : {Task::adjustment, Task::magnitude})
        QCOMPARE(correctAnswer(task, 0), -1);
}

void TestArrangements::whatATaskDoesNotHaveHasNoOutcome() {
    for (int i = 0; i < kTasks; ++i) {
        const int all = static_cast<int>(arrangements(taskOf(i)).size()), most = answers(taskOf(i));
        for (const auto& [arrangement, answer] : {std::pair{-1, 0}, {all, 0}, {0, -1}, {0, most}})
            QCOMPARE(outcomeOf(taskOf(i), arrangement, answer), -1);
        QVERIFY(outcomeOf(taskOf(i), all - 1, most - 1) >= 0);
    }
}

void TestArrangements::rankingsAreOrdersWithTies() {
    std::set<Ranking> all;
    for (int i = 0; i < kRankings; ++i) {
        const Ranking& ranks = rankings()[static_cast<std::size_t>(i)];
        all.insert(ranks);
        QCOMPARE(rankingOf(ranks), i);
        const int highest = *std::max_element(ranks.begin(), ranks.end());
        for (int rank = 0; rank <= highest; ++rank) // no rank is left out
            QVERIFY(std::count(ranks.begin(), ranks.end(), rank) > 0);
        QCOMPARE(highest == 2, i < kStrictRankings);
    }
    QCOMPARE(all.size(), std::size_t{kRankings});
    for (const Ranking& none : {Ranking{0, 0, 2}, Ranking{1, 1, 1}, Ranking{0, 1, 3}, Ranking{-1, 0, 1}})
        QCOMPARE(rankingOf(none), -1);
}

void TestArrangements::ranksAreOfTheObjects() {
    for (const Task task : {Task::rank3, Task::rank3Ties})
        for (int a = 0; a < kStrictRankings; ++a) {
            const Places& at = arrangements(task)[static_cast<std::size_t>(a)];
            QCOMPARE(outcomeOf(task, a, correctAnswer(task, a)), 0);
            for (int answer = 0; answer < answers(task); ++answer) {
                const Ranking& said = rankings()[static_cast<std::size_t>(answer)];
                const Ranking& given = rankings()[static_cast<std::size_t>(outcomeOf(task, a, answer))];
                for (std::size_t place = 0; place < 3;
                     ++place) // the object that lay there got the rank said there
                    QCOMPARE(int(given[static_cast<std::size_t>(at[place])]), int(said[place]));
            }
        }
}

QTEST_GUILESS_MAIN(TestArrangements)
#include "test_arrangements.moc"
