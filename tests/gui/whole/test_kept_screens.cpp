// SPDX-License-Identifier: GPL-3.0-or-later
// How every screen is made (support/screen_outline.h), and what its own widgets paint
// (support/painted_parts.h), against what was looked at and kept: a widget that is in no layout any more, a
// margin, a name that a screen reader says, a row of a table, a line of a picture. And what each says where
// the database refuses what it wants to read. An intended change is kept
// anew, and the difference is read in review: CHIRON_STORE_OUTLINES=1 xvfb-run -a
// build/release/tests/gui/whole/test_kept_screens
#include "desktop/debrief/debrief_data.h"
#include "desktop/frame/messages.h"
#include "desktop/home/comment_list.h"
#include "desktop/home/home_data.h"
#include "desktop/playback/playback_data.h"
#include "desktop/results/results_data.h"
#include "desktop/screen_catalogue.h"
#include "desktop/sessions/session_row.h"
#include "desktop/station/station_facts.h"
#include "desktop/storage/storage_facts.h"
#include "desktop/studies/study_jobs.h"
#include "desktop/study_data/study_facts.h"
#include "support/every_place.h"
#include "support/kept_text.h"
#include "support/painted_parts.h"
#include "support/refusing_opened.h"
#include "support/screen_outline.h"
#include "support/settled.h"

#include <QLabel>

using namespace chiron;

namespace {

/// Reads something for a screen; whether it could.
struct Reader {
    const char* name;
    std::function<bool()> read;
    bool goesOn = false; ///< without some of what it would read
};

} // namespace

class TestKeptScreens : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        qputenv("CHIRON_NO_SOUND", "1"); // what the check before freezing says does not depend on the machine
        m_desktop = std::make_unique<tests::DesktopFixture>();
        m_sessions = tests::addVisitedSessions(*m_desktop);
        m_studies = tests::addVisitedStudies(*m_desktop);
        m_places = tests::everyPlace(m_sessions, m_studies);
        m_desktop->window->resize(1280, 720);
    }
    void isMadeAsItWas_data() {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < m_places.size(); ++i)
            // What a running session says is of the moment, and sealed codes are drawn.
            if (m_places[i].place.screen != QLatin1String("training") &&
                !QByteArray(m_places[i].name).endsWith("_blind"))
                QTest::newRow(m_places[i].name) << static_cast<int>(i);
    }
    void isMadeAsItWas() {
        QFETCH(int, index);
        const tests::VisitedPlace& place = m_places[static_cast<std::size_t>(index)];
        const QString name = QString::fromLatin1(place.name);
        QVERIFY2(tests::visit(*m_desktop, place, m_person), place.name);
        QStringList now;
        for (int quiet = 0, look = 0; quiet < 3 && look < 400; ++look) { // until what workers bring is there
            QTest::qWait(20);
            QStringList next = tests::ScreenOutline::of(*m_desktop->window->screen());
            next << tests::ScreenOutline::focusOn(*m_desktop->window->screen());
            quiet = next == now && tests::waitUntilLoaded(*m_desktop) ? quiet + 1 : 0;
            now = next;
        }
        const QString differs = m_kept.differs(name, now);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
        if (const QStringList painted = tests::paintedParts(*m_desktop->window->screen());
            !painted.isEmpty()) {
            const QString paints = m_painted.differs(name, painted);
            QVERIFY2(paints.isEmpty(), qPrintable(paints));
        }
        ++m_held;
    }
    /// Each screen where nothing can be read any more, once somebody has logged in.
    void saysWhatItCannotRead_data() { isMadeAsItWas_data(); }
    void saysWhatItCannotRead() {
        QFETCH(int, index);
        const tests::VisitedPlace& place = m_places[static_cast<std::size_t>(index)];
        const bool loggedIn = place.person[0] != '\0';
        QVERIFY(tests::visit(
            *m_desktop,
            {place.name, place.person, {loggedIn ? QStringLiteral("home") : QStringLiteral("login"), {}}},
            m_person));
        QStringList said;
        {
            const tests::RefusingAllOpened refusing(tests::RefusingAllOpened::kAll);
            QObject listens;
            connect(&m_desktop->context.messages(), &desktop::Messages::told, &listens,
                    [&said](const desktop::Message& message) {
                        said << QStringLiteral("message %1 \"%2\"")
                                    .arg(static_cast<int>(message.kind))
                                    .arg(tests::withoutToday(message.text).simplified());
                    });
            m_desktop->context.navigator().replace(place.place);
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            QVERIFY2(tests::waitUntilLoaded(*m_desktop), place.name);
            for (const auto* panel : m_desktop->window->screen()->findChildren<desktop::StatePanel*>()) {
                QString line = QStringLiteral("panel of state %1").arg(static_cast<int>(panel->state()));
                for (const char* part : {"state.title", "state.text"})
                    if (const auto* words = panel->findChild<QLabel*>(QLatin1String(part));
                        words && panel->state() != desktop::StatePanel::State::content)
                        line +=
                            QStringLiteral(" \"%1\"").arg(tests::withoutToday(words->text()).simplified());
                said << line;
            }
        }
        const QString differs = m_unread.differs(QString::fromLatin1(place.name),
                                                 said + QStringList{QStringLiteral("that is all")});
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
        ++m_refused;
    }
    /// Statement after statement is refused: a reader fails, or it is one that goes on without; none takes
    /// something for read that is not.
    void everyReaderTellsWhatItCannotRead_data() {
        QTest::addColumn<int>("index");
        int index = 0;
        for (const Reader& reader : readers())
            QTest::newRow(reader.name) << index++;
    }
    void everyReaderTellsWhatItCannotRead() {
        QFETCH(int, index);
        const Reader reader = readers()[static_cast<std::size_t>(index)];
        int statements = 0;
        {
            const tests::RefusingAllOpened none(0);
            QVERIFY(reader.read());
            statements = none.seen();
        }
        QVERIFY(statements > 0);
        constexpr int kMost = 60; // of a loop the later ones are as the earlier
        QStringList without;
        for (int which = 1; which <= std::min(statements, kMost); ++which) {
            const tests::RefusingAllOpened one(which);
            if (reader.read())
                without << QString::number(which);
        }
        QVERIFY2(reader.goesOn ? without.size() < std::min(statements, kMost) : without.isEmpty(),
                 qPrintable(QStringLiteral("not told of %1").arg(without.join(QLatin1Char(' ')))));
    }
    /// What nobody asks for again is no longer kept.
    void keepsNothingOfNoScreen() {
        if (m_held > 1) // not of one row alone
            QCOMPARE(m_kept.unseen() + m_painted.unseen(), QStringList());
        if (m_refused > 1)
            QCOMPARE(m_unread.unseen(), QStringList());
    }
    void cleanupTestCase() { m_desktop.reset(); }

private:
    /// Of one connection that is opened for it.
    template <class Read> std::function<bool()> onOne(Read read) {
        return [this, read] {
            auto connection = m_desktop->database().openReader();
            return connection.has_value() && read(**connection).has_value();
        };
    }
    std::vector<Reader> readers() {
        const auto ada = m_desktop->actor("ada"), tom = m_desktop->actor("tom"),
                   tina = m_desktop->actor("tina"), rhea = m_desktop->actor("rhea");
        const desktop::ExerciseTitles titles =
            desktop::exerciseTitles(m_desktop->site.catalogue(), QStringLiteral("en"));
        database::Database& site = m_desktop->database();
        const auto on = [](double) { return true; };
        const database::SessionId good = m_sessions.good;
        const database::StudyNumber study = m_studies.data;
        using database::Connection;
        return {
            {"home",
             [this, &site, ada, titles] {
                 return desktop::readHome(site, {ada,
                                                 titles,
                                                 m_desktop->site.catalogue(),
                                                 {},
                                                 m_desktop->file().toStdString(),
                                                 m_desktop->folder().toStdString()})
                     .has_value();
             },
             true},
            {"comments",
             [&site, tina, titles] { return desktop::readComments(site, tina, titles).has_value(); }, true},
            {"sessions",
             [&site, tom, titles] { return desktop::readSessionRows(site, tom, titles, {}).has_value(); }},
            {"one session", [&site, tom, titles,
                             good] { return desktop::readSessionRow(site, tom, titles, good).has_value(); }},
            {"debrief",
             onOne([tina, good](Connection& c) { return desktop::loadDebriefHead(c, tina, good, "en"); }),
             true},
            {"details of a debrief", onOne([tina, good](Connection& c) {
                 const std::atomic<bool> cancelled{false};
                 return desktop::loadDebriefDetails(c, tina, good, cancelled);
             }),
             true},
            {"playback",
             onOne([tina, good, on](Connection& c) { return desktop::loadPlayback(c, tina, good, on); }),
             true},
            {"sessions beside it", onOne([tina, good](Connection& c) -> core::Result<void> {
                 const auto record = database::SessionReader(c, tina).session(good);
                 CHIRON_TRY(record);
                 CHIRON_TRY(desktop::listGhosts(c, tina, *record, "force_max", true));
                 return {};
             }),
             true},
            {"results", onOne([tina, on](Connection& c) {
                 return desktop::loadAttempts(c, tina, tina.personId(), on);
             })},
            {"one's own data", onOne([tina, on](Connection& c) {
                 const QTemporaryDir folder;
                 return desktop::exportOwnData(c, tina, folder.path().toStdString(), on);
             }),
             true},
            {"station", [&site, ada] { return desktop::readStationFacts(site, ada).has_value(); }, true},
            {"storage",
             [this, &site, ada] {
                 return desktop::readStorageFacts(site, ada, m_desktop->folder().toStdString()).has_value();
             },
             true},
            {"study", onOne([rhea, study](Connection& c) {
                 database::StudyReader reader(c, rhea);
                 return desktop::openStudy(reader, study);
             })},
            {"data of a study", onOne([rhea, study](Connection& c) {
                 database::StudyReader reader(c, rhea);
                 return desktop::studyFacts(reader, study);
             }),
             true}};
    }

    std::unique_ptr<tests::DesktopFixture> m_desktop;
    tests::VisitedSessions m_sessions;
    tests::VisitedStudies m_studies;
    std::vector<tests::VisitedPlace> m_places;
    std::string m_person;
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/whole/kept_screens.txt")};
    tests::KeptText m_painted{QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/whole/kept_painted.txt"),
                              &tests::KeptText::nearly};
    tests::KeptText m_unread{QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/whole/kept_unread.txt")};
    int m_held = 0;
    int m_refused = 0;
};

QTEST_MAIN(TestKeptScreens)
#include "test_kept_screens.moc"
