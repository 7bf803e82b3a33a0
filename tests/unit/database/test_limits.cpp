// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_people.h"

#include "database/accounts/account_rules.h"
#include "database/accounts/generated_password.h"
#include "database/accounts/recovery_code.h"
#include "database/accounts/throttle.h"
#include "database/accounts/user_csv.h"
#include "database/privacy/erasure.h"
#include "database/repositories/station_repository.h"
#include "database/repositories/study_rules.h"

#include <cmath>
#include <functional>
#include <limits>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

/// Every limit that is said is the limit: its last value is taken, the one beyond is bad input, in words
/// before the tables' own rules.
class TestLimits : public QObject, StudyPeople {
    Q_OBJECT
private slots:
    void init() { begin(); }
    void ofSessions();
    void ofFreeTexts();
    void ofMoments();
    void ofStudies();
    void ofParticipants();
    void ofRuns();
    void ofTrials();
    void ofAnswers();
    void ofErasures();
    void ofPeople();
    void ofRosters();
    void ofWaits();
    void ofStationChecks();
    void ofWords();

private:
    template <class F> auto session(F job) {
        return m->database->write([&](WriteContext& w) {
            SessionRepository sessions(w.connection(), m_ruth);
            return job(sessions);
        });
    }
};

namespace {

/// What a limit's test says where it fails: the row of its table.
template <class R> void taken(const R& result, int row) {
    QVERIFY2(result.has_value(),
             qPrintable(QStringLiteral("row %1: %2")
                            .arg(row)
                            .arg(QString::fromStdString(result ? std::string() : result.error().message))));
}
template <class R> void refused(const R& result, int row) {
    QVERIFY2(!result, qPrintable(QStringLiteral("row %1 is taken").arg(row)));
    QVERIFY2(result.error().code == core::ErrorCode::badInput,
             qPrintable(
                 QStringLiteral("row %1: %2").arg(row).arg(QString::fromStdString(result.error().message))));
}

/// As many characters, two bytes each: limits are of characters.
std::string letters(int count) {
    std::string text;
    for (int i = 0; i < count; ++i) {
        text += "ä";
    }
    return text;
}

} // namespace

void TestLimits::ofSessions() {
    const auto begun = [&](const std::function<void(NewSession&)>& change) {
        NewSession setup = someSession();
        change(setup);
        return session([&](SessionRepository& s) { return s.beginSession(setup); });
    };
    int row = 0;
    for (const auto& change : std::vector<std::function<void(NewSession&)>>{
             [](NewSession& s) { s.exercise = "a"; },
             [](NewSession& s) { s.exercise = std::string(100, 'a'); }, [](NewSession& s) { s.level = 1; },
             [](NewSession& s) { s.level = 1'000'000; }, [](NewSession& s) { s.plannedTrials = 1; },
             [](NewSession& s) { s.plannedTrials = 1'000'000; }, [](NewSession& s) { s.forceLimit_N = 0.0; },
             [](NewSession& s) { s.forceLimit_N = 1e6; }}) {
        taken(begun(change), ++row);
    }
    for (const auto& change : std::vector<std::function<void(NewSession&)>>{
             [](NewSession& s) { s.exercise = std::string(101, 'a'); }, [](NewSession& s) { s.level = 0; },
             [](NewSession& s) { s.level = 1'000'001; }, [](NewSession& s) { s.plannedTrials = 0; },
             [](NewSession& s) { s.plannedTrials = 1'000'001; },
             [](NewSession& s) { s.forceLimit_N = -1e-9; }, [](NewSession& s) { s.forceLimit_N = 1e6 + 1.0; },
             [](NewSession& s) { s.forceLimit_N = std::nan(""); }}) {
        refused(begun(change), ++row);
    }
}

void TestLimits::ofFreeTexts() {
    const auto id = storeSession(*m->database, m_ruth, 1);
    REQUIRE(id);
    const auto commented = [&](const std::string& text) {
        return session([&](SessionRepository& s) { return s.addComment(*id, text); });
    };
    taken(commented(letters(10000)), 1);
    refused(commented(letters(10001)), 2);
    refused(commented(""), 3);
    const auto voided = [&](const std::string& reason) {
        return m->database->write([&](WriteContext& w) {
            return SessionRepository(w.connection(), m_admin).voidSession(*id, reason);
        });
    };
    refused(voided(letters(10001)), 4);
    refused(voided(""), 5);
    taken(voided(letters(10000)), 6);
}

// A comment's moment is a tick that the session had, its end included.
void TestLimits::ofMoments() {
    const auto id = storeSession(*m->database, m_ruth, 1);
    REQUIRE(id);
    const auto at = [&](std::uint64_t tick) {
        return session([&](SessionRepository& s) { return s.addComment(*id, "here", tick); });
    };
    taken(at(0), 1);
    taken(at(1000), 2);
    refused(at(1001), 3);
    const auto running = session([&](SessionRepository& s) { return s.beginSession(someSession()); });
    REQUIRE(running);
    const auto early = [&](std::uint64_t tick) {
        return session([&](SessionRepository& s) { return s.addComment(*running, "here", tick); });
    };
    taken(early(std::numeric_limits<std::int64_t>::max()), 4); // its length is not known yet
    refused(early(std::uint64_t{1} << 63), 5);
}

void TestLimits::ofStudies() {
    const auto made = [&](const std::string& key, const std::string& title, const std::string& design) {
        return write(m_ruth, [&](StudyRepository& s) { return s.createStudy(key, title, design); });
    };
    taken(made("a" + std::string(63, 'b'), letters(500), "{}"), 1);
    refused(made("a" + std::string(64, 'b'), "Title", "{}"), 2);
    refused(made("", "Title", "{}"), 3);
    refused(made("long_title", letters(501), "{}"), 4);
    const std::string frame = R"({"a":""})";
    const auto sized = [&](std::size_t bytes) {
        return R"({"a":")" + std::string(bytes - frame.size(), 'x') + R"("})";
    };
    taken(made("largest", "Title", sized(1 << 20)), 5);
    refused(made("larger", "Title", sized((1 << 20) + 1)), 6);
    // A draft is kept whatever its title; one that is too long to be listed is not taken over.
    const auto study = made("titled", "First", "{}");
    REQUIRE(study);
    const auto named = [&](int count) {
        REQUIRE(write(m_ruth, [&](StudyRepository& s) {
            return s.saveDraft(*study, R"({"title":{"en":")" + letters(count) + R"("}})");
        }));
        QCOMPARE(StudyReader(*reader(), m_ruth).study(*study)->summary.title,
                 count > 500 ? std::string("First") : letters(count));
    };
    named(501);
    named(500);
    const StudyNumber blinded = frozen("reasons");
    const auto unblinded = [&](const std::string& reason) {
        return write(m_ruth, [&](StudyRepository& s) { return s.unblindStudy(blinded, reason); });
    };
    refused(unblinded(letters(501)), 7);
    refused(unblinded(" \n"), 8);
    taken(unblinded(letters(500)), 9);
}

void TestLimits::ofParticipants() {
    const StudyNumber study = frozen("people");
    const auto joins = [&](const std::string& identity, const std::string& observer,
                           const std::string& code) {
        return write(m_ruth, [&](StudyRepository& s) {
            return s.enrolParticipant(study, identity, 0, observer, code);
        });
    };
    taken(joins(letters(2000), "", ""), 1);
    refused(joins(letters(2001), "", ""), 2);
    taken(joins("", letters(500), "c1"), 3);
    refused(joins("", letters(501), "c2"), 4);
    taken(joins("", "weber:0.1", std::string(20, 'K')), 5);
    refused(joins("", "weber:0.1", std::string(21, 'K')), 6);
    refused(joins("", "weber:0.1", "a b"), 7);
    refused(joins("", "", "c3"), 8);            // people get random codes
    refused(joins("Jane", "weber:0.1", ""), 9); // a simulated one is nobody
}

void TestLimits::ofRuns() {
    const StudyNumber study = frozen("runs");
    const auto begun = [&](int position, const std::string& procedures) {
        const ParticipantNumber who = consented(study);
        return write(m_ruth, [&](StudyRepository& s) {
            return s.beginRun({who, codeOf(*reader(), study, "soft"), position, 1, procedures});
        });
    };
    taken(begun(0, "p"), 1);
    taken(begun(1000, letters(1000)), 2);
    refused(begun(-1, "p"), 3);
    refused(begun(1001, "p"), 4);
    refused(begun(0, letters(1001)), 5);
    refused(begun(0, ""), 6);
}

void TestLimits::ofTrials() {
    const StudyNumber study = frozen("trials");
    const ParticipantNumber who = consented(study);
    const auto run = write(m_ruth, [&](StudyRepository& s) {
        return s.beginRun({who, codeOf(*reader(), study, "soft"), 0, 1, "descending@1"});
    });
    REQUIRE(run);
    int next = 0, row = 0;
    const auto stored = [&](const std::function<void(StudyTrial&)>& change) {
        StudyTrial trial = someTrial(*run, next);
        change(trial);
        return write(m_ruth, [&](StudyRepository& s) { return s.storeStudyTrial(trial); });
    };
    const auto fidelity = [](std::size_t bytes) {
        return R"({"a":")" + std::string(bytes - 8, 'x') + R"("})";
    };
    for (const auto& change : std::vector<std::function<void(StudyTrial&)>>{
             [](StudyTrial& t) { t.candidate = 0; }, [](StudyTrial& t) { t.candidate = 4095; },
             [](StudyTrial& t) { t.arrangement = 0; }, [](StudyTrial& t) { t.arrangement = 15; },
             [](StudyTrial& t) { t.answer = -1; }, [](StudyTrial& t) { t.outcome = -1; },
             [](StudyTrial& t) { t.procedure = 0; }, [](StudyTrial& t) { t.lastTick = t.firstTick; },
             [](StudyTrial& t) { t.exploration_s = 0.0; }, [](StudyTrial& t) { t.answer_s = 0.0; },
             [](StudyTrial& t) { t.difference = 1000.0; }, [](StudyTrial& t) { t.difference = -1000.0; },
             [](StudyTrial& t) { t.spoiled = letters(40); },
             [&](StudyTrial& t) { t.fidelityJson = fidelity(65536); }}) {
        taken(stored(change), ++row);
        ++next;
    }
    for (const auto& change : std::vector<std::function<void(StudyTrial&)>>{
             [](StudyTrial& t) { t.candidate = -1; }, [](StudyTrial& t) { t.candidate = 4096; },
             [](StudyTrial& t) { t.arrangement = -1; }, [](StudyTrial& t) { t.arrangement = 16; },
             [](StudyTrial& t) { t.answer = -2; }, [](StudyTrial& t) { t.outcome = -2; },
             [](StudyTrial& t) { t.procedure = -1; }, [](StudyTrial& t) { t.lastTick = t.firstTick - 1; },
             [](StudyTrial& t) { t.exploration_s = -1e-9; }, [](StudyTrial& t) { t.answer_s = -1e-9; },
             [](StudyTrial& t) { t.exploration_s = std::nan(""); },
             [](StudyTrial& t) { t.answer_s = std::numeric_limits<double>::infinity(); },
             [](StudyTrial& t) { t.difference = 1000.1; }, [](StudyTrial& t) { t.difference = -1000.1; },
             [](StudyTrial& t) { t.spoiled = letters(41); },
             [&](StudyTrial& t) { t.fidelityJson = fidelity(65537); },
             [](StudyTrial& t) { t.fidelityJson = "[]"; }}) {
        refused(stored(change), ++row);
    }
}

void TestLimits::ofAnswers() {
    const StudyNumber study = frozen("answers");
    int row = 0;
    const auto answered = [&](const char* item, std::optional<double> number, const std::string& text) {
        const ParticipantNumber who = consented(study);
        return write(m_ruth, [&](StudyRepository& s) {
            return s.storeQuestionnaireAnswers({{who, "face", item, number, text, ""}});
        });
    };
    for (const auto& [item, number] : std::initializer_list<std::pair<const char*, double>>{
             {"real", 1.0}, {"real", 5.0}, {"years", 0.0}, {"years", 60.0}, {"hand", 0.0}, {"hand", 1.0}}) {
        taken(answered(item, number, ""), ++row);
    }
    for (const auto& [item, number] : std::initializer_list<std::pair<const char*, double>>{{"real", 0.0},
                                                                                            {"real", 6.0},
                                                                                            {"real", 4.5},
                                                                                            {"years", -0.1},
                                                                                            {"years", 60.1},
                                                                                            {"hand", -1.0},
                                                                                            {"hand", 2.0},
                                                                                            {"hand", 0.5}}) {
        refused(answered(item, number, ""), ++row);
    }
    taken(answered("years", 0.5, ""), ++row); // a number need not be whole
    taken(answered("remarks", {}, letters(10000)), ++row);
    refused(answered("remarks", {}, letters(10001)), ++row);
    refused(answered("real", 3.0, "and a text"), ++row);
    refused(answered("real", {}, ""), ++row);
}

void TestLimits::ofErasures() {
    AccountService accounts(*m->database);
    const auto tim = m->person(m_admin, "tim", {Role::trainee});
    REQUIRE(tim);
    const auto erased = [&](const std::string& reason) {
        return accounts.erasePerson(m_admin, kPassword, tim->personId(), reason, false);
    };
    refused(erased(letters(1001)), 1);
    refused(erased(""), 2);
    taken(erased(letters(1000)), 3);
    const ParticipantNumber who = consented(frozen("oblivion"));
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.withdrawParticipant(who, false); }));
    const auto forgotten = [&](const std::string& reason) {
        return accounts.eraseParticipant(m_admin, kPassword, who, reason);
    };
    refused(forgotten(letters(1001)), 4);
    refused(forgotten(""), 5);
    taken(forgotten(letters(1000)), 6);
    // The list beside the file: nobody is erased who is no person.
    const std::string list = m->path("list.json");
    const auto read = [&](int person, const std::string& code) {
        const auto saved = saveErasureList(list, {{person, "", "", "wish", 2, false, "{}", code}});
        return saved ? readErasureList(list) : tl::unexpected(saved.error());
    };
    taken(read(2, ""), 7);
    taken(read(0, "K7M-4QX"), 8); // a participant
    refused(read(1, ""), 9);      // the simulated account
    refused(read(0, ""), 10);
}

void TestLimits::ofPeople() {
    taken(checkName(letters(64)), 1);
    taken(checkName("a"), 2);
    taken(checkName("simulatedly"), 3);
    int row = 3;
    for (const std::string& name :
         {letters(65), std::string(), std::string(" a"), std::string("a "), std::string("a,b"),
          std::string("a\nb"), std::string("a\u200bb"), std::string("a\u2028b"), std::string("a\u2029b"),
          std::string("Simulated"), std::string("erased-7"), std::string("\xff")}) {
        refused(checkName(name), ++row);
    }
    QVERIFY(checkName("a\u2028b").error().message.ends_with("; it holds an invisible character"));
    taken(checkText("reason", letters(10), 10), ++row);
    refused(checkText("reason", letters(11), 10), ++row);
    refused(checkText("reason", "\xff", 10), ++row);
    // Valid UTF-8 that would come back as something else: with a zero in it, or with a mark of byte order.
    for (const std::string& text : {std::string("abc\0def", 7), std::string("\xef\xbb\xbf"
                                                                            "abc")}) {
        refused(checkText("reason", text, 10), ++row);
        refused(checkName(text), ++row);
        refused(checkPassword("", text + " of a good length"), ++row);
    }
    for (int i = 0; i < 20; ++i) {
        QCOMPARE(generatedPassword().size(), std::size_t{16});
    }
    taken(checkPassword("", "abcd" + std::string(1020, 'x')), ++row);
    refused(checkPassword("", "abcd" + std::string(1021, 'x')), ++row);
    taken(checkPassword("", "aaaaaaabcd"), ++row);
    refused(checkPassword("", "aaaaaabcd"), ++row);  // nine
    refused(checkPassword("", "aaaaaaaabc"), ++row); // three different ones
    const auto joins = [&](const std::string& display, const char* name) {
        return AccountService(*m->database)
            .createPerson(m_admin, {name, display, {Role::trainee}, kPassword, false});
    };
    taken(joins(letters(200), "ann"), ++row);
    refused(joins(letters(201), "bea"), ++row);
    QCOMPARE(newRecoveryCode().size(), std::size_t{29}); // five groups of five
    for (const std::size_t dash : {5, 11, 17, 23}) {
        QCOMPARE(newRecoveryCode()[dash], '-');
    }
}

void TestLimits::ofRosters() {
    const auto lines = [](int people, const char* last) {
        std::string text = "name,roles,password\n";
        for (int i = 0; i < people; ++i) {
            text += "p" + std::to_string(i) + ",trainee,a good long word\n";
        }
        return text + last;
    };
    const Roster most = readRoster(lines(9999, "")); // with the header line 10,000
    QVERIFY(most.problems.empty() && most.rows.size() == 9999);
    const Roster more = readRoster(lines(10000, ""));
    QCOMPARE(more.problems.size(), std::size_t{1});
    const RosterProblem& fault = more.problems.front();
    QVERIFY(fault.fault == RosterFault::tooManyLines && fault.value == "10000" && fault.other == 0 &&
            fault.words == "more than 10000 lines");
    QVERIFY(more.rows.empty());
    const auto wrong = [](int count) {
        std::string text = "name,roles,password\n";
        for (int i = 0; i < count; ++i) {
            text += "p" + std::to_string(i) + ",wizard,a good long word\n";
        }
        return parseUserCsv(text).error().message;
    };
    QVERIFY(wrong(20).ends_with(
        "line 21, roles \"wizard\": expected trainee, trainer, researcher or admin, separated by ;"));
    QVERIFY(wrong(21).ends_with("\nand 1 more"));
    QVERIFY(wrong(23).ends_with("\nand 3 more") && wrong(23).find("line 22") == std::string::npos);
}

// Longer with every failure up to five minutes; a count at its end stays there.
void TestLimits::ofWaits() {
    constexpr std::int64_t second_ns = 1'000'000'000;
    for (std::int64_t failures = 3; failures <= 10; ++failures) {
        QCOMPARE(throttleWait_ns(failures), second_ns << (failures - 2));
    }
    QCOMPARE(throttleWait_ns(11), 300 * second_ns);
    QCOMPARE(throttleWait_ns(100), 300 * second_ns);
    ThrottleState state;
    state.failures = 1'000'000'000;
    throttleCount(state, {"boot", 7});
    QCOMPARE(state.failures, std::int64_t{1'000'000'000});
    QCOMPARE(state.waitUntil_ns, 7 + 300 * second_ns);
    QCOMPARE(throttleRemaining_ns(state, {"boot", 7 + 299 * second_ns}), second_ns);
    QCOMPARE(throttleRemaining_ns(state, {"boot", 7 + 300 * second_ns}), std::int64_t{0});
}

void TestLimits::ofStationChecks() {
    const auto checked = [&](const StationCheck& check) {
        return m->database->write([&](WriteContext& w) {
            return StationRepository(w.connection(), m_ruth).recordStationCheck(check);
        });
    };
    const std::string longest(200, 'x'), longer(201, 'x');
    taken(checked({longest, longest, longest, true, longest}), 1);
    taken(checked({"loop", " ~", "1", false, ""}), 2); // the first and the last character that are plain
    int row = 2;
    for (const StationCheck& check : {StationCheck{"", "", "1", true, ""},
                                      {"loop", "", "", true, ""},
                                      {longer, "", "1", true, ""},
                                      {"loop", longer, "1", true, ""},
                                      {"loop", "", longer, true, ""},
                                      {"loop", "", "1", true, longer},
                                      {"loop", "a\x1f", "1", true, ""},
                                      {"loop", "a\x7f", "1", true, ""}}) {
        refused(checked(check), ++row);
    }
}

// A state is known by its own word and by no other.
void TestLimits::ofWords() {
    for (const StudyState state :
         {StudyState::draft, StudyState::frozen, StudyState::closed, StudyState::archived}) {
        QVERIFY(studyStateFromToken(token(state)) == state);
    }
    for (const ParticipantState state : {ParticipantState::enrolled, ParticipantState::consented,
                                         ParticipantState::completed, ParticipantState::withdrawn}) {
        QVERIFY(participantStateFromToken(token(state)) == state);
    }
    for (const StudyRunState state :
         {StudyRunState::open, StudyRunState::completed, StudyRunState::stopped}) {
        QVERIFY(studyRunStateFromToken(token(state)) == state);
    }
    for (const char* word : {"", "Draft", "ended"}) {
        QVERIFY(!studyStateFromToken(word) && !participantStateFromToken(word) &&
                !studyRunStateFromToken(word));
    }
}

QTEST_GUILESS_MAIN(TestLimits)
#include "test_limits.moc"
