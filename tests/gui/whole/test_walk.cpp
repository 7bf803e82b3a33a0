// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/languages.h"
#include "desktop/screen_catalogue.h"
#include "support/every_place.h"
#include "support/settled.h"

using namespace chiron;

namespace {
constexpr int kThemes = 3;
}

/// Every screen, in every language and at both ends of the scale: nothing cut off, everything named and
/// reachable. The themes take turns, so that each meets both scales; with CHIRON_EVERY_LOOK every theme meets
/// every language and scale (the long test).
class TestWalk : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        qputenv("CHIRON_NO_SOUND", "1"); // what the check before freezing says does not depend on the machine
        m_desktop = std::make_unique<tests::DesktopFixture>();
        const tests::VisitedSessions sessions = tests::addVisitedSessions(*m_desktop);
        m_places = tests::everyPlace(sessions, tests::addVisitedStudies(*m_desktop));
    }
    void cleanupTestCase() { m_desktop.reset(); }

    void everyScreenFits_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<int>("theme");
        QTest::addColumn<double>("scale");
        const bool all = qEnvironmentVariableIsSet("CHIRON_EVERY_LOOK");
        const std::vector<std::string> languages = core::languageIds();
        for (std::size_t i = 0; i < languages.size(); ++i)
            for (int theme = 0; theme < kThemes; ++theme)
                for (const double scale : {1.0, 2.0}) {
                    if (!all && theme != (static_cast<int>(i) + (scale > 1.0 ? 1 : 0)) % kThemes)
                        continue;
                    const std::string& language = languages[i];
                    QTest::addRow("%s, theme %d, %.0f %%", language.c_str(), theme, scale * 100)
                        << QString::fromStdString(language) << theme << scale;
                }
    }

    void everyScreenFits() {
        QFETCH(QString, language);
        QFETCH(int, theme);
        QFETCH(double, scale);
        m_desktop->settings.setLanguage(language);
        m_desktop->settings.setTheme(static_cast<desktop::ThemeName>(theme));
        m_desktop->settings.setScale(scale);
        m_desktop->window->resize(1280, 720);
        m_desktop->context.applyAppearance();
        QStringList findings;
        for (const tests::VisitedPlace& place : m_places) {
            QVERIFY2(tests::visit(*m_desktop, place, m_person), place.name);
            QVERIFY2(m_desktop->window->screen(), place.name);
            QCOMPARE(m_desktop->window->screen()->objectName(),
                     QStringLiteral("screen.") + place.place.screen);
            for (const QString& finding : settledFindings())
                findings << QStringLiteral("%1: %2").arg(QLatin1String(place.name), finding);
        }
        findings.removeDuplicates();
        QVERIFY2(findings.isEmpty(), qPrintable(QLatin1Char('\n') + findings.join(QLatin1Char('\n'))));
    }

    void everyScreenHasHelpAndATitle() {
        for (const tests::VisitedPlace& place : m_places) {
            QVERIFY2(tests::visit(*m_desktop, place, m_person), place.name);
            QVERIFY2(m_desktop->window->screen()->help().size() > 40, place.name);
            QVERIFY2(!m_desktop->window->screen()->title().isEmpty(), place.name);
        }
    }

private:
    /// What is wrong with the screen, once its layouts are at rest.
    QStringList settledFindings() {
        QStringList found = tests::settledFindings(m_desktop->window.get(), 20);
        const QSize size = m_desktop->window->size(); // a screen must not force the window to grow
        if (size != QSize(1280, 720)) {
            found << QStringLiteral("makes the window %1 x %2").arg(size.width()).arg(size.height());
            m_desktop->window->resize(1280, 720);
        }
        return found;
    }

    std::unique_ptr<tests::DesktopFixture> m_desktop;
    std::vector<tests::VisitedPlace> m_places;
    std::string m_person;
};

QTEST_MAIN(TestWalk)
#include "test_walk.moc"
