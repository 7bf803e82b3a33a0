// SPDX-License-Identifier: GPL-3.0-or-later
#include "database_fixture.h"

#include "database/accounts/account_rules.h"
#include "database/accounts/generated_password.h"
#include "database/accounts/password_hasher.h"
#include "database/accounts/throttle.h"
#include "database/query.h"
#include "database/repositories/privacy_repository.h"

#include <QFile>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

/// Passwords, throttling, recovery, import, erasure.
class TestAccounts : public QObject {
    Q_OBJECT
private slots:
    void productionHashIsArgon2idAtItsCost();
    void passwordRulesAreStated();
    void firstAdministratorOnlyOnce();
    void loginNamesAreThoseWhoMayLogIn();
    void recoveryCodeWorksOnce();
    void anyAdministratorMakesARecoveryCode();
    void wrongPasswordsWaitLongerAndLonger();
    void refusalsSayHowLongToWait();
    void waitSurvivesRestartsAndClocksSetBack();
    void readOnlyLoginHonoursTheWait();
    void unknownNamesReadLikeWrongPasswords();
    void resetForcesAChange();
    void lastAdministratorStays();
};

void TestAccounts::productionHashIsArgon2idAtItsCost() {
    const PasswordHasher hasher(PasswordCost::production());
    const auto hash = hasher.hash("correct horse 9");
    REQUIRE(hash);
    // PHC string of Argon2id v1.3: m in KiB, t passes.
    QVERIFY2(hash->starts_with("$argon2id$v=19$m=65536,t=3,p=1$"), hash->c_str());
    QVERIFY(hasher.verify(*hash, "correct horse 9"));
    QVERIFY(!hasher.verify(*hash, "correct horse 8"));
    QVERIFY(!hasher.verify("", "x"));
    QVERIFY(!hasher.verify(std::string(500, 'a'), "x"));
    QCOMPARE(DatabaseOptions{}.passwordCost.memory_bytes, std::size_t{64} << 20);
    QCOMPARE(DatabaseOptions{}.passwordCost.passes, 3ULL);
}

void TestAccounts::passwordRulesAreStated() {
    for (const std::string& bad :
         {std::string("short 123"), std::string("aaaaaaaaaaaa"), std::string("ababababcabc"),
          std::string(1025, 'x') + "abcd", std::string("Ada Lovelace"),
          std::string("\xff\xff\xff\xff"
                      "abcdefghij")}) {
        const auto checked = checkPassword("ada lovelace", bad);
        QVERIFY2(!checked, bad.c_str());
        QVERIFY(checked.error().message.find("at least 10 characters") != std::string::npos);
        QVERIFY(bad.size() < 4 || checked.error().message.find(bad) == std::string::npos); // never repeats it
    }
    QVERIFY(checkPassword("ada", "длинный пароль").has_value());
    QVERIFY(checkPassword("ada", "1234567890").has_value());
    // Rule by rule, for a form.
    const PasswordCheck empty = examinePassword("ada", "");
    QVERIFY(!empty.longEnough && !empty.varied && empty.notTheName && empty.storable && !empty.ok());
    const PasswordCheck same = examinePassword("Ada Lovelace", "ada lovelace");
    QVERIFY(same.longEnough && same.varied && !same.notTheName && same.storable);
    QVERIFY(!examinePassword("ada", std::string(1025, 'x') + "abc").storable);
    for (int i = 0; i < 50; ++i) {
        QVERIFY(checkPassword("", generatedPassword()).has_value());
    }
    QVERIFY(generatedPassword() != generatedPassword());
}

void TestAccounts::firstAdministratorOnlyOnce() {
    DatabaseFixture f;
    REQUIRE(f.create());
    AccountService accounts(*f.database);
    QCOMPARE(accounts.createFirstAdministrator("ada", "short").error().code, core::ErrorCode::badInput);
    const auto first = accounts.createFirstAdministrator("ada", kPassword);
    REQUIRE(first);
    QCOMPARE(first->recoveryCode.size(), std::size_t{29});
    QCOMPARE(accounts.createFirstAdministrator("eve", kPassword).error().code, core::ErrorCode::wrongUse);
    auto reader = f.database->openReader();
    const std::string stored =
        selectText(**reader, "SELECT recovery_hash || password_hash FROM credential")->value();
    QVERIFY(stored.find(first->recoveryCode) == std::string::npos);
    QVERIFY(stored.find(kPassword) == std::string::npos);
}

void TestAccounts::loginNamesAreThoseWhoMayLogIn() {
    DatabaseFixture f;
    REQUIRE(f.create());
    AccountService accounts(*f.database);
    QCOMPARE(accounts.hasPeople().value(), false); // the built-in account is nobody
    QVERIFY(accounts.listLoginNames()->empty());
    const auto ada = f.administrator();
    QCOMPARE(accounts.hasPeople().value(), true);
    const auto zoe = f.person(*ada, "zoe", {Role::trainee});
    const auto bob = f.person(*ada, "Bob", {Role::trainer});
    const auto eve = f.person(*ada, "eve", {Role::trainee});
    REQUIRE(accounts.setEnabled(*ada, zoe->personId(), false));
    REQUIRE(accounts.erasePerson(*ada, kPassword, eve->personId(), "wish", false));
    const auto names = accounts.listLoginNames();
    REQUIRE(names);
    QCOMPARE(names->size(), std::size_t{2});
    QCOMPARE(names->at(0).name, std::string("ada"));
    QCOMPARE(names->at(1).name, std::string("Bob"));
    QCOMPARE(names->at(1).displayName, std::string("Bob display"));
    QCOMPARE(names->at(1).id, bob->personId());
    REQUIRE(accounts.setEnabled(*ada, zoe->personId(), true));
    QCOMPARE(accounts.listLoginNames()->size(), std::size_t{3});
}

void TestAccounts::recoveryCodeWorksOnce() {
    DatabaseFixture f;
    REQUIRE(f.create());
    AccountService accounts(*f.database);
    const auto first = accounts.createFirstAdministrator("ada", kPassword);
    REQUIRE(first);
    QCOMPARE(accounts.recover("ada", "WRONG-WRONG", "brand new word").error().code,
             core::ErrorCode::notAllowed);
    const auto second = accounts.recover("ada", first->recoveryCode, "brand new word");
    REQUIRE(second);
    QVERIFY(*second != first->recoveryCode);
    REQUIRE(accounts.login("ada", "brand new word"));
    QVERIFY(!accounts.login("ada", kPassword));
    QVERIFY(!accounts.recover("ada", first->recoveryCode, "another new word"));
    REQUIRE(accounts.recover("ada", *second, "another new word"));
    // Somebody without a code cannot be recovered.
    const auto ada = accounts.login("ada", "another new word");
    REQUIRE(ada);
    REQUIRE(f.person(*ada, "tim", {Role::trainee}));
    QCOMPARE(accounts.recover("tim", "", "another new word").error().code, core::ErrorCode::notAllowed);
}

void TestAccounts::anyAdministratorMakesARecoveryCode() {
    DatabaseFixture f;
    REQUIRE(f.create());
    AccountService accounts(*f.database);
    REQUIRE(accounts.createFirstAdministrator("ada", kPassword));
    const auto ada = accounts.login("ada", kPassword);
    REQUIRE(ada);
    QCOMPARE(accounts.hasRecoveryCode(*ada).value(), true);
    const auto second = f.person(*ada, "eve", {Role::admin});
    REQUIRE(second);
    QCOMPARE(accounts.hasRecoveryCode(*second).value(), false);
    const auto wrong = accounts.tryMakeRecoveryCode(*second, "not the password");
    QVERIFY(!wrong && wrong.error().kind == Refusal::Kind::wrong);
    QCOMPARE(accounts.hasRecoveryCode(*second).value(), false);
    const auto code = accounts.makeRecoveryCode(*second, kPassword);
    REQUIRE(code);
    QCOMPARE(accounts.hasRecoveryCode(*second).value(), true);
    const auto next = accounts.makeRecoveryCode(*second, kPassword); // replaces it
    REQUIRE(next);
    QVERIFY(!accounts.recover("eve", *code, "brand new word"));
    REQUIRE(accounts.recover("eve", *next, "brand new word"));
    REQUIRE(accounts.login("eve", "brand new word"));
    auto reader = f.database->openReader();
    REQUIRE(reader);
    QCOMPARE(
        selectInteger(**reader, "SELECT count(*) FROM credential WHERE instr(recovery_hash, ?) > 0", {*next})
            ->value_or(-1),
        std::int64_t{0});
    const auto tim = f.person(*ada, "tim", {Role::trainee});
    REQUIRE(tim);
    QCOMPARE(accounts.makeRecoveryCode(*tim, kPassword).error().code, core::ErrorCode::notAllowed);
}

void TestAccounts::wrongPasswordsWaitLongerAndLonger() {
    QCOMPARE(throttleWait_ns(0), std::int64_t{0});
    QCOMPARE(throttleWait_ns(2), std::int64_t{0});
    QCOMPARE(throttleWait_ns(3), std::int64_t{2'000'000'000});
    QCOMPARE(throttleWait_ns(4), std::int64_t{4'000'000'000});
    QCOMPARE(throttleWait_ns(1'000'000'000), std::int64_t{300'000'000'000});
    DatabaseFixture f;
    REQUIRE(f.create());
    REQUIRE(f.administrator());
    AccountService accounts(*f.database);
    for (int i = 0; i < 3; ++i) {
        QVERIFY(accounts.login("ada", "wrong word 12").error().message.find("wrong") != std::string::npos);
    }
    const auto refused = accounts.login("ADA", kPassword); // right, but too soon, and case does not help
    QVERIFY(!refused);
    QVERIFY2(refused.error().message.find("wait 2 s") != std::string::npos, refused.error().message.c_str());
    f.clock->advance_s(2);
    QVERIFY(!accounts.login("ada", "wrong word 12"));
    QVERIFY(accounts.login("ada", kPassword).error().message.find("wait 4 s") != std::string::npos);
    f.clock->advance_s(4);
    REQUIRE(accounts.login("ada", kPassword));
    REQUIRE(accounts.login("ada", kPassword)); // counted from the start again
    QVERIFY(!accounts.login("ada", "wrong word 12"));
    REQUIRE(accounts.login("ada", kPassword));
}

void TestAccounts::refusalsSayHowLongToWait() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    const auto tim = f.person(*ada, "tim", {Role::trainee});
    AccountService accounts(*f.database);
    for (const std::int64_t seconds : {0, 0, 2}) {
        const auto refused = accounts.tryLogin("tim", "wrong word 12");
        QVERIFY(!refused && refused.error().kind == Refusal::Kind::wrong);
        QCOMPARE(refused.error().wait_ns, seconds * 1'000'000'000); // of the attempt after this one
    }
    const auto early = accounts.tryLogin("tim", kPassword);
    QVERIFY(!early && early.error().kind == Refusal::Kind::mustWait);
    QCOMPARE(early.error().wait_ns, std::int64_t{2'000'000'000});
    f.clock->advance_s(2);
    REQUIRE(accounts.login("tim", kPassword));
    const auto nobody = accounts.tryLogin("nobody", kPassword);
    QVERIFY(!nobody && nobody.error().kind == Refusal::Kind::wrong && nobody.error().wait_ns == 0);
    REQUIRE(accounts.setEnabled(*ada, tim->personId(), false));
    const auto disabled = accounts.tryLogin("tim", kPassword);
    QVERIFY(!disabled && disabled.error().kind == Refusal::Kind::disabled);
    QVERIFY(accounts.tryConfirm(*ada, kPassword).has_value());
    const auto code = accounts.tryRecover("ada", "not the code", "newer horse 77");
    QVERIFY(!code && code.error().kind == Refusal::Kind::wrong);
    const auto weak = accounts.tryRecover("ada", "not the code", "short");
    QVERIFY(!weak && weak.error().kind == Refusal::Kind::failed);
}

void TestAccounts::waitSurvivesRestartsAndClocksSetBack() {
    DatabaseFixture f;
    REQUIRE(f.create());
    REQUIRE(f.administrator());
    for (int i = 0; i < 6; ++i) {
        f.clock->advance_s(100);
        QVERIFY(!AccountService(*f.database).login("ada", "wrong word 12"));
    }
    REQUIRE(f.reopen()); // the program restarts
    AccountService accounts(*f.database);
    QVERIFY(accounts.login("ada", kPassword).error().message.find("wait 16 s") != std::string::npos);
    f.clock->time = {"boot-b", 5}; // the machine restarts: its clock starts low, the whole wait counts again
    QVERIFY(accounts.login("ada", kPassword).error().message.find("wait 16 s") != std::string::npos);
    f.clock->advance_s(15);
    QVERIFY(accounts.login("ada", kPassword).error().message.find("wait 1 s") != std::string::npos);
    f.clock->time.now_ns = 5; // even a clock that goes back never makes the wait longer than whole
    QVERIFY(accounts.login("ada", kPassword).error().message.find("wait 16 s") != std::string::npos);
    f.clock->advance_s(16);
    REQUIRE(accounts.login("ada", kPassword));
}

void TestAccounts::readOnlyLoginHonoursTheWait() {
    DatabaseFixture f;
    REQUIRE(f.create());
    REQUIRE(f.administrator());
    auto beside = Database::openReadOnly(f.path(), f.options);
    REQUIRE(beside);
    AccountService reading(**beside);
    REQUIRE(reading.login("ada", kPassword));
    QVERIFY(!reading.login("ada", "wrong word 12"));
    for (int i = 0; i < 3; ++i) {
        QVERIFY(!AccountService(*f.database).login("ada", "wrong word 12"));
    }
    QVERIFY(reading.login("ada", kPassword).error().message.find("wait") != std::string::npos);
}

void TestAccounts::unknownNamesReadLikeWrongPasswords() {
    DatabaseFixture f;
    REQUIRE(f.create());
    REQUIRE(f.administrator());
    AccountService accounts(*f.database);
    const std::string known = accounts.login("ada", "wrong word 12").error().message;
    for (const char* name : {"nobody", "simulated", "", "ada' --"}) {
        QCOMPARE(accounts.login(name, "wrong word 12").error().message, known);
        QCOMPARE(accounts.login(name, "").error().message, known);
    }
}

void TestAccounts::resetForcesAChange() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(ada);
    const auto tim = f.person(*ada, "tim", {Role::trainee});
    REQUIRE(tim);
    AccountService accounts(*f.database);
    const auto tom = f.person(*ada, "tom-the-trainer", {Role::trainer});
    REQUIRE(tom);
    QCOMPARE(accounts.resetPassword(*ada, tom->personId(), "Tom-the-Trainer").error().code,
             core::ErrorCode::badInput); // the login name is no password
    REQUIRE(accounts.resetPassword(*ada, tim->personId(), "given by ada"));
    const auto forced = accounts.login("tim", "given by ada");
    REQUIRE(forced);
    QVERIFY(forced->mustChangePassword());
    QCOMPARE(storeSession(*f.database, *forced).error().code, core::ErrorCode::notAllowed);
    QCOMPARE(accounts.changePassword(*forced, "not the word", "my own word").error().code,
             core::ErrorCode::notAllowed);
    QCOMPARE(accounts.changePassword(*forced, "given by ada", "given by ada").error().code,
             core::ErrorCode::badInput);
    REQUIRE(accounts.changePassword(*forced, "given by ada", "my own word"));
    const auto again = accounts.login("tim", "my own word");
    REQUIRE(again);
    QVERIFY(!again->mustChangePassword());
    REQUIRE(storeSession(*f.database, *again));
}

void TestAccounts::lastAdministratorStays() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(ada);
    AccountService accounts(*f.database);
    QCOMPARE(accounts.setEnabled(*ada, ada->personId(), false).error().code, core::ErrorCode::wrongUse);
    QCOMPARE(accounts.setRoles(*ada, ada->personId(), {Role::trainer}).error().code,
             core::ErrorCode::wrongUse);
    const auto eva = f.person(*ada, "eva", {Role::admin, Role::trainer});
    REQUIRE(eva);
    REQUIRE(accounts.setEnabled(*eva, ada->personId(), false));
    QCOMPARE(accounts.setRoles(*eva, eva->personId(), {Role::trainer}).error().code,
             core::ErrorCode::wrongUse); // ada is disabled
    QCOMPARE(accounts.setRoles(*eva, ada->personId(), {}).error().code, core::ErrorCode::badInput);
    QCOMPARE(accounts.setEnabled(*eva, Actor::kSimulatedPerson, false).error().code,
             core::ErrorCode::notFound);
    QCOMPARE(accounts.setEnabled(*eva, 4711, false).error().code, core::ErrorCode::notFound);
}

QTEST_GUILESS_MAIN(TestAccounts)
#include "test_accounts.moc"
