// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_process.h"

#include <QtTest>

// Malformed command lines and inputs: each is refused with the right exit status, one line on stderr that
// names the place, and nothing on stdout; none ends by a signal.
class TestCliRefuses : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void everyCommand_data();
    void everyCommand();
    void oneByOne_data();
    void oneByOne();
    void generatedTables_data();
    void generatedTables();
    void whatMustBeGiven_data();
    void whatMustBeGiven();
    void readingNeedsADatabase_data();
    void readingNeedsADatabase();
    void rangesAreSaid_data();
    void rangesAreSaid();
    void endsOfRangesAreTaken_data();
    void endsOfRangesAreTaken();
    void filesHaveTheirLimit_data();
    void filesHaveTheirLimit();
    void passwordsAreNotRepeated();

private:
    void check(const CliRun& run, int exitCode, const QStringList& mentions);
    void row(const char* name, const QStringList& arguments, int exitCode, const QStringList& mentions,
             const QByteArray& input = {});
    void oneByOneColumns();
    QString file(const QString& name, const QByteArray& content);
    QTemporaryDir m_folder;
    int m_cases = 0;
};

namespace {
const QByteArray kPoint = "px_m,py_m,pz_m,vx_m_per_s,vy_m_per_s,vz_m_per_s\n";
QStringList words(const char* line) {
    return QString::fromUtf8(line).split(QLatin1Char(' '), Qt::SkipEmptyParts);
}
} // namespace

void TestCliRefuses::initTestCase() {
    QVERIFY(m_folder.isValid());
    QVERIFY2(cliCommands().size() >= 3, "the help lists the commands");
}

QString TestCliRefuses::file(const QString& name, const QByteArray& content) {
    const QString path = m_folder.filePath(name);
    QFile out(path);
    if (!out.open(QIODevice::WriteOnly) || out.write(content) != content.size())
        qFatal("the test's own file could not be written");
    return path;
}

void TestCliRefuses::check(const CliRun& run, int exitCode, const QStringList& mentions) {
    ++m_cases;
    const QString fault = refusalFault(run, exitCode, mentions);
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
}

void TestCliRefuses::row(const char* name, const QStringList& arguments, int exitCode,
                         const QStringList& mentions, const QByteArray& input) {
    QTest::newRow(name) << arguments << exitCode << mentions << input;
}

void TestCliRefuses::everyCommand_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QStringList>("mentions");
    for (const QString& name : cliCommands()) {
        const auto add = [&](const char* what, const QStringList& rest, const QStringList& mentions) {
            QTest::addRow("%s: %s", qPrintable(name), what)
                << name.split(QLatin1Char(' ')) + rest << mentions;
        };
        add("unknown option", {"--no-such-option"}, {name, "no-such-option"});
        add("unknown short option", {"-q"}, {name, "'q'"});
        add("value for a flag", {"--json=yes"}, {name, "json"});
        add("no value", {"--database"}, {name, "--database"});
        add("empty value", {"--database="}, {name});
        add("given twice", {"--as", "one", "--as", "two"}, {name});
        add("too many", words("a b c d e f g h i j"), {name});
        add("password", {"--password", "hunter2hunter2"}, {"--password", "CHIRON_PASSWORD"});
        add("password=", {"--password=hunter2hunter2"}, {"--password", "CHIRON_PASSWORD"});
    }
}

void TestCliRefuses::everyCommand() {
    QFETCH(QStringList, arguments);
    QFETCH(QStringList, mentions);
    const CliRun run = runCli(arguments);
    check(run, 2, mentions);
    QVERIFY(!run.err.contains("hunter2"));
}

void TestCliRefuses::oneByOneColumns() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QStringList>("mentions");
    QTest::addColumn<QByteArray>("input");
}

void TestCliRefuses::oneByOne_data() {
    oneByOneColumns();
    const QString folder = m_folder.path();
    row("nothing", {}, 2, {"no command given", "expected"});
    row("empty word", {""}, 2, {"\"\"", "expected one of"});
    row("unknown command", {"trian"}, 2, {"\"trian\"", "expected one of"});
    row("only an option", {"--json"}, 2, {"no command given"});
    row("option with its value only", words("--database x.db"), 2, {"no command given"});
    row("dashes alone", {"--"}, 2, {"--"});
    row("control characters", {QStringLiteral("e\u001b[31mvil\n")}, 2, {"\\u001b", "\\u000a"});
    row("long password input", words("user list --as ada --password-stdin"), 3,
        {"stdin: more than 16384 bytes"}, QByteArray(16385, 'x'));
    for (const char* given : {"-p", "-password"})
        for (const char* after : {" hunter2hunter2", "=hunter2hunter2"})
            QTest::addRow("password by %s%s", given, after)
                << words("user list --as ada") + words((QByteArray(given) + after).constData()) << 2
                << QStringList{QLatin1String(given) + QLatin1String(": passwords"), "CHIRON_PASSWORD"}
                << QByteArray();
    row("long word", {QString(5000, QLatin1Char('x'))}, 2, {"…"});
    row("group alone", {"device"}, 2, {"device", "second word", "list"});
    row("group with a wrong word", words("device lst"), 2, {"\"lst\"", "list"});
    // evaluate
    row("no model", {"evaluate"}, 2, {"MODEL", "hemisphere"});
    row("unknown model", {"evaluate", "hemisfere"}, 3, {"\"hemisfere\"", "hemisphere"});
    row("model and list", {"evaluate", "hemisphere", "--list"}, 2, {"--list"});
    row("empty input", {"evaluate", "hemisphere"}, 3, {"stdin:1", "px_m"});
    row("only line ends", {"evaluate", "hemisphere"}, 3, {"stdin:1"}, "\n\n\n");
    row("header without a column", {"evaluate", "hemisphere"}, 3, {"vz_m_per_s", "missing"},
        "px_m,py_m,pz_m,vx_m_per_s,vy_m_per_s\n");
    row("header with a stranger", {"evaluate", "hemisphere"}, 3, {"stdin:1:3", "\"pz_mm\""},
        "px_m,py_m,pz_mm,vx_m_per_s,vy_m_per_s,vz_m_per_s\n");
    row("header with a double", {"evaluate", "hemisphere"}, 3, {"stdin:1:2", "\"px_m\""},
        "px_m,px_m,pz_m,vx_m_per_s,vy_m_per_s,vz_m_per_s\n");
    row("header missing", {"evaluate", "hemisphere"}, 3, {"stdin:1:1", "\"0\""}, "0,0,0,0,0,0\n");
    row("semicolons", {"evaluate", "hemisphere"}, 3, {"stdin:1:1"}, QByteArray(kPoint).replace(',', ';'));
    row("binary", {"evaluate", "hemisphere"}, 3, {"stdin:1:1"},
        QByteArray("\x7f"
                   "ELF\0\x01\x02",
                   7));
    row("empty line between", {"evaluate", "hemisphere"}, 3, {"stdin:3", "1 fields", "6"},
        kPoint + "0,0,0,0,0,0\n\n0,0,0,0,0,0\n");
    const auto parameters = [&](const char* name, const QString& content, int exitCode,
                                const QStringList& mentions) {
        const QString path = file(
            QString::fromUtf8(name).replace(QLatin1Char(' '), QLatin1Char('_')) + ".json", content.toUtf8());
        row(name, {"evaluate", "hemisphere", "--parameters", path}, exitCode, mentions + QStringList{path},
            kPoint + "0,0,0,0,0,0\n");
    };
    parameters("empty json", "", 3, {":1:1"});
    parameters("json array", "[1]", 3, {"$"});
    parameters("json number", "5", 3, {":1:"});
    parameters("json cut off", "{\"radius_m\": 0.02", 3, {":1:"});
    parameters("json second line", "{\n \"radius_m\": nope}", 3, {":2:"});
    parameters("json trailing", "{} {}", 3, {":1:"});
    parameters("json nan", "{\"radius_m\": NaN}", 3, {":1:"});
    parameters("json string", "{\"radius_m\": \"0.02\"}", 3, {"$.radius_m", "0.001", "0.2"});
    parameters("json null", "{\"radius_m\": null}", 3, {"$.radius_m"});
    parameters("json bool", "{\"radius_m\": true}", 3, {"$.radius_m"});
    parameters("json too large", "{\"radius_m\": 5}", 3, {"$.radius_m", "5", "0.2"});
    parameters("json negative", "{\"radius_m\": -0.02}", 3, {"$.radius_m", "-0.02"});
    parameters("json infinite", "{\"radius_m\": 1e999}", 3, {});
    parameters("json stranger", "{\"radius_mm\": 20}", 3, {"$.radius_mm", "radius_m"});
    parameters("json object", "{\"radius_m\": {}}", 3, {"$.radius_m"});
    // In range, and no law for it: the place and what was expected.
    const auto unlawful = [&](const char* name, const char* law, const QString& json, const QByteArray& table,
                              const QStringList& mentions) {
        const QString path = file(
            QString::fromUtf8(name).replace(QLatin1Char(' '), QLatin1Char('_')) + ".json", json.toUtf8());
        row(name, {"evaluate", law, "--parameters", path}, 3, mentions, table);
    };
    unlawful("stiffness that pulls", "hemisphere",
             R"({"stiffness_variation": 0.99, "stiffness_wavelength_m": 0.001})",
             kPoint + "0,0,0.021,0,0,0\n0.0029,0.0002,0.0145,0,0,0\n",
             {"stdin:3", "depth_m", "stiffness_wavelength_m"});
    const QByteArray kShaft =
        "px_m,py_m,pz_m,ax,ay,az,vx_m_per_s,vy_m_per_s,vz_m_per_s,wx_rad_per_s,wy_rad_per_s,wz_rad_per_s\n";
    unlawful("endoscope that looks nowhere", "urethra-force", "{}",
             kShaft + "0,0,0.01,0,0,1,0,0,0,0,0,0\n0,0,0.01,0,0,0,0,0,0,0,0,0\n", {"stdin:3", "ax, ay, az"});
    unlawful("urethra that crosses itself", "urethra-force", R"({"radius_m": 0.006, "curvature_per_m": 100})",
             kShaft, {".json", "radius_m"});
    unlawful("one section", "urethra-force", R"({"basic_sections": 1})", kShaft, {".json", "basic_sections"});
    unlawful("half a section", "urethra-force", R"({"basic_sections": 26.5})", kShaft,
             {"$.basic_sections", "whole"});
    unlawful("profile of no urethra", "urethra-profile",
             R"({"change_length_m": 0.012, "change_centre_m": 0.25})", "s_m\n0\n", {".json", "changes[0]"});
    unlawful("surface beyond the neck", "urethra-surface", "{}", "s_m,angle_rad\n0.01,0\n0.5,0\n",
             {"stdin:3", "s_m 0.5"});
    unlawful("palpated along no normal", "palpation-contact", "{}", "fx_N,fy_N,fz_N,nx,ny,nz\n0,0,1,0,0,0\n",
             {"stdin:2", "nx, ny, nz"});
    unlawful("finger without a direction", "palpation-contact", R"({"finger_x": 0})",
             "fx_N,fy_N,fz_N,nx,ny,nz\n", {".json", "finger_x"});
    unlawful("lump out of the tissue", "palpation-lump", R"({"R_m": 0.014})", "depth_m,rho_m\n0.001,0\n",
             {".json", "R_m 0.014"});
    unlawful("contact wider than the lump is deep", "palpation-lump", R"({"a_m": 0.0065})",
             "depth_m,rho_m\n0.001,0\n", {".json", "a_m 0.0065"});
    unlawful("through the lump", "palpation-lump", "{}", "depth_m,rho_m\n0.0089,0\n0.0091,0\n",
             {"stdin:3", "depth_m 0.0091"});
    unlawful("held for less than no time", "deformation", "{}", "depth_m,held_s,released_s\n0.001,-1,0\n",
             {"stdin:2", "held_s -1"});
    unlawful("let go before", "deformation", "{}", "depth_m,held_s,released_s\n0.001,1,-0.5\n",
             {"stdin:2", "released_s -0.5"});
    unlawful("tube of less than no length", "elastic-tube", "{}", "length_m\n-0.01\n",
             {"stdin:2", "length_m -0.01"});
    unlawful("half a seed", "roughness", R"({"seed": 1.5})", "px_m,py_m,depth_m\n", {"$.seed", "whole"});
    unlawful("half a dome", "mesh-contact", R"({"dome": 0.5})", kPoint, {"$.dome", "whole"});
    unlawful("links that do not meet", "five_bar_pose", R"({"distal_m": 0.01})",
             "theta1_rad,theta2_rad\n3.14,0\n", {"stdin:2", "theta1_rad"});
    unlawful(
        "efforts of links that do not meet", "five_bar_efforts", R"({"distal_m": 0.01})",
        "theta1_rad,theta2_rad,pitch_rad,yaw_rad,fx_N,fy_N,fz_N,tx_Nm,ty_Nm,tz_Nm\n3.14,0,0,0,0,0,1,0,0,0\n",
        {"stdin:2", "theta1_rad"});
    unlawful("too large for a number", "elasticity", "{}", "x_m\n1e200\n", {"stdin:2", "energy_J"});
    row("cut off within the last row", {"evaluate", "friction"}, 3, {"stdin:3", "line feed"},
        "normal_force_N,velocity_m_per_s\n1,0.1\n1,0.1");
    row("parameters missing", {"evaluate", "hemisphere", "--parameters", folder + "/none.json"}, 3,
        {"none.json", "no such file"}, kPoint);
    row("parameters folder", {"evaluate", "hemisphere", "--parameters", folder}, 3, {folder, "folder"},
        kPoint);
    row("parameters device", {"evaluate", "hemisphere", "--parameters", "/dev/zero"}, 3,
        {"/dev/zero", "regular"}, kPoint);
    // metrics
    row("no trace", {"metrics"}, 2, {"TRACE.csv"});
    row("empty trace name", {"metrics", ""}, 2, {"TRACE.csv"});
    row("trace missing", {"metrics", folder + "/none.csv"}, 3, {"none.csv"});
    row("trace folder", {"metrics", folder}, 3, {folder});
    const QString good =
        file("good.csv", "t_s,x_mm,y_mm,z_mm\n0,0,0,0\n0.01,1,0,0\n0.02,2,0,0\n0.03,3,0,0\n");
    row("unknown metric", {"metrics", good, "--metric", "sparkle"}, 3, {"--metric", "\"sparkle\"", "sparc"});
    row("second metric unknown", {"metrics", good, "--metric", "sparc,sparkle"}, 3, {"\"sparkle\""});
    row("unknown exercise", {"metrics", good, "--exercise", "juggling"}, 3,
        {"--exercise", "\"juggling\"", "sphere_apex"});
    row("metric twice", {"metrics", good, "--metric", "sparc,sparc"}, 2, {"--metric", "item 2"});
    row("metric list with a hole", {"metrics", good, "--metric", "sparc,,ldlj"}, 2, {"--metric", "item 2"});
    row("metric list ends open", {"metrics", good, "--metric", "sparc,"}, 2, {"--metric", "item 2"});
    for (const char* limit : {"abc", "-1", "0", "NaN", "inf", "1e9", "4,0", "4N", "0x4", " "})
        QTest::addRow("force limit %s", limit)
            << QStringList{"metrics", good, "--force-limit", limit} << 2
            << QStringList{"--force-limit", QStringLiteral("\"%1\"").arg(limit)} << QByteArray();
    // A command for which nothing is stored yet: what was found, what was expected, and where.
    row("folder below a file", {"demo", "--folder", good + "/below"}, 4,
        {good + "/below", "cannot be made", "expected a place that may be written to"});
    row("demonstration over a file", {"demo", "--database", good}, 3,
        {good, "exists already", "expected a file that does not exist yet"});
    row("no such study to begin with", {"study", "new", "stifness", "--database", folder + "/none.db"}, 3,
        {"FROM \"stifness\"", "expected one of", "stiffness_2afc", "JSON file"});
    row("another driver", words("device check --driver lever"), 2, {"--driver", "\"lever\"", "device list"});
    row("driver without motors", words("device check --driver keyboard_mouse"), 5,
        {"--driver", "keyboard_mouse", "no motors", "expected"});
    row("option of the other mechanism", words("device check --mechanism gimbal_hprd --poses 4"), 2,
        {"--poses", "gimbal_hprd", "expected it with fingertip_arm"});
    row("a ratio that is none",
        words("study plan stiffness_2afc --observer weber:0.1 --power --ratio 1 --database none.db"), 2,
        {"--ratio 1", "expected a ratio other than 1"});
    row("power without its option",
        words("study plan stiffness_2afc --observer weber:0.1 --alpha 0.01 --database none.db"), 2,
        {"--alpha", "--power", "expected both"});
    const auto trace = [&](const char* name, const QByteArray& content, const QString& where) {
        const QString path =
            file(QString::fromUtf8(name).replace(QLatin1Char(' '), QLatin1Char('_')) + ".csv", content);
        row(name, {"metrics", path, "--metric", "path_length"}, 3, {path + where});
    };
    trace("trace empty", "", "");
    trace("trace header only", "t_s,x_mm,y_mm,z_mm\n", "");
    trace("trace without time", "x_mm,y_mm,z_mm\n0,0,0\n", ":1");
    trace("trace without z", "t_s,x_mm,y_mm\n0,0,0\n", ":1");
    trace("trace stranger", "t_s,x_mm,y_mm,z_mm,speed\n0,0,0,0,0\n", ":1");
    trace("trace word", "t_s,x_mm,y_mm,z_mm\n0,0,zero,0\n", ":2:3");
    trace("trace nan", "t_s,x_mm,y_mm,z_mm\n0,0,nan,0\n", ":2:3");
    trace("trace infinite", "t_s,x_mm,y_mm,z_mm\n0,inf,0,0\n", ":2:2");
    trace("trace short row", "t_s,x_mm,y_mm,z_mm\n0,0,0\n", ":2");
    trace("trace long row", "t_s,x_mm,y_mm,z_mm\n0,0,0,0,0\n", ":2");
    trace("trace backwards", "t_s,x_mm,y_mm,z_mm\n0,0,0,0\n0.1,0,0,0\n0.05,0,0,0\n", ":4");
    trace("trace stands still", "t_s,x_mm,y_mm,z_mm\n0,0,0,0\n0,1,0,0\n", ":3");
    trace("trace half a quaternion", "t_s,x_mm,y_mm,z_mm,qw,qx\n0,0,0,0,1,0\n", ":1");
    trace("trace zero quaternion", "t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz\n0,0,0,0,0,0,0,0\n", ":2");
    trace("trace tool 9", "t_s,x_mm,y_mm,z_mm,tool\n0,0,0,0,9\n", ":2:5");
    trace("trace negative buttons", "t_s,x_mm,y_mm,z_mm,buttons\n0,0,0,0,-1\n", ":2:5");
}

void TestCliRefuses::oneByOne() {
    QFETCH(QStringList, arguments);
    QFETCH(int, exitCode);
    QFETCH(QStringList, mentions);
    QFETCH(QByteArray, input);
    check(runCli(arguments, input), exitCode, mentions);
}

// Every place of a row of every kind of wrong number.
void TestCliRefuses::generatedTables_data() {
    QTest::addColumn<QByteArray>("input");
    QTest::addColumn<QString>("place");
    for (const char* wrong : {"", "x", "nan", "-inf", "1e999", "0x10", "1 2", "--1", "1,5"}) {
        for (int column = 1; column <= 6; ++column) {
            QStringList cells(6, QStringLiteral("0.01"));
            cells[column - 1] = QLatin1String(wrong);
            const bool extra = QLatin1String(wrong).contains(QLatin1Char(','));
            QTest::addRow("%s in column %d", wrong, column)
                << kPoint + "0,0,0,0,0,0\n" + cells.join(QLatin1Char(',')).toUtf8() + "\n"
                << (extra ? QStringLiteral("stdin:3: 7 fields") : QStringLiteral("stdin:3:%1:").arg(column));
        }
    }
}

void TestCliRefuses::generatedTables() {
    QFETCH(QByteArray, input);
    QFETCH(QString, place);
    check(runCli({"evaluate", "hemisphere"}, input), 3, {place});
}

// An option without which a command means nothing is asked for by its name, before anything is read.
void TestCliRefuses::whatMustBeGiven_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("option");
    for (const auto& [command, option] : std::initializer_list<std::pair<const char*, const char*>>{
             {"init", "admin"},
             {"train sphere_apex", "operator"},
             {"report 1", "pdf"},
             {"user add bob", "role"},
             {"user role bob", "role"},
             {"person erase bob", "reason"},
             {"psychophysics compare answers.csv", "by"},
             {"study plan stiffness_2afc", "observer"},
             {"study consent 1", "participant"},
             {"study withdraw 1", "participant"},
             {"study erase 1 --reason x", "participant"},
             {"study erase 1 --participant X01", "reason"},
             {"study unblind 1", "reason"},
             {"study questionnaire template 1", "out"},
             {"study export 1", "out"}})
        QTest::addRow("%s without --%s", command, option) << words(command) << QString::fromLatin1(option);
}

void TestCliRefuses::whatMustBeGiven() {
    QFETCH(QStringList, arguments);
    QFETCH(QString, option);
    check(runCli(arguments), 2, {arguments.front(), QStringLiteral("--%1 is missing").arg(option)});
}

// Nobody's data are read where there are none: said, and nothing is made.
void TestCliRefuses::readingNeedsADatabase_data() {
    QTest::addColumn<QStringList>("arguments");
    for (const char* command :
         {"session list", "session show 1", "session export 1", "score 1", "replay 1", "report 1 --pdf OUT",
          "site name", "study list", "study show 1", "study analyse 1", "study rerun 1",
          "study export 1 --out OUT", "study questionnaire summary 1"})
        QTest::addRow("%s", command) << words(command).replaceInStrings(QStringLiteral("OUT"),
                                                                        m_folder.filePath("out"));
}

void TestCliRefuses::readingNeedsADatabase() {
    QFETCH(QStringList, arguments);
    const QString database = m_folder.filePath("none.db");
    check(runCli(arguments + QStringList{"--database", database}), 3, {"none.db", "no such file"});
    QVERIFY(!QFile::exists(database) && !QFile::exists(m_folder.filePath("out")));
}

// Every option that is a number: what is just outside of its range is refused with the range.
void TestCliRefuses::rangesAreSaid_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QStringList>("outside");
    QTest::addColumn<QString>("range");
    const auto option = [](const char* command, const char* name, const char* below, const char* above,
                           const char* range) {
        QTest::addRow("%s --%s", command, name)
            << words(command) + QStringList{QStringLiteral("--%1").arg(QLatin1String(name))}
            << QStringList{QLatin1String(below), QLatin1String(above)} << QString::fromLatin1(range);
    };
    option("psychophysics compare none.csv --by who", "monte-carlo", "-1", "100001",
           "a whole number from 0 to 100000");
    option("psychophysics rank none.csv", "regularise", "-0.001", "1000001", "a number from 0 to 1e+06");
    option("psychophysics fit none.csv --method ml", "bootstrap", "-1", "1000001",
           "a whole number from 0 to 1000000");
    option("psychophysics fit none.csv", "monte-carlo", "-1", "1000001", "a whole number from 0 to 1000000");
    option("psychophysics fit none.csv", "curve", "-1", "10001", "a whole number from 0 to 10000");
    option("psychophysics fit none.csv", "confidence", "0.499", "0.9991", "a number from 0.5 to 0.999");
    option("psychophysics dprime --task mafc --correct 3 --total 5", "m", "1", "1001",
           "a whole number from 2 to 1000");
    option("psychophysics dprime --task 2afc", "proportion", "-0.001", "1.001", "a number from 0 to 1");
    option("psychophysics dprime --task 2afc --total 5", "correct", "-1", "1000000001",
           "a whole number from 0 to 1000000000");
    option("study plan stiffness_2afc --observer weber:0.1", "runs", "-1", "100001",
           "a whole number from 0 to 100000");
    option("study plan stiffness_2afc --observer weber:0.1 --power", "participants", "1", "100001",
           "a whole number from 2 to 100000");
    option("study plan stiffness_2afc --observer weber:0.1 --power", "wanted", "0.009", "0.99991",
           "a number from 0.01 to 0.9999");
    option("study plan stiffness_2afc --observer weber:0.1 --power", "alpha", "9e-7", "0.51",
           "a number from 1e-06 to 0.5");
    option("study plan stiffness_2afc --observer weber:0.1 --power", "between-sd", "-0.1", "3.1",
           "a number from 0 to 3");
    option("study plan stiffness_2afc --observer weber:0.1 --power", "ratio", "0.009", "100.1",
           "a number from 0.01 to 100");
    option("score 1", "metric-version", "0", "1001", "a whole number from 1 to 1000");
    option("metrics none.csv", "force-limit", "0.009", "100.1", "a number from 0.01 to 100");
    option("session list", "limit", "0", "1000001", "a whole number from 1 to 1000000");
    option("device check", "frequency", "0.049", "5.01", "a number from 0.05 to 5");
    option("device check", "poses", "0", "10001", "a whole number from 1 to 10000");
    option("device check", "damping", "0.009", "100.1", "a number from 0.01 to 100");
    option("device check --mechanism gimbal_hprd", "sample-delay", "-1", "4", "a whole number from 0 to 3");
    option("train sphere_apex --operator expert", "level", "0", "99", "a whole number from 1 to ");
    option("train sphere_apex --operator expert", "seed", "-1", "18446744073709551616",
           "a whole number from 0 to 18446744073709551615");
}

void TestCliRefuses::rangesAreSaid() {
    QFETCH(QStringList, arguments);
    QFETCH(QStringList, outside);
    QFETCH(QString, range);
    for (const QString& value : outside)
        check(runCli(arguments + QStringList{value}), 2,
              {arguments.constLast(), QStringLiteral("\"%1\": expected %2").arg(value, range)});
    for (const char* session : {"session show", "session export", "score", "replay"})
        if (arguments.constLast() == u"--limit")
            check(runCli(words(session) + QStringList{"0"}), 2,
                  {"ID", "\"0\": expected a whole number from 1 to 9223372036854775807"});
}

void TestCliRefuses::endsOfRangesAreTaken_data() {
    QTest::addColumn<QStringList>("arguments");
    for (const char* line :
         {"psychophysics dprime --task 2afc --proportion 0 --json",
          "psychophysics dprime --task 2afc --proportion 1 --json",
          "psychophysics dprime --task mafc --m 2 --correct 38 --total 50",
          "psychophysics dprime --task mafc --m 1000 --correct 38 --total 50",
          "psychophysics dprime --task 2afc --correct 0 --total 5 --json",
          "psychophysics dprime --task 2afc --correct 1000000000 --total 1000000000 --json"})
        QTest::addRow("%s", line) << words(line);
}

void TestCliRefuses::endsOfRangesAreTaken() {
    QFETCH(QStringList, arguments);
    const CliRun run = runCli(arguments);
    QVERIFY2(run.ended && run.exitCode == 0, run.err.constData());
}

// A file larger than any that is meant is not read into memory: the limit is said, and it is the limit that
// is said.
void TestCliRefuses::filesHaveTheirLimit_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<qint64>("most");
    QTest::newRow("people") << QStringList{"user", "import-csv", "FILE", "--as", "ada"} << (qint64{16} << 20);
    QTest::newRow("parameters") << QStringList{"evaluate", "hemisphere", "--parameters", "FILE"}
                                << (qint64{16} << 20);
    QTest::newRow("procedure") << QStringList{"psychophysics", "adaptive", "--procedure", "FILE"}
                               << (qint64{16} << 20) + 1;
    QTest::newRow("study") << QStringList{"study", "plan", "FILE", "--observer", "weber:0.1"}
                           << (qint64{1} << 20);
    QTest::newRow("table") << QStringList{"psychophysics", "rank", "FILE"} << (qint64{256} << 20);
    QTest::newRow("mesh") << QStringList{"mesh", "check", "FILE"} << (qint64{256} << 20);
}

void TestCliRefuses::filesHaveTheirLimit() {
    QFETCH(QStringList, arguments);
    QFETCH(qint64, most);
    const QString path = m_folder.filePath(QStringLiteral("large.json"));
    QFile large(path);
    QVERIFY(large.open(QIODevice::WriteOnly) && large.resize(most + 1)); // holds nothing, and takes no room
    large.close();
    arguments.replaceInStrings(QStringLiteral("FILE"), path);
    check(runCli(arguments, kPoint + "0,0,0,0,0,0\n", {{"CHIRON_PASSWORD", "a long password for tests"}}), 3,
          {path, QStringLiteral("%1 bytes; expected at most %2").arg(most + 1).arg(most)});
    QVERIFY(large.remove());
}

void TestCliRefuses::passwordsAreNotRepeated() {
    const CliRun run = runCli({"--password=correct horse battery", "device", "list"});
    check(run, 2, {"--password", "--password-stdin"});
    QVERIFY(!run.err.contains("horse"));
    qInfo("%d malformed command lines and inputs", m_cases);
    QVERIFY(m_cases >= 150);
}

QTEST_GUILESS_MAIN(TestCliRefuses)
#include "test_cli_refuses.moc"
