// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/protocol/station_cobs.h"
#include "support/patience.h"
#include "support/station_conformance.h"

#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>
#include <array>
#include <csignal>
#include <fcntl.h>
#include <memory>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

using namespace chiron;
using namespace chiron::test;

namespace {

const QString kFirmware = QStringLiteral(CHIRON_STATION_FIRMWARE);

/// The emulated processor's serial line.
class SerialLine : public StationLine {
public:
    explicit SerialLine(const QByteArray& path)
        : m_file(::open(path.constData(), O_RDWR | O_NOCTTY | O_CLOEXEC)) {
        station_cobs_begin(&m_decoder);
        termios raw{};
        open = m_file >= 0 && ::tcgetattr(m_file, &raw) == 0;
        ::cfmakeraw(&raw);
        open = open && ::tcsetattr(m_file, TCSANOW, &raw) == 0 && sendBytes(QByteArray(1, '\0'));
    }
    ~SerialLine() override { ::close(m_file); }
    SerialLine(const SerialLine&) = delete;
    SerialLine& operator=(const SerialLine&) = delete;
    bool send(const QList<Frame>& frames) override {
        QByteArray bytes;
        for (const Frame& frame : frames) {
            std::array<char, STATION_COBS_SIZE> line{};
            station_cobs_encode(frame.data(), reinterpret_cast<std::uint8_t*>(line.data()));
            bytes.append(line.data(), STATION_COBS_SIZE);
        }
        return sendBytes(bytes);
    }
    bool sendBytes(const QByteArray& bytes) override {
        return ::write(m_file, bytes.constData(), static_cast<std::size_t>(bytes.size())) == bytes.size();
    }
    bool next(Frame& frame) override {
        for (;;) {
            for (; m_taken < m_count; ++m_taken) {
                const auto event = station_cobs_take(&m_decoder, m_buffer[m_taken], frame.data());
                if (event == STATION_COBS_FRAME) {
                    ++m_taken;
                    return true;
                }
                broken += event == STATION_COBS_BROKEN ? 1 : 0;
            }
            pollfd wait{m_file, POLLIN, 0};
            if (::poll(&wait, 1, tests::kPatience_ms) != 1)
                return false;
            const ssize_t more = ::read(m_file, m_buffer.data(), m_buffer.size());
            if (more <= 0)
                return false;
            m_count = static_cast<std::size_t>(more);
            m_taken = 0;
        }
    }

    bool open = false;
    int broken = 0; ///< blocks; the first may have begun before we came

private:
    int m_file;
    station_cobs m_decoder{};
    std::array<std::uint8_t, 4096> m_buffer{};
    std::size_t m_count = 0, m_taken = 0;
};

/// A host that keeps it armed until it is killed.
[[noreturn]] void keepArmed(SerialLine& line) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    StationConformance conformance(line);
    station_input input{};
    if (!conformance.becomesHomed().isEmpty())
        ::_exit(1);
    for (;;) {
        if (!conformance.arm(input).isEmpty())
            ::_exit(1);
        while (input.state == STATION_ARMED)
            if (!conformance.exchange(STATION_OUTPUT_ENABLE, input, 15, 20000))
                ::_exit(1);
    }
}

struct Told {
    QString state;
    bool letGo = false;
    qint64 age_us = 0, hold_ms = 0;
};

} // namespace

/// The firmware as it is built for a micro-controller, in an emulator whose clock counts instructions.
class TestFirmwareEmulated : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void itKeepsWhatTheProtocolPromises();
    void effortsMoveItsAxes();
    void itLetsGoWhenItsHostIsKilled();

private:
    QList<Told> told() const;

    QString m_emulator;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<QProcess> m_process;
    std::unique_ptr<SerialLine> m_line;
};

void TestFirmwareEmulated::initTestCase() {
    m_emulator = QStandardPaths::findExecutable(QStringLiteral("qemu-system-arm"));
    if (m_emulator.isEmpty() || !QFile::exists(kFirmware))
        QSKIP("needs qemu-system-arm and the firmware, which arm-none-eabi-gcc builds: scripts/setup --long");
}

void TestFirmwareEmulated::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    m_process = std::make_unique<QProcess>();
    m_process->setProcessChannelMode(QProcess::MergedChannels);
    m_process->setChildProcessModifier([] { ::prctl(PR_SET_PDEATHSIG, SIGKILL); });
    // Without sleep its clock counts instructions and skips what it would wait: how fast this machine is
    // changes nothing.
    m_process->start(m_emulator,
                     {"-M", "lm3s6965evb", "-nographic", "-nodefaults", "-monitor", "none", "-icount",
                      "shift=4,sleep=off", "-kernel", kFirmware, "-chardev", "pty,id=line", "-serial",
                      "chardev:line", "-serial",
                      QStringLiteral("file:%1").arg(m_folder->filePath(QStringLiteral("service")))});
    QVERIFY(m_process->waitForStarted(tests::kPatience_ms));
    QByteArray told;
    static const QRegularExpression terminal(QStringLiteral("redirected to (/dev/pts/[0-9]+) "));
    while (!terminal.match(QString::fromLocal8Bit(told)).hasMatch()) {
        QVERIFY2(m_process->waitForReadyRead(tests::kPatience_ms), told.constData());
        told += m_process->readAll();
    }
    m_line =
        std::make_unique<SerialLine>(terminal.match(QString::fromLocal8Bit(told)).captured(1).toLocal8Bit());
    QVERIFY(m_line->open);
}

void TestFirmwareEmulated::cleanup() {
    if (m_process) {
        m_process->kill();
        m_process->waitForFinished(tests::kPatience_ms);
    }
    m_line.reset();
}

QList<Told> TestFirmwareEmulated::told() const {
    QFile file(m_folder->filePath(QStringLiteral("service")));
    QList<Told> all;
    if (!file.open(QIODevice::ReadOnly))
        return all;
    static const QRegularExpression line(
        QStringLiteral("^[0-9]+ us ([a-z]+)( let-go)? fault [0-9]+ age ([0-9]+) hold ([0-9]+)\r\n"),
        QRegularExpression::MultilineOption);
    const QString text = QString::fromLatin1(file.readAll());
    for (auto it = line.globalMatch(text); it.hasNext();) {
        const auto match = it.next();
        all << Told{match.captured(1), !match.captured(2).isEmpty(), match.captured(3).toLongLong(),
                    match.captured(4).toLongLong()};
    }
    return all;
}

void TestFirmwareEmulated::itKeepsWhatTheProtocolPromises() {
    StationConformance conformance(*m_line);
    QCOMPARE(conformance.all(), QString());
    QCOMPARE(conformance.axes().size(), 3);
    QVERIFY(m_line->broken <= 1);
}

void TestFirmwareEmulated::effortsMoveItsAxes() {
    StationConformance conformance(*m_line);
    QCOMPARE(conformance.pagesDescribeIt(), QString());
    QCOMPARE(conformance.becomesHomed(), QString());
    station_input input{};
    for (int tries = 0; tries < 1000 && input.counts[0] < 2000; ++tries) { // a host that is late is let go
        QCOMPARE(conformance.arm(input), QString());
        while (input.state == STATION_ARMED && input.counts[0] < 2000)
            QVERIFY(conformance.exchange(STATION_OUTPUT_ENABLE, input, 20, 300000));
        QVERIFY(input.state != STATION_FAULT);
    }
    QVERIFY(input.counts[0] >= 2000);
    QCOMPARE(input.counts[1], input.counts[0]); // alike
}

void TestFirmwareEmulated::itLetsGoWhenItsHostIsKilled() {
    qsizetype before = 0;
    bool killedWhileArmed = false;
    for (int tries = 0; tries < 200 && !killedWhileArmed; ++tries) {
        const pid_t host = ::fork();
        QVERIFY(host >= 0);
        if (host == 0)
            keepArmed(*m_line);
        QElapsedTimer waited;
        waited.start();
        QList<Told> now = told();
        while ((now.size() <= before || now.last().state != QLatin1String("armed")) &&
               waited.elapsed() < tests::kPatience_ms) {
            QTest::qWait(1);
            now = told();
        }
        QVERIFY(::kill(host, SIGKILL) == 0);
        int status = 0;
        QVERIFY(::waitpid(host, &status, 0) == host && WIFSIGNALED(status));
        const qsizetype armed = now.size();
        StationConformance afterwards(*m_line); // only listens
        station_input input{};
        for (int inputs = 0; inputs < 400; ++inputs)
            QVERIFY(afterwards.input(input));
        QCOMPARE(int(input.state), int(STATION_HOMED)); // nobody arms it again
        QVERIFY(input.status & STATION_STATUS_LET_GO);
        now = told();
        QVERIFY(!now.isEmpty() && now.last().letGo);
        killedWhileArmed = now.size() == armed + 1; // not one that was late by itself before
        before = now.size();
    }
    QVERIFY(killedWhileArmed);
    int letGo = 0;
    for (const Told& each :
         told()) // by its own clock: when the hold time is over, neither before nor a tick later
        if (each.letGo && each.state == QLatin1String("homed")) {
            ++letGo;
            QVERIFY(each.age_us >= 1000 * each.hold_ms && each.age_us < 1000 * each.hold_ms + 100);
        }
    QVERIFY(letGo >= 1);
    StationConformance next(*m_line); // the next host
    station_counters counters{};
    QVERIFY(next.counters(counters));
    QCOMPARE(int(counters.watchdog_trips), letGo);
    QCOMPARE(next.all(), QString());
}

QTEST_GUILESS_MAIN(TestFirmwareEmulated)
#include "test_firmware_emulated.moc"
