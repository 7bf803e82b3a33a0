// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_people.h"

#include "database/boot_clock.h"
#include "database/repositories/audit_repository.h"
#include "database/repositories/site_repository.h"
#include "database/repositories/station_repository.h"
#include "database/repositories/study_rules.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <array>
#include <ctime>
#include <set>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

/// What is done is noted once: by whom, to what, with what detail; and what such notes are made of.
class TestAuditEntries : public QObject, StudyPeople {
    Q_OBJECT
private slots:
    void init() { begin(); }
    void peopleAreNoted();
    void sessionsAreNoted();
    void studiesAreNoted();
    void upkeepIsNoted();
    void stationChecksHoldTheSerialNumber();
    void theSitesNameIsChangedByAnAdministrator();
    void thePersonsOwnAreTheSame();
    void codesTakeTheirBytesInTurn();
    void theSystemsClockIsSinceItsStart();

private:
    /// What was noted after `before`, oldest first: "actor action table number".
    QStringList since(std::size_t before) {
        const auto all = AuditRepository(*reader(), m_admin).listAudit().value();
        QStringList lines;
        for (std::size_t i = 0; i + before < all.size(); ++i) {
            const AuditEntry& entry = all[i];
            lines.prepend(QStringLiteral("%1 %2 %3 %4 %5")
                              .arg(QString::fromStdString(entry.actorKind))
                              .arg(entry.actor)
                              .arg(QString::fromStdString(entry.action), QString::fromStdString(entry.target))
                              .arg(entry.targetId));
        }
        return lines;
    }
    std::size_t count() { return AuditRepository(*reader(), m_admin).listAudit()->size(); }
    QString by(const Actor& actor, const char* rest) {
        return QStringLiteral("person %1 %2").arg(actor.personId()).arg(QLatin1String(rest));
    }
    QJsonObject lastDetail() {
        return QJsonDocument::fromJson(
                   QByteArray::fromStdString(
                       AuditRepository(*reader(), m_admin).listAudit(1)->front().detailJson))
            .object();
    }
};

void TestAuditEntries::peopleAreNoted() {
    const auto all = AuditRepository(*reader(), m_admin).listAudit();
    REQUIRE(all);
    for (std::size_t i = 0; i < all->size(); ++i) { // newest first, from 1, without a gap
        QCOMPARE(all->at(i).sequence, static_cast<std::int64_t>(all->size() - i));
        QVERIFY(!all->at(i).utc.empty());
    }
    QCOMPARE(AuditRepository(*reader(), m_admin).listAudit(2)->size(), std::size_t{2});
    QCOMPARE(AuditRepository(*reader(), m_admin).listAudit(1)->size(), std::size_t{1});
    AccountService accounts(*m->database);
    const std::size_t before = count();
    const auto tim = accounts.createPerson(m_admin, {"tim", "Tim", {Role::trainee}, kPassword, false});
    REQUIRE(tim);
    QCOMPARE(PrivacyRepository(*reader(), m_admin).exportPerson(*tim)->failedLogins, 0); // nobody tried yet
    const QString code = QString::fromStdString(
        selectText(*reader(), "SELECT code FROM person_code WHERE person_id = ?", {*tim})->value_or(""));
    QVERIFY2(QRegularExpression(QStringLiteral("^P-[A-HJ-NP-Z2-9]{8}$")).match(code).hasMatch(),
             qPrintable(code));
    const auto self = accounts.login("tim", kPassword);
    REQUIRE(self);
    REQUIRE(accounts.changePassword(*self, kPassword, "another horse 8"));
    REQUIRE(accounts.resetPassword(m_admin, *tim, kPassword));
    REQUIRE(accounts.makeRecoveryCode(m_admin, kPassword));
    REQUIRE(accounts.setRoles(m_admin, *tim, {Role::trainee, Role::trainer}));
    REQUIRE(accounts.setEnabled(m_admin, *tim, false));
    REQUIRE(accounts.setEnabled(m_admin, *tim, true));
    REQUIRE(accounts.erasePerson(m_admin, kPassword, *tim, "wish", false));
    const QString number = QString::number(*tim);
    // Whoever confirms with a password is noted as logged in.
    const QStringList expected{by(m_admin, "createPerson person ") + number,
                               by(*self, "login person ") + number,
                               by(*self, "login person ") + number,
                               by(*self, "changePassword credential ") + number,
                               by(m_admin, "resetPassword credential ") + number,
                               by(m_admin, "login person ") + QString::number(m_admin.personId()),
                               by(m_admin, "setRecoveryCode credential ") +
                                   QString::number(m_admin.personId()),
                               by(m_admin, "setRoles person ") + number,
                               by(m_admin, "disable person ") + number,
                               by(m_admin, "enable person ") + number,
                               by(m_admin, "login person ") + QString::number(m_admin.personId()),
                               by(m_admin, "erase person ") + number};
    QCOMPARE(since(before), expected);
}

void TestAuditEntries::sessionsAreNoted() {
    (void)storeSession(*m->database, m_ruth, 1); // numbers of tables are not the same
    const std::size_t before = count();
    const auto id = storeSession(*m->database, m_ruth, 1);
    REQUIRE(id);
    const auto done = m->database->write([&](WriteContext& w) -> core::Result<void> {
        SessionRepository sessions(w.connection(), m_admin);
        const auto comment = sessions.addComment(*id, "a word");
        auto good = comment ? sessions.setArchived(*id, true) : tl::unexpected(comment.error());
        good = good ? sessions.setArchived(*id, false) : good;
        return good ? sessions.voidSession(*id, "the chair fell") : good;
    });
    REQUIRE(done);
    QCOMPARE(since(before),
             (QStringList{by(m_ruth, "beginSession session 2"), by(m_ruth, "finishSession session 2"),
                          by(m_ruth, "storeScores score_set 2"), by(m_admin, "addComment session_comment 1"),
                          by(m_admin, "archive session 2"), by(m_admin, "unarchive session 2"),
                          by(m_admin, "voidSession session 2")}));
    const auto simulated = storeSession(*m->database, Actor::simulated(), 1);
    REQUIRE(simulated);
    QCOMPARE(since(before).at(7),
             QStringLiteral("simulated %1 beginSession session 3").arg(Actor::kSimulatedPerson));
}

void TestAuditEntries::studiesAreNoted() {
    (void)frozen("other");
    const std::size_t before = count();
    const StudyNumber study = frozen("noted");
    const ParticipantNumber who = consented(study);
    const auto run = write(m_ruth, [&](StudyRepository& s) {
        return s.beginRun({who, codeOf(*reader(), study, "soft"), 0, 1, "descending@1"});
    });
    REQUIRE(run);
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.storeStudyTrial(someTrial(*run, 0)); }));
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.finishRun(*run, StudyRunState::stopped); }));
    REQUIRE(write(m_ruth, [&](StudyRepository& s) {
        return s.storeQuestionnaireAnswers({{who, "face", "real", 4.0, "", ""}});
    }));
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.withdrawParticipant(who, false); }));
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.closeStudy(study); }));
    REQUIRE(write(m_admin, [&](StudyRepository& s) { return s.setStudyArchived(study, true); }));
    REQUIRE(write(m_admin, [&](StudyRepository& s) { return s.setStudyArchived(study, false); }));
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.unblindStudy(study, "all are \"done\""); }));
    QCOMPARE(lastDetail()["reason"].toString(), QStringLiteral("all are \"done\""));
    QCOMPARE(since(before),
             (QStringList{by(m_ruth, "createStudy study 2"), by(m_ruth, "freezeStudy study 2"),
                          by(m_ruth, "enrolParticipant study_participant 1"),
                          by(m_ruth, "enrolParticipant participant_key 1"),
                          by(m_ruth, "recordConsent participant_consent 1"),
                          by(m_ruth, "recordConsent study_participant 1"), by(m_ruth, "beginRun study_run 1"),
                          by(m_ruth, "finishRun study_run 1"),
                          by(m_ruth, "storeQuestionnaireAnswers questionnaire_answer 1"),
                          by(m_ruth, "withdrawParticipant study_participant 1"),
                          by(m_ruth, "closeStudy study 2"), by(m_admin, "archiveStudy study 2"),
                          by(m_admin, "unarchiveStudy study 2"), by(m_ruth, "unblindStudy study 2")}));
}

void TestAuditEntries::upkeepIsNoted() {
    const std::size_t before = count();
    const auto info = Upkeep::backup(*m->database, m_admin, m->path("backup"));
    REQUIRE(info);
    QCOMPARE(info->folder, m->path("backup"));
    QCOMPARE(info->databaseFile, std::string("chiron.db"));
    QCOMPARE(info->bytes, static_cast<std::uint64_t>(
                              QFileInfo(QString::fromStdString(m->path("backup/chiron.db"))).size()));
    QCOMPARE(info->auditCount, static_cast<std::int64_t>(before));
    QCOMPARE(lastDetail()["blake2b"].toString().toStdString(), info->blake2b);
    REQUIRE(Upkeep::exportSite(*m->database, m_admin, m->path("export")));
    QCOMPARE(since(before), (QStringList{by(m_admin, "backup meta 0"), by(m_admin, "exportSite meta 0")}));
    m->database.reset();
    REQUIRE(Upkeep::restore(requestFor(*m, m->path("backup")), m->options));
    REQUIRE(m->reopen());
    QVERIFY(since(before).constLast().endsWith(QStringLiteral("restore meta 0")));
    QCOMPARE(lastDetail()["head_count"].toInt(), static_cast<int>(before) + 2); // where the chain was cut
}

void TestAuditEntries::thePersonsOwnAreTheSame() {
    REQUIRE(storeSession(*m->database, m_ruth, 1));
    const auto held = PrivacyRepository(*reader(), m_admin).exportPerson(m_ruth.personId());
    REQUIRE(held);
    QVERIFY(held->audit.size() >= 4);
    const auto all = AuditRepository(*reader(), m_admin).listAudit();
    for (const AuditEntry& own : held->audit) {
        const AuditEntry& entry = all->at(all->size() - static_cast<std::size_t>(own.sequence));
        QVERIFY(own.sequence == entry.sequence && own.utc == entry.utc && own.actorKind == entry.actorKind &&
                own.actor == entry.actor && own.action == entry.action && own.target == entry.target &&
                own.targetId == entry.targetId && own.detailJson == entry.detailJson);
    }
}

// Each of five attempts has six bytes of its own, two a letter, so that where two conditions draw alike
// another attempt is another draw.
void TestAuditEntries::codesTakeTheirBytesInTurn() {
    RowDigest digest{};
    std::array<std::string, 5> plain;
    for (int attempt = 0; attempt < 5; ++attempt) {
        plain[static_cast<std::size_t>(attempt)] = codeFrom(digest, attempt);
        QCOMPARE(plain[static_cast<std::size_t>(attempt)].size(), std::size_t{3});
    }
    for (std::size_t byte = 0; byte < digest.size(); ++byte) {
        RowDigest changed = digest;
        changed[byte] = 1;
        for (std::size_t attempt = 0; attempt < 5; ++attempt) {
            const std::string code = codeFrom(changed, static_cast<int>(attempt));
            for (std::size_t letter = 0; letter < 3; ++letter) {
                QCOMPARE(code[letter] != plain[attempt][letter], byte / 2 == 3 * attempt + letter);
            }
        }
    }
    RowDigest known{};
    known[0] = 1;
    known[1] = 2;
    QCOMPARE(codeFrom(known, 0)[0], 'G');            // 258 is 5 beyond a multiple of the 23 symbols
    for (int attempt = 5; attempt < 40; ++attempt) { // further attempts stay within the digest
        QCOMPARE(codeFrom(digest, attempt).size(), std::size_t{3});
    }
    std::set<char> letters; // all of them come
    for (int i = 0; i < 256; ++i) {
        RowDigest of{};
        of[1] = static_cast<std::uint8_t>(i);
        letters.insert(codeFrom(of, 0)[0]);
    }
    QCOMPARE(QString::fromStdString(std::string(letters.begin(), letters.end())),
             QStringLiteral("34679ACDEFGHJKMNPQRTWXY"));
}

/// Where the device tells one; anything else than printable ASCII is no serial number.
void TestAuditEntries::stationChecksHoldTheSerialNumber() {
    const auto checked = [&](const std::string& serial) {
        return m->database->write([&](WriteContext& w) {
            return StationRepository(w.connection(), m_ruth)
                .recordStationCheck({"loop", "simulated", "1", true, serial});
        });
    };
    REQUIRE(checked(""));
    QVERIFY(!lastDetail().contains("serial"));
    REQUIRE(checked("SN-7 / 12"));
    QCOMPARE(lastDetail()["serial"].toString(), QStringLiteral("SN-7 / 12"));
    QCOMPARE(checked("SN\n7").error().code, core::ErrorCode::badInput);
}

/// A site's name is known to everybody, changed by administrators alone, and each change stands in the audit
/// trail.
void TestAuditEntries::theSitesNameIsChangedByAnAdministrator() {
    auto reader = m->database->openReader();
    REQUIRE(reader);
    const auto named = [&](const Actor& actor, const std::string& name) {
        return m->database->write(
            [&](WriteContext& w) { return SiteRepository(w.connection(), actor).setSiteName(name); });
    };
    const auto known = [&] {
        return SiteRepository(**reader, Actor::anonymous()).siteName().value_or("failed");
    };
    QCOMPARE(known(), std::string());
    REQUIRE(named(m_admin, "  Nordklinik, Lehrstation 2 "));
    QCOMPARE(known(), std::string("Nordklinik, Lehrstation 2"));
    QCOMPARE(lastDetail()["name"].toString(), QStringLiteral("Nordklinik, Lehrstation 2"));
    QCOMPARE(named(m_ruth, "Another").error().code, core::ErrorCode::notAllowed);
    QCOMPARE(named(m_admin, std::string(std::size_t{kMaximumSiteNameCharacters} + 1, 'x')).error().code,
             core::ErrorCode::badInput);
    QCOMPARE(named(m_admin, "two\nlines").error().code, core::ErrorCode::badInput);
    QCOMPARE(known(), std::string("Nordklinik, Lehrstation 2"));
    REQUIRE(named(m_admin, ""));
    QCOMPARE(known(), std::string());
}

// Nanoseconds since the machine started, sleep included, and the start by its own name.
void TestAuditEntries::theSystemsClockIsSinceItsStart() {
    const auto now_ns = [] {
        timespec spec{};
        clock_gettime(CLOCK_BOOTTIME, &spec);
        return spec.tv_sec * std::int64_t{1'000'000'000} + spec.tv_nsec;
    };
    const SystemBootClock clock;
    const std::int64_t before_ns = now_ns();
    const BootTime time = clock.now();
    const std::int64_t after_ns = now_ns();
    QVERIFY(before_ns <= time.now_ns && time.now_ns <= after_ns);
    QCOMPARE(time.bootId, contentOf("/proc/sys/kernel/random/boot_id").trimmed().toStdString());
    QVERIFY(!time.bootId.empty());
}

QTEST_GUILESS_MAIN(TestAuditEntries)
#include "test_audit_entries.moc"
