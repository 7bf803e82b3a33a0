// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/sphere_apex/report/apex_report.h"
#include "report/plot_canvas.h"
#include "report/plot_view.h"
#include "report/report_writer.h"
#include "report/session_plots.h"
#include "support/kept_pictures.h"
#include "support/pdf_text.h"

#include <QFontDatabase>
#include <QPainter>
#include <QPdfWriter>
#include <QProcess>
#include <QStandardPaths>
#include <QtTest>
#include <cmath>

using namespace chiron;
using namespace chiron::report;

// Set CHIRON_KEEP_PICTURES to a folder to look at what these tests draw.
class TestReportOutput : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void aFontPackageIsFound();
    void copiedTextIsTheTextSeen();
    void sessionReport_data();
    void sessionReport();
    void pictures();
    void aLeftMarginIsAsWideAsAsked();
    void theLimitIsVisibleWhereForceIsOverIt();
    void severalToolsHaveALineEach();
    void criticalErrorsAreCrosses();
    void comparison();
    void failuresNameThePath();

private:
    QString path(const QString& name) const { return m_folder + QLatin1Char('/') + name; }
    tests::KeptPictures m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/report/kept_reports.json")};
    QTemporaryDir m_temporary;
    QString m_folder;
};

namespace {

// A session as the exercise makes one: approach, circling contact, marks; values are made up for the
// pictures.
ReportData sample(std::size_t samples) {
    ReportData data;
    data.person = QStringLiteral("Dr Ada Example");
    data.exerciseTitle = QStringLiteral("Find the apex of a sphere");
    data.levelTitle = QStringLiteral("haptics alone");
    data.exerciseId = QStringLiteral("sphere_apex");
    data.level = 2;
    data.startedUtc = QDateTime(QDate(2026, 11, 20), QTime(11, 23, 45), Qt::UTC);
    data.offsetMinutes = 60;
    data.duration_s = 0.001 * static_cast<double>(samples);
    data.device = QStringLiteral("Simulated gimbal (H, P, R, D)");
    data.state = QStringLiteral("completed");
    data.passed = false;
    data.metrics = {{"apex_error_mean",
                     "Apex error, mean",
                     "%",
                     17.31,
                     {},
                     {},
                     15.0,
                     false,
                     true,
                     2.9,
                     25.5,
                     "published mean ± SD",
                     {}},
                    {"time", "Time", "s", 184.2, {}, {}, 300.0, true, true, {}, {}, {}, {}},
                    {"force_max", "Maximum force", "N", 4.62, {}, {}, 4.0, false, true, {}, {}, {}, {}},
                    {"apex_error_sd", "Apex error, SD", "%", 12.04, {}, {}, {}, {}, false, {}, {}, {}, {}},
                    {"path_inefficiency",
                     "Path inefficiency",
                     "%",
                     {},
                     "ends less than 5 mm apart",
                     {},
                     {},
                     {},
                     false,
                     {},
                     {},
                     {},
                     {}},
                    {"sparc", "Smoothness (SPARC)", "", -2.417, {}, {}, {}, {}, false, {}, {}, {}, {}}};
    const double misfit[10][2] = {{12, -8}, {-22, 5},   {7, 14},  {31, -19}, {-4, -11},
                                  {15, 3},  {-140, 60}, {9, -27}, {2, 6},    {-13, 18}};
    std::vector<ApexError> errors;
    for (int i = 0; i < 10; ++i)
        errors.push_back({i, misfit[i][0], misfit[i][1], i == 6, false});
    data.sections.push_back(std::make_shared<ApexSection>(std::move(errors)));
    SampleSeries& s = data.series;
    ToolSamples& tool = s.tools.emplace_back();
    for (std::size_t i = 0; i < samples; ++i) {
        const double t = 0.001 * static_cast<double>(i);
        const double search = std::exp(-std::fmod(t, 18.0) / 7.0);
        s.t_s.push_back(t);
        tool.x_mm.push_back(20.0 * search * std::cos(2.1 * t) + 8.0 * std::sin(0.05 * t));
        tool.y_mm.push_back(20.0 * search * std::sin(2.1 * t) - 6.0);
        tool.z_mm.push_back(20.0 - 9.0 * search);
        const double force = 1.4 + 0.9 * std::sin(3.0 * t) + (std::fmod(t, 36.0) < 0.9 ? 2.6 : 0.0);
        tool.tissue_N.push_back(std::max(0.0, force));
        tool.commanded_N.push_back(std::min(4.0, std::max(0.0, force)));
        tool.measured_N.push_back(std::min(4.0, std::max(0.0, force - 0.12)));
        tool.speed_mm_per_s.push_back(42.0 * search * (1.0 + 0.3 * std::sin(9.0 * t)));
    }
    for (int i = 0; i < 10; ++i)
        s.events.push_back({18.0 * i, QStringLiteral("trial %1").arg(i + 1)});
    s.paused = {{62.0, 71.5}};
    data.loop = {180000, 12, 0, true, 0.61, 1.9, 38.4};
    data.integrity = {"S-000042",
                      180000,
                      0,
                      3481220,
                      "0.1.0 gcc-12.2.0",
                      "9f2c4e0f7ad1c7f6a0a3a54f0a98c9d6f1b3b2f4e5d60718293a4b5c6d7e8f90",
                      {},
                      "0f1e2d3c4b5a69788796a5b4c3d2e1f00112233445566778899aabbccddeeff0",
                      {}};
    return data;
}

ReportData longAndGreek() {
    ReportData data = sample(60000);
    data.person = QStringLiteral(
        "Αικατερίνη Παπαδημητρακοπούλου-Οικονομοπούλου von Weißenstein-Großschönau zu Überlingen, "
        "Assistenzärztin für Urologie und Kinderurologie");
    data.exerciseTitle =
        QStringLiteral("Εύρεση της κορυφής μιας εικονικής σφαίρας / Auffinden des Scheitelpunkts");
    data.levelTitle =
        QStringLiteral("Nur Haptik, veränderliche Steifigkeit und Reibung, μεταβλητή δυσκαμψία και τριβή");
    data.device = QStringLiteral(
        "Kraftrückkopplungsgerätesimulationsaufbau_ohne_Leerzeichen_0123456789_abcdefghijklmnop");
    data.demonstration = true;
    data.felt = false;
    data.passed = true;
    for (MetricRow& row : data.metrics)
        row.passed = row.passed ? std::optional<bool>(true) : std::nullopt;
    data.metrics[0].name =
        QStringLiteral("Mittlerer Betrag des Scheitelfehlers über beide Achsen / Μέσο σφάλμα κορυφής");
    for (int i = 0; i < 60; ++i)
        data.metrics.push_back({QStringLiteral("metric_%1").arg(i),
                                QStringLiteral("Größe Nr. %1 (δοκιμή)").arg(i),
                                "N·s",
                                0.37 * i,
                                {},
                                {},
                                {},
                                {},
                                false,
                                {},
                                {},
                                {},
                                {}});
    return data;
}

int count(const QByteArray& bytes, const char* what) {
    return static_cast<int>(bytes.count(what));
}

} // namespace

void TestReportOutput::initTestCase() {
    m_folder = qEnvironmentVariable("CHIRON_KEEP_PICTURES", m_temporary.path());
    QVERIFY(QDir().mkpath(m_folder));
}

void TestReportOutput::aFontPackageIsFound() {
    QVERIFY(QFontDatabase::families().contains(reportFontFamily()));
    QCOMPARE(reportFontFamily(), QStringLiteral("Noto Sans"));
}

void TestReportOutput::copiedTextIsTheTextSeen() {
    const QStringList seen{QStringLiteral("10:39, 0:05.0, (N), [mm], \u22123.5 \u2264 0.75, 3 \u00d7 2, "
                                          "40\u201360 %, \u00b15\u00b0, \u03bcm, d\u2032"),
                           QString::fromUtf8("Größe: Überdehnung, „Maß“, fi fl ffi"),
                           QString::fromUtf8("Εισαγωγή στην ουρήθρα: δύναμη ΐ ϊ ί Ί")};
    const QString file = path(QStringLiteral("copied.pdf"));
    {
        QPdfWriter device(file);
        QPainter painter(&device);
        const PlotTheme theme = lightTheme(QLocale(QLocale::English));
        PlotTheme large = theme;
        large.scale = device.logicalDpiX() / 96.0;
        for (const bool bold : {false, true}) {
            painter.setFont(large.font(14, bold));
            for (qsizetype i = 0; i < seen.size(); ++i)
                painter.drawText(QPointF(100, 40 * large.scale * (double(i) + 1.0 + (bold ? 4.0 : 0.0))),
                                 seen[i]);
        }
    }
    const QString copied = tests::pdfText(file);
    for (const QString& line : seen)
        QVERIFY2(copied.count(line.normalized(QString::NormalizationForm_C)) == 2,
                 qPrintable(line + QStringLiteral(" in: ") + copied));
}

void TestReportOutput::sessionReport_data() {
    QTest::addColumn<ReportData>("data");
    QTest::addColumn<QLocale>("locale");
    QTest::addColumn<int>("atLeastPages");
    const QLocale english(QLocale::English, QLocale::UnitedKingdom);
    QTest::newRow("usual") << sample(180000) << english << 2;
    QTest::newRow("long_greek_german") << longAndGreek() << QLocale(QLocale::German, QLocale::Germany) << 4;
    QTest::newRow("one_sample") << sample(1) << english << 1;
    ReportData simulated = sample(20000);
    simulated.simulated = true;
    simulated.state = QStringLiteral("interrupted");
    simulated.person = QStringLiteral("expert, seed 7");
    simulated.sections = {std::make_shared<ApexSection>(std::vector<ApexError>())};
    QTest::newRow("no_trials") << simulated << QLocale(QLocale::Greek, QLocale::Greece) << 1;
    QTest::newRow("nothing") << ReportData() << english << 1;
}

void TestReportOutput::sessionReport() {
    QFETCH(ReportData, data);
    QFETCH(QLocale, locale);
    QFETCH(int, atLeastPages);
    const QString file = path(QStringLiteral("report_%1.pdf").arg(QLatin1String(QTest::currentDataTag())));
    const auto done = writeSessionPdf(file, data, lightTheme(locale));
    QVERIFY2(done.has_value(), done ? "" : done.error().message.c_str());
    QFile pdf(file);
    QVERIFY(pdf.open(QIODevice::ReadOnly));
    const QByteArray bytes = pdf.readAll();
    QVERIFY(bytes.startsWith("%PDF-1."));
    QVERIFY(bytes.trimmed().endsWith("%%EOF"));
    QVERIFY(count(bytes, "/Type /Page\n") >= atLeastPages);
    QVERIFY(bytes.contains("pdfaid:part"));      // archive metadata
    QVERIFY(!bytes.contains("/Subtype /Image")); // plots are vectors
    QVERIFY(bytes.contains("/FontFile"));        // embedded
    // Each page as it was looked at
    const QString painter = QStandardPaths::findExecutable(QStringLiteral("pdftoppm"));
    QVERIFY2(!painter.isEmpty(),
             "pdftoppm is not installed: run scripts/setup, which installs poppler-utils");
    const QString pages = path(QStringLiteral("page_%1").arg(QLatin1String(QTest::currentDataTag())));
    QCOMPARE(QProcess::execute(
                 painter, {QStringLiteral("-r"), QStringLiteral("60"), QStringLiteral("-png"), file, pages}),
             0);
    const QFileInfo about(pages);
    for (const QFileInfo& page :
         about.dir().entryInfoList({about.fileName() + QStringLiteral("*.png")}, QDir::Files, QDir::Name)) {
        const QString differs = m_kept.differs(page.completeBaseName(), QImage(page.filePath()));
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }
}

void TestReportOutput::pictures() {
    const PlotTheme theme = lightTheme(QLocale(QLocale::English, QLocale::UnitedKingdom));
    const auto written = writeSessionPngs(path(QStringLiteral("pictures")), sample(180000), theme);
    QVERIFY2(written.has_value(), written ? "" : written.error().message.c_str());
    QCOMPARE(written->size(), std::size_t{4});
    for (const QString& file : *written) {
        const QImage image(file);
        QVERIFY2(image.width() >= 1800, qPrintable(file)); // twice the logical size
        QCOMPARE(image.pixelColor(0, 0), theme.paper);
        QCOMPARE(image.dotsPerMeterX(), qRound(2 * 96 / 0.0254)); // as large on paper as in the report
        QCOMPARE(image.dotsPerMeterY(), image.dotsPerMeterX());
        const QString differs = m_kept.differs(QFileInfo(file).completeBaseName(), image);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }
    const auto empty = writeSessionPngs(path(QStringLiteral("empty")), ReportData(), theme);
    QVERIFY(empty.has_value());
    QCOMPARE(empty->size(), std::size_t{3}); // no apex errors, no such picture
    QFile inTheWay(path(QStringLiteral("in_the_way")));
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    const QString impossible = path(QStringLiteral("in_the_way/pictures"));
    const auto refused = writeSessionPngs(impossible, ReportData(), theme);
    QVERIFY(!refused);
    QVERIFY2(refused.error().message.starts_with(impossible.toStdString() +
                                                 ": was not written: the folder could not be made"),
             refused.error().message.c_str());
}

// Whatever stands in it, so that plots below each other begin in one column; larger in a larger look.
void TestReportOutput::aLeftMarginIsAsWideAsAsked() {
    PlotTheme theme = lightTheme(QLocale::c());
    for (const double scale : {1.0, 1.5}) {
        theme.scale = scale;
        std::vector<double> begins;
        for (const auto& [margin, highest] : {std::pair{60.0, 1.0}, {60.0, 1e6}, {90.0, 1.0}}) {
            PlotView view(theme);
            view.addLine(QString(), std::vector<double>{0.0, 1.0}, std::vector<double>{0.0, highest},
                         PlotStyle::solidA);
            view.resize(600, 300);
            view.setLeftMargin(margin);
            view.setXWindow(0.0, 1.0);
            begins.push_back(view.pixelOf(0.0));
        }
        QCOMPARE(begins[1], begins[0]);
        QCOMPARE(begins[2] - begins[0], 30.0 * scale);
        QVERIFY(begins[0] >= 60.0 * scale);
    }
}

// The picture over the limit differs from the same picture with the limit above every force.
void TestReportOutput::theLimitIsVisibleWhereForceIsOverIt() {
    const PlotTheme theme = lightTheme(QLocale::c());
    const ReportData data = sample(40000);
    const auto coloured = [&](double limit_N) {
        auto plot = forcePlot(data.series, limit_N, theme);
        const QImage image =
            renderPanels({{plot.get(), QRectF(0, 0, 600, 300)}}, QSize(600, 300), 1.0, theme);
        int reddish = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x)
                reddish += image.pixel(x, y) == theme.overFill.rgb() ? 1 : 0;
        }
        return reddish;
    };
    QVERIFY2(coloured(4.0) > 24 * 5, "more than the key in the legend");
    QCOMPARE(coloured(9.0), 0);
}

// Four tools, with an error of the second one: each line by its own kind, and every plot names all.
ReportData ofFourTools() {
    ReportData data = sample(20000);
    ToolSamples first = data.series.tools.front();
    data.series.tools.clear();
    for (int tool = 0; tool < 4; ++tool) {
        ToolSamples& samples = data.series.tools.emplace_back(first);
        samples.name = QStringLiteral("Tool %1").arg(tool + 1);
        for (std::vector<double>* values : {&samples.x_mm, &samples.y_mm, &samples.z_mm, &samples.tissue_N,
                                            &samples.commanded_N, &samples.measured_N})
            for (double& value : *values)
                value *= 1.0 - 0.2 * tool;
    }
    data.series.tools[1].tissue_N[10000] = 6.5;
    data.series.criticalErrors = {
        {9.5, 10.5, 0, 1, QStringLiteral("Pressed on the wall for 1.00 s, up to 6.50 N")}};
    return data;
}

void TestReportOutput::severalToolsHaveALineEach() {
    const PlotTheme theme = lightTheme(QLocale::c());
    const ReportData data = ofFourTools();
    std::vector<std::unique_ptr<PlotView>> plots = positionPlots(data.series, theme);
    QCOMPARE(plots.size(), std::size_t{3});
    for (auto& plot : {feltForcePlot, measuredForcePlot, forcePlot})
        plots.push_back(plot(data.series, data.forceLimit_N, theme));
    plots.push_back(speedPlot(data.series, theme));
    for (const auto& plot : plots) {
        QVERIFY(plot);
        for (int tool = 1; tool <= 4; ++tool)
            QVERIFY(plot->legendTexts().contains(QStringLiteral("Tool %1").arg(tool)));
    }
    const ReportData alone = sample(1000);
    QVERIFY(!feltForcePlot(alone.series, 4.0, theme) &&
            !measuredForcePlot(alone.series, 4.0, theme)); // both are in the one plot of force
    QCOMPARE(positionPlots(alone.series, theme).size(), std::size_t{1});
    ReportData shown = ofFourTools();
    for (ToolSamples& tool : shown.series.tools)
        tool.commanded_N.clear();
    QVERIFY(!feltForcePlot(shown.series, 4.0, theme));
    QVERIFY(writeSessionPdf(path(QStringLiteral("tools.pdf")), data, theme));
    QVERIFY(writeSessionPngs(path(QStringLiteral("tools")), data, theme));
    for (const char* name : {"force", "position"}) {
        const QImage image(path(QStringLiteral("tools/%1.png").arg(QLatin1String(name))));
        QCOMPARE(image.height(), 3 * 720); // three plots, one below the other
        const QString differs = m_kept.differs(QStringLiteral("tools_%1").arg(QLatin1String(name)), image);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }
}

// At the worst moment of the error, upon the line of the tool that made it; nothing where its tool has no
// samples.
void TestReportOutput::criticalErrorsAreCrosses() {
    const PlotTheme theme = lightTheme(QLocale::c());
    ReportData data = ofFourTools();
    const auto named = [&] {
        return forcePlot(data.series, data.forceLimit_N, theme)
            ->legendTexts()
            .contains(QStringLiteral("critical error"));
    };
    QVERIFY(named());
    data.series.criticalErrors[0].tool = 4;
    QVERIFY(!named());
    data.series.criticalErrors[0].tool = -1; // of the session, and so of its first tool
    data.series.criticalErrors[0].begin_s = data.series.criticalErrors[0].end_s =
        1e6; // after the last sample: at the last one
    QVERIFY(named());
    data.series.t_s.clear();
    QVERIFY(!named());
}

void TestReportOutput::comparison() {
    ComparisonData data{QStringLiteral("Apex error of the scripted operators, haptics alone"),
                        QStringLiteral("Mean apex error"),
                        QStringLiteral("% of radius"),
                        {{QStringLiteral("novice"), {38.1, 44.0, 31.2, 52.7, 40.1, 35.5}},
                         {QStringLiteral("intermediate"), {22.4, 19.8, 27.1, 24.9, 20.3, 25.0}},
                         {QStringLiteral("expert"), {9.8, 11.7, 8.9, 13.2, 10.4, 9.1}},
                         {QStringLiteral("unsafe"), {16.2}},
                         {QStringLiteral("nobody"), {}}},
                        QStringLiteral("session"),
                        14.2,
                        QStringLiteral("published mean, 14.2 %")};
    const PlotTheme theme = lightTheme(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QVERIFY(writeComparisonPng(path(QStringLiteral("comparison.png")), data, theme).has_value());
    const QImage image(path(QStringLiteral("comparison.png")));
    QVERIFY(image.width() >= 1800);
    const QString differs = m_kept.differs(QStringLiteral("comparison"), image);
    QVERIFY2(differs.isEmpty(), qPrintable(differs));
    QVERIFY(writeComparisonPng(path(QStringLiteral("comparison_empty.png")), {}, theme).has_value());
}

void TestReportOutput::failuresNameThePath() {
    const PlotTheme theme = lightTheme(QLocale::c());
    const QString nowhere = path(QStringLiteral("missing/folder/report.pdf"));
    for (const auto& failed : {writeSessionPdf(nowhere, {}, theme), writeSessionPdf(m_folder, {}, theme),
                               writeComparisonPng(nowhere, {}, theme)}) {
        QVERIFY(!failed.has_value());
        QCOMPARE(failed.error().code, core::ErrorCode::storage);
        QVERIFY(failed.error().message.find(m_folder.toStdString()) != std::string::npos);
    }
    const auto noPixels =
        positionPlots({}, theme).front()->savePng(path(QStringLiteral("none.png")), QSize(0, 0));
    QVERIFY(!noPixels.has_value());
    QVERIFY(!QFile::exists(path(QStringLiteral("none.png"))));
}

QTEST_MAIN(TestReportOutput)
#include "test_report_output.moc"
