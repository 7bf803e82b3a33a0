// SPDX-License-Identifier: GPL-3.0-or-later
// Maps of a palpation as pictures: what was searched, how hard, where lumps and findings lie.
// CHIRON_KEEP_PICTURES=<folder> keeps them.
#include "app/exercises/palpation/report/palpation_map_painter.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using namespace chiron::report;
using simulation::FindingOutcome;
using simulation::MapBand;
using simulation::MapBands;
using simulation::SurfaceMap;
using simulation::SurfaceMapKind;

namespace {

constexpr QSize kSize(560, 380);

PlotTheme plainTheme() {
    PlotTheme theme;
    theme.family = reportFontFamily();
    return theme;
}

PlotTheme themed(const char* paper, const char* ink, const char* muted, const char* accent, const char* good,
                 const char* bad) {
    PlotTheme theme = plainTheme();
    theme.paper = QColor(QLatin1String(paper));
    theme.ink = QColor(QLatin1String(ink));
    theme.muted = QColor(QLatin1String(muted));
    theme.accent = QColor(QLatin1String(accent));
    theme.good = QColor(QLatin1String(good));
    theme.bad = QColor(QLatin1String(bad));
    return theme;
}

std::vector<std::pair<QString, PlotTheme>> themes() {
    return {{"light", plainTheme()},
            {"dark", themed("#18232c", "#e8eff4", "#a9b8c3", "#4db3dd", "#63cf9b", "#ff8a84")},
            {"contrast", themed("#000000", "#ffffff", "#e6e6e6", "#ffe14d", "#5dff9b", "#ff9d98")}};
}

/// The left half pressed in vertical strips, harder from strip to strip: 0.3, 0.7, 1.5, 3.0, 5.0 N; the right
/// half not touched.
SurfaceMap strips() {
    SurfaceMap map({0.040, 0.040}, 0.0045, 0.5);
    const double forces[] = {0.3, 0.7, 1.5, 3.0, 5.0};
    for (int strip = 0; strip < 5; ++strip)
        for (double y = -0.040; y <= 0.040; y += 0.002)
            map.press({-0.036 + 0.008 * strip, y}, forces[strip]);
    return map;
}

PalpationMapView view(SurfaceMapKind kind) {
    PalpationMapView view;
    view.kind = kind;
    view.lumps = {{-0.018, 0.012, 0.012, 0.0075, 5, true}, {0.022, -0.020, 0.010, 0.005, 3, false}};
    view.findings = {{1, -0.016, 0.014, 0.006, FindingOutcome::hit, false},
                     {2, 0.010, 0.026, 0.0, FindingOutcome::falseAlarm, true},
                     {3, 0.030, 0.008, 0.0, FindingOutcome::open, false}};
    return view;
}

/// W's place in the picture.
QPoint placeOf(const SurfaceMap& map, const PalpationMapView& view, double x_m, double y_m,
               const PlotTheme& theme) {
    const QRectF plot = PalpationMapPainter(map, view, theme).plotIn(QRectF(QPointF(0, 0), QSizeF(kSize)));
    return (plot.center() + QPointF(0.5 * plot.width() * x_m / map.half_m().x(),
                                    -0.5 * plot.height() * y_m / map.half_m().y()))
        .toPoint();
}

double luminance(const QColor& colour) {
    const auto linear = [](double v) {
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

int differing(const QImage& a, const QImage& b) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
    return count;
}

} // namespace

class TestPalpationMap : public QObject {
    Q_OBJECT
private slots:
    void stepsHaveTheirEdges() {
        constexpr MapBands bands{0.5, 0.8, 2.5, 4.0};
        QVERIFY(bands.of(0.0) == MapBand::untouched && bands.of(0.02) == MapBand::untouched);
        QVERIFY(bands.of(0.021) == MapBand::light && bands.of(0.4999) == MapBand::light);
        QVERIFY(bands.of(0.5) == MapBand::gentle && bands.of(0.7999) == MapBand::gentle);
        QVERIFY(bands.of(0.8) == MapBand::inBand && bands.of(2.5) == MapBand::inBand);
        QVERIFY(bands.of(2.51) == MapBand::hard && bands.of(4.0) == MapBand::hard);
        QVERIFY(bands.of(4.01) == MapBand::over);
        QVERIFY(bands.of(std::nan("")) == MapBand::untouched);
        for (double force = 0.0; force < 5.0; force += 0.01)
            QCOMPARE(isSearched(bands.of(force)), force >= bands.cover_N);
    }

    void findingsLieWhereTheyWere() {
        const SurfaceMap map({0.050, 0.025}, 0.005, 0.5);
        for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.030, 0.0}, {0.0, 0.015}, {-0.030, -0.015}}) {
            PalpationMapView one;
            one.findings = {{1, x, y, 0.0, FindingOutcome::open, false}};
            PalpationMapView none = one; // the same legend
            none.findings[0].x_m = 0.015, none.findings[0].y_m = 0.008;
            const QImage marked = palpationMapPicture(map, one, {}, kSize);
            const QImage other = palpationMapPicture(map, none, {}, kSize);
            const QRect near(placeOf(map, one, x, y, {}) - QPoint(13, 13), QSize(26, 26));
            QVERIFY(differing(marked.copy(near), other.copy(near)) > 100);
        }
        const QRectF plot = PalpationMapPainter(map, {}, {}).plotIn(QRectF(0, 0, 560, 380));
        QVERIFY(std::abs(plot.width() - 2.0 * plot.height()) < 1e-9); // one scale
    }

    void forceStepsGetDarkerOrLighterOneByOne() {
        for (const auto& [name, theme] : themes()) {
            PalpationMapView plain;
            plain.kind = SurfaceMapKind::force;
            const SurfaceMap map = strips();
            const QImage picture = palpationMapPicture(map, plain, theme, kSize);
            const QPoint middle = placeOf(map, plain, -0.036 + 0.016, 0.006, theme);
            const QPoint first = placeOf(map, plain, -0.036, 0.006, theme);
            const double step = 0.5 * (middle.x() - first.x());
            double before = luminance(theme.paper);
            const double way = luminance(theme.accent) > before ? 1.0 : -1.0;
            for (int strip = 1; strip < 4; ++strip) { // searched, so not hatched
                const double now =
                    luminance(picture.pixelColor(qRound(first.x() + strip * step), middle.y()));
                QVERIFY2((now - before) * way > 0.015, qPrintable(QStringLiteral("%1, strip %2: %3 after %4")
                                                                      .arg(name)
                                                                      .arg(strip)
                                                                      .arg(now)
                                                                      .arg(before)));
                before = now;
            }
            int cross = 0; // the other way than what was not searched: bad and its hatch
            for (int y = 0; y < 20; ++y)
                cross +=
                    picture.pixelColor(qRound(first.x() + 4 * step), middle.y() + y) == theme.bad ? 1 : 0;
            QVERIFY(cross > 4 && cross < 20);
        }
    }

    void unsearchedIsHatchedAndSearchedIsNot() {
        const auto colours = [](const QImage& picture, QPoint at) {
            QSet<QRgb> seen;
            for (int y = -7; y <= 7; ++y)
                for (int x = -7; x <= 7; ++x)
                    seen.insert(picture.pixel(at + QPoint(x, y)));
            return seen.size();
        };
        SurfaceMap map;
        for (double y = -0.02; y <= 0.02; y += 0.002)
            for (double x = -0.02; x <= 0.02; x += 0.002)
                map.press({x, y}, 1.0);
        PalpationMapView plain;
        plain.regionColumns = plain.regionRows = 1;
        const QImage picture = palpationMapPicture(map, plain, {}, kSize);
        QCOMPARE(colours(picture, placeOf(map, plain, 0.0, 0.0, {})), qsizetype(1));
        QVERIFY(colours(picture, placeOf(map, plain, 0.033, 0.033, {})) > qsizetype(1));
    }

    void outcomesDifferInShapeNotInColourAlone() {
        PlotTheme grey; // where colours say nothing
        grey.good = grey.bad = grey.ink;
        std::vector<QImage> pictures;
        for (const FindingOutcome outcome :
             {FindingOutcome::open, FindingOutcome::hit, FindingOutcome::falseAlarm}) {
            PalpationMapView one;
            one.findings = {{1, 0.0, 0.0, 0.0, outcome, false}};
            pictures.push_back(palpationMapPicture(SurfaceMap(), one, grey, kSize).copy(0, 30, 250, 340));
        }
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY(differing(pictures[i], pictures[(i + 1) % 3]) > 60);
        PalpationMapView found, missed;
        found.lumps = {{0.0, 0.0, 0.012, 0.0075, 5, true}};
        missed.lumps = {{0.0, 0.0, 0.012, 0.0075, 5, false}};
        QVERIFY(differing(palpationMapPicture(SurfaceMap(), found, grey, kSize).copy(0, 30, 250, 340),
                          palpationMapPicture(SurfaceMap(), missed, grey, kSize).copy(0, 30, 250, 340)) > 30);
    }

    void truthIsNotToldWhereThereIsNone() {
        PalpationMapView open = view(SurfaceMapKind::coverage);
        open.lumps.clear();
        const SurfaceMap map = strips();
        const QString words = PalpationMapPainter(map, open, {}).words();
        QVERIFY(!words.contains(QStringLiteral("Lumps")));
        QVERIFY(words.contains(QStringLiteral("Findings reported: 3")) &&
                words.contains(QStringLiteral("False alarms: 1")));
        QVERIFY(PalpationMapPainter(map, view(SurfaceMapKind::coverage), {})
                    .words()
                    .contains(QStringLiteral("Lumps found: 1 of 2")));
    }

    void pictures() {
        const QString folder = qEnvironmentVariable("CHIRON_KEEP_PICTURES");
        for (const auto& [name, theme] : themes())
            for (const SurfaceMapKind kind : {SurfaceMapKind::coverage, SurfaceMapKind::force})
                for (const QSize size : {kSize, QSize(300, 520), QSize(120, 90)}) {
                    const QImage picture = palpationMapPicture(strips(), view(kind), theme, size, 2.0);
                    QCOMPARE(picture.size(), 2 * size);
                    if (!folder.isEmpty())
                        picture.save(
                            QStringLiteral("%1/map_%2_%3_%4.png")
                                .arg(folder, kind == SurfaceMapKind::force ? "force" : "coverage", name)
                                .arg(size.width()));
                }
    }
};

QTEST_MAIN(TestPalpationMap)
#include "test_palpation_map.moc"
