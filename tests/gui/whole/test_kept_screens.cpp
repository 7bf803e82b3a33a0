// SPDX-License-Identifier: GPL-3.0-or-later
// How every screen is made (support/screen_outline.h), and what its own widgets paint
// (support/painted_parts.h), against what was looked at and kept: a widget that is in no layout any more, a
// margin, a name that a screen reader says, a row of a table, a line of a picture. An intended change is kept
// anew, and the difference is read in review: CHIRON_STORE_OUTLINES=1 xvfb-run -a
// build/release/tests/gui/whole/test_kept_screens
#include "desktop/screen_catalogue.h"
#include "support/every_place.h"
#include "support/kept_text.h"
#include "support/painted_parts.h"
#include "support/screen_outline.h"
#include "support/settled.h"

using namespace chiron;

class TestKeptScreens : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        qputenv("CHIRON_NO_SOUND", "1"); // what the check before freezing says does not depend on the machine
        m_desktop = std::make_unique<tests::DesktopFixture>();
        const tests::VisitedSessions sessions = tests::addVisitedSessions(*m_desktop);
        m_places = tests::everyPlace(sessions, tests::addVisitedStudies(*m_desktop));
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
    /// What nobody asks for again is no longer kept.
    void keepsNothingOfNoScreen() {
        if (m_held > 1) // not of one row alone
            QCOMPARE(m_kept.unseen() + m_painted.unseen(), QStringList());
    }
    void cleanupTestCase() { m_desktop.reset(); }

private:
    std::unique_ptr<tests::DesktopFixture> m_desktop;
    std::vector<tests::VisitedPlace> m_places;
    std::string m_person;
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/whole/kept_screens.txt")};
    tests::KeptText m_painted{QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/whole/kept_painted.txt"),
                              &tests::KeptText::nearly};
    int m_held = 0;
};

QTEST_MAIN(TestKeptScreens)
#include "test_kept_screens.moc"
