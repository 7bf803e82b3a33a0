// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "station/protocol/station_features.h"

#include <QByteArray>
#include <QList>
#include <QString>
#include <array>
#include <cstdint>

namespace chiron::test {

/// A line to a station, whatever it is: in this program, another process, an emulated micro-controller.
class StationLine {
public:
    using Frame = std::array<std::uint8_t, STATION_FRAME_SIZE>;
    virtual ~StationLine() = default;
    /// Sends frames together. False: the line is gone.
    virtual bool send(const QList<Frame>& frames) = 0;
    /// Waits with patience for the next frame. False: none came.
    virtual bool next(Frame& frame) = 0;
    /// Bytes as they are, where the line is serial; false where it is not.
    virtual bool sendBytes(const QByteArray&) { return false; }
};

/// What every station promises (docs/station-protocol.md), asked over its line. All is judged by the
/// station's own clock and counters, so that a host that is late changes nothing. Each check leaves the
/// station not armed, and returns what is wrong, or nothing.
class StationConformance {
public:
    explicit StationConformance(StationLine& line) : m_line(line) {}

    QString pagesDescribeIt(); ///< first: the others need what it reads
    QString inputsFollowEachOther();
    QString becomesHomed();
    QString armsOnlyAfterAnOutputWithoutEnable();
    QString letsGoWhenTheHostIsSilent();
    QString ignoresAndCountsWhatIsBad();
    QString countsWhatIsLost();
    QString clampsEfforts();
    QString takesANewHost();
    QString findsItsStepAgain(); ///< of serial lines; of others it does nothing

    /// All of them in this order: the first complaint, or nothing.
    QString all();

    const station_identity& identity() const { return m_identity; }
    const QList<station_axis>& axes() const { return m_axes; }
    bool counters(station_counters& counters);
    /// The next input frame; replies on the way are put aside.
    bool input(station_input& input);
    /// Sends an output and waits for the first input that says that it counted.
    bool exchange(std::uint8_t flags, station_input& answer, std::uint8_t hold_ms = STATION_MOST_HOLD_MS,
                  std::int32_t effort = 0);
    /// Arms it, again where a late host let it let go. The answer is armed.
    QString arm(station_input& answer);
    StationLine::Frame output(std::uint8_t flags, std::uint8_t hold_ms = STATION_MOST_HOLD_MS,
                              std::int32_t effort = 0);

private:
    using Frame = StationLine::Frame;
    bool page(std::uint8_t number, Frame& reply);
    bool answered(station_input& answer);
    QString rest();

    StationLine& m_line;
    station_identity m_identity{};
    QList<station_axis> m_axes;
    std::uint16_t m_sequence = 0; ///< of the last output
    QList<Frame> m_replies;
};

} // namespace chiron::test
