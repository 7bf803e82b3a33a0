// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/patience.h"
#include "support/station_conformance.h"
#include "unit/station/station_page_frames.h"

#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>
#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

using namespace chiron;
using namespace chiron::test;

namespace {

/// Whole frames over a socket.
class SocketLine : public StationLine {
public:
    explicit SocketLine(int port) : m_socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        sockaddr_in to{};
        to.sin_family = AF_INET;
        to.sin_port = htons(static_cast<std::uint16_t>(port));
        to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        open = ::connect(m_socket, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0;
        const int one = 1;
        ::setsockopt(m_socket, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one);
    }
    ~SocketLine() override { ::close(m_socket); }
    SocketLine(const SocketLine&) = delete;
    SocketLine& operator=(const SocketLine&) = delete;
    bool send(const QList<Frame>& frames) override {
        QByteArray bytes;
        for (const Frame& frame : frames)
            bytes += QByteArray(reinterpret_cast<const char*>(frame.data()), STATION_FRAME_SIZE);
        return ::send(m_socket, bytes.constData(), static_cast<std::size_t>(bytes.size()), MSG_NOSIGNAL) ==
               bytes.size();
    }
    bool next(Frame& frame) override {
        std::size_t have = 0;
        while (have < frame.size()) {
            pollfd wait{m_socket, POLLIN, 0};
            if (::poll(&wait, 1, tests::kPatience_ms) != 1)
                return false;
            const ssize_t more = ::recv(m_socket, frame.data() + have, frame.size() - have, 0);
            if (more <= 0)
                return false;
            have += static_cast<std::size_t>(more);
        }
        return true;
    }

    bool open = false;

private:
    int m_socket;
};

} // namespace

/// A laboratory has only docs/station-protocol.md.
class TestStationPage : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void itsVectorsAreWhatTheCodeWrites();
    void itsNumbersAreThoseOfTheCode();
    void itsExampleKeepsWhatThePagePromises();

private:
    QString m_page;
};

void TestStationPage::initTestCase() {
    QFile file(QStringLiteral(CHIRON_SOURCE_DIR "/docs/station-protocol.md"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    m_page = QString::fromUtf8(file.readAll());
}

void TestStationPage::itsVectorsAreWhatTheCodeWrites() {
    const QString part =
        m_page.section(QStringLiteral("\n## 8. Test vectors"), 1).section(QStringLiteral("\n## "), 0, 0);
    static const QRegularExpression block(QStringLiteral("```text\n(.*?)\n```"),
                                          QRegularExpression::DotMatchesEverythingOption);
    const auto expected = stationPageBlocks();
    qsizetype number = 0;
    for (auto it = block.globalMatch(part); it.hasNext(); ++number) {
        QVERIFY(number < expected.size());
        QCOMPARE(it.next().captured(1), QString::fromLatin1(expected[number].second));
    }
    QCOMPARE(number, expected.size());
}

void TestStationPage::itsNumbersAreThoseOfTheCode() {
    const QString text = m_page.simplified(); // lines are broken anywhere
    QVERIFY(m_page.startsWith(
        QStringLiteral("# Station protocol, version %1.%2\n").arg(STATION_MAJOR).arg(STATION_MINOR)));
    QVERIFY(text.contains(QStringLiteral("hold in ms, 1 to %1:").arg(STATION_MOST_HOLD_MS)));
    QVERIFY(
        text.contains(QStringLiteral("After %1 ms without a valid output").arg(STATION_NEW_HOST_US / 1000)));
    QVERIFY(text.contains(QStringLiteral("Usage page 0x%1 and usage 0x%2")
                              .arg(STATION_HID_USAGE_PAGE, 4, 16, QLatin1Char('0'))
                              .arg(STATION_HID_USAGE, 4, 16, QLatin1Char('0')),
                          Qt::CaseInsensitive));
    QVERIFY(text.contains(QStringLiteral("kinematics parameters (0–%1)").arg(STATION_MOST_PARAMETERS)));
}

void TestStationPage::itsExampleKeepsWhatThePagePromises() {
    const QString python = QStandardPaths::findExecutable(QStringLiteral("python3"));
    if (python.isEmpty())
        QSKIP("python3 is not installed");
    const QString code =
        m_page.section(QStringLiteral("```python\n"), 1).section(QStringLiteral("\n```"), 0, 0);
    QVERIFY(code.count(QLatin1Char('\n')) > 50 && code.count(QLatin1Char('\n')) < 200);
    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("station.py")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(code.toUtf8());
    file.close();
    QProcess station;
    station.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    station.start(python, {QStringLiteral("-I"), file.fileName(), QStringLiteral("0")});
    QVERIFY(station.waitForStarted(tests::kPatience_ms));
    while (!station.canReadLine())
        QVERIFY(station.waitForReadyRead(tests::kPatience_ms));
    const int port = station.readLine().trimmed().split(' ').last().toInt();
    QVERIFY(port > 0);
    for (int host = 0; host < 2; ++host) { // one after the other
        SocketLine line(port);
        QVERIFY(line.open);
        StationConformance conformance(line);
        QCOMPARE(conformance.all(), QString());
        QCOMPARE(conformance.axes().size(), 3);
    }
    station.kill();
    station.waitForFinished(tests::kPatience_ms);
}

QTEST_GUILESS_MAIN(TestStationPage)
#include "test_station_page.moc"
