// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/station_conformance.h"

#include <algorithm>
#include <utility>

namespace chiron::test {

namespace {

constexpr int kMostInputs = 5000; ///< that may pass before one answers
constexpr int kMostArmings = 200;

QString silent() {
    return QStringLiteral("the station is silent, or does not answer");
}

QString told(const char* what, const station_input& input) {
    return QStringLiteral("%1: state %2, flags %3, status %4, age %5 ms")
        .arg(QLatin1String(what))
        .arg(input.state)
        .arg(input.flags)
        .arg(input.status)
        .arg(input.applied_age_ms);
}

bool armed(const station_input& input) {
    return input.state == STATION_ARMED;
}

bool letGo(const station_input& input) {
    return (input.status & STATION_STATUS_LET_GO) != 0;
}

} // namespace

bool StationConformance::input(station_input& input) {
    for (int i = 0; i < kMostInputs; ++i) {
        Frame frame{};
        if (!m_line.next(frame))
            return false;
        if (station_decode_input(frame.data(), &input) == STATION_OK)
            return true;
        if (station_frame_type(frame.data()) != STATION_FEATURE_REPLY)
            return false; // a station sends nothing else
        m_replies.append(frame);
    }
    return false;
}

StationLine::Frame StationConformance::output(std::uint8_t flags, std::uint8_t hold_ms, std::int32_t effort) {
    station_output output{};
    output.flags = flags;
    output.sequence = ++m_sequence;
    output.hold_ms = hold_ms;
    for (std::int32_t& each : output.effort)
        each = effort;
    Frame frame{};
    (void)station_encode_output(&output, frame.data());
    return frame;
}

bool StationConformance::answered(station_input& answer) {
    for (int i = 0; i < kMostInputs; ++i) {
        if (!input(answer))
            return false;
        if (answer.applied_sequence == m_sequence && answer.applied_age_ms < 255)
            return true;
    }
    return false;
}

bool StationConformance::exchange(std::uint8_t flags, station_input& answer, std::uint8_t hold_ms,
                                  std::int32_t effort) {
    return m_line.send({output(flags, hold_ms, effort)}) && answered(answer);
}

bool StationConformance::page(std::uint8_t number, Frame& reply) {
    Frame request{};
    (void)station_encode_feature_request(number, request.data());
    m_replies.clear();
    if (!m_line.send({request}))
        return false;
    for (int i = 0; i < kMostInputs && m_replies.isEmpty(); ++i) {
        station_input on{};
        if (!input(on))
            return false;
    }
    if (m_replies.isEmpty())
        return false;
    reply = m_replies.takeFirst();
    return reply[1] == number;
}

bool StationConformance::counters(station_counters& counters) {
    Frame reply{};
    return page(STATION_PAGE_COUNTERS, reply) &&
           station_decode_counters(reply.data(), &counters) == STATION_OK;
}

QString StationConformance::rest() {
    station_input on{};
    if (!exchange(0, on))
        return silent();
    return armed(on) ? told("armed without enable", on) : QString();
}

QString StationConformance::arm(station_input& answer) {
    for (int i = 0; i < kMostArmings; ++i) {
        if (!exchange(0, answer) || !exchange(STATION_OUTPUT_ENABLE, answer))
            return silent();
        if (armed(answer))
            return {};
        if (!letGo(answer) || answer.applied_age_ms < STATION_MOST_HOLD_MS)
            return told("not armed", answer);
    }
    return QStringLiteral("the host is too slow to keep it armed");
}

QString StationConformance::pagesDescribeIt() {
    Frame reply{};
    if (!page(STATION_PAGE_IDENTITY, reply))
        return silent();
    if (station_decode_identity(reply.data(), &m_identity) != STATION_OK)
        return QStringLiteral("page 0 is refused");
    if (m_identity.major != STATION_MAJOR)
        return QStringLiteral("version %1").arg(m_identity.major);
    m_axes.clear();
    const int parameterPages =
        (m_identity.parameters + STATION_PARAMETERS_A_PAGE - 1) / STATION_PARAMETERS_A_PAGE;
    for (int number = 1; number < 256; ++number) {
        if (number == 60)
            number = 250; // beyond all that may be
        if (!page(static_cast<std::uint8_t>(number), reply))
            return silent();
        const bool axisPage = number >= 16 && number < 16 + m_identity.axes;
        const bool parameterPage = number >= 32 && number < 32 + parameterPages;
        station_names names{};
        station_kinematics kinematics{};
        station_calibration calibration{};
        station_counters counters{};
        station_axis axis{};
        station_parameters parameters{};
        const auto index = static_cast<std::uint8_t>(number % 16);
        bool good = reply[2] == STATION_NO_SUCH_PAGE;
        if (number == STATION_PAGE_NAMES)
            good = station_decode_names(reply.data(), &names) == STATION_OK && names.model[0] != 0;
        else if (number == STATION_PAGE_KINEMATICS)
            good =
                station_decode_kinematics(reply.data(), &kinematics) == STATION_OK && kinematics.id[0] != 0;
        else if (number == STATION_PAGE_CALIBRATION)
            good = station_decode_calibration(reply.data(), &calibration) == STATION_OK;
        else if (number == STATION_PAGE_COUNTERS)
            good = station_decode_counters(reply.data(), &counters) == STATION_OK;
        else if (axisPage)
            good = station_decode_axis(reply.data(), index, &axis) == STATION_OK && axis.id[0] != 0;
        else if (parameterPage)
            good = station_decode_parameters(reply.data(), index, &parameters) == STATION_OK;
        if (!good)
            return QStringLiteral("page %1 is refused, or is there and should not be").arg(number);
        if (axisPage)
            m_axes.append(axis);
    }
    return {};
}

QString StationConformance::inputsFollowEachOther() {
    station_input before{}, now{};
    if (!input(before))
        return silent();
    for (int i = 0; i < 300; ++i) {
        if (!input(now))
            return silent();
        if (now.sequence != static_cast<std::uint16_t>(before.sequence + 1))
            return QStringLiteral("input %1 after %2").arg(now.sequence).arg(before.sequence);
        const std::uint32_t passed = now.time_us - before.time_us;
        if (passed == 0 || passed > 0x80000000u)
            return QStringLiteral("its clock stands still or goes back: %1 µs").arg(now.time_us);
        if (armed(now))
            return told("armed by nobody", now);
        for (int axis = m_identity.axes; axis < STATION_AXES; ++axis)
            if (now.counts[axis] != 0)
                return QStringLiteral("axis %1 is not there and counts").arg(axis);
        before = now;
    }
    return {};
}

QString StationConformance::becomesHomed() {
    station_input on{};
    for (int i = 0; i < 20; ++i) {
        if (!exchange(i < 10 ? 0 : STATION_OUTPUT_HOME, on))
            return silent();
        if (on.state == STATION_HOMED)
            return {};
    }
    return told("not homed", on);
}

QString StationConformance::armsOnlyAfterAnOutputWithoutEnable() {
    station_input on{};
    if (const QString wrong = arm(on); !wrong.isEmpty())
        return wrong;
    for (int i = 0; i < 30; ++i) { // until it has let go
        if (!input(on))
            return silent();
    }
    if (armed(on) || !letGo(on))
        return told("does not let go", on);
    for (int i = 0; i < 20; ++i) {
        if (!exchange(STATION_OUTPUT_ENABLE | (i % 2 ? STATION_OUTPUT_HOME : STATION_OUTPUT_CLEAR_FAULT), on,
                      20, 1000))
            return silent();
        if (armed(on) || !letGo(on))
            return told("armed again by enable alone", on);
    }
    if (!exchange(0, on))
        return silent();
    if (armed(on))
        return told("armed without enable", on);
    if (const QString wrong = arm(on); !wrong.isEmpty())
        return wrong;
    if (letGo(on))
        return told("still says that it let go", on);
    return rest();
}

QString StationConformance::letsGoWhenTheHostIsSilent() {
    for (const int hold_ms : {1, 2, 5, 10, 15, 20}) {
        const auto hold = static_cast<std::uint8_t>(hold_ms);
        station_counters before{}, after{};
        if (!counters(before))
            return silent();
        station_input on{};
        int trips = 0;
        for (int i = 0; i < kMostArmings && trips == 0; ++i) {
            if (!exchange(0, on) || !m_line.send({output(STATION_OUTPUT_ENABLE, hold)}) || !answered(on))
                return silent();
            for (int inputs = 0; inputs < 60; ++inputs) {
                const bool late = on.applied_age_ms >= hold;
                if (armed(on) == late || letGo(on) != late)
                    return told(qPrintable(QStringLiteral("hold of %1 ms").arg(hold)), on);
                if (late) {
                    ++trips;
                    break;
                }
                if (!input(on))
                    return silent();
            }
        }
        if (trips == 0)
            return told("does not let go", on);
        if (!counters(after))
            return silent();
        if (after.watchdog_trips != before.watchdog_trips + 1)
            return QStringLiteral("counts %1 trips").arg(after.watchdog_trips - before.watchdog_trips);
    }
    return rest();
}

QString StationConformance::ignoresAndCountsWhatIsBad() {
    station_counters before{}, after{};
    if (const QString wrong = rest(); !wrong.isEmpty())
        return wrong;
    if (!counters(before))
        return silent();
    const Frame good = output(0);
    const auto made = [&](std::size_t at, std::uint8_t value, bool sealed) {
        Frame frame = good;
        station_put_u16(frame.data() + 2, static_cast<std::uint16_t>(m_sequence + 1));
        station_seal(frame.data());
        if (sealed) {
            frame[at] = value;
            station_seal(frame.data());
        } else {
            frame[at] ^= value;
        }
        return frame;
    };
    const QList<Frame> frames{good,
                              made(20, 0x55, false), // wrong CRC
                              made(63, 0x80, false),
                              made(0, 1, true), // an input, a reply, and what is no type
                              made(0, 4, true),
                              made(0, 0, true),
                              made(0, 99, true),
                              made(6, 0, true), // no hold, too long a hold
                              made(6, 21, true),
                              made(6, 255, true),
                              good, // twice
                              good};
    station_input on{};
    if (!m_line.send(frames) || !answered(on))
        return silent();
    if (!exchange(0, on) || !counters(after)) // a good one comes through
        return silent();
    if (after.bad_crc != before.bad_crc + 2 || after.bad_frames != before.bad_frames + 7 ||
        after.stale_outputs != before.stale_outputs + 2 || after.lost_outputs != before.lost_outputs)
        return QStringLiteral("counts %1 of 2 wrong CRCs, %2 of 7 wrong frames, %3 of 2 repeated, %4 lost")
            .arg(after.bad_crc - before.bad_crc)
            .arg(after.bad_frames - before.bad_frames)
            .arg(after.stale_outputs - before.stale_outputs)
            .arg(after.lost_outputs - before.lost_outputs);
    // A bad frame arms nobody, and does not renew the hold time.
    if (const QString wrong = arm(on); !wrong.isEmpty())
        return wrong;
    for (int i = 0; i < 60 && armed(on); ++i) {
        Frame bad = output(STATION_OUTPUT_ENABLE);
        --m_sequence;
        bad[62] ^= 1;
        if (!m_line.send({bad}) || !input(on))
            return silent();
        if (on.applied_sequence != m_sequence)
            return QStringLiteral("a frame with a wrong CRC counted");
        if (armed(on) != (on.applied_age_ms < STATION_MOST_HOLD_MS))
            return told("a frame with a wrong CRC renewed the hold time", on);
    }
    if (armed(on))
        return told("does not let go", on);
    return rest();
}

QString StationConformance::countsWhatIsLost() {
    station_counters before{}, after{};
    station_input on{};
    if (!counters(before))
        return silent();
    const Frame first = output(0);
    m_sequence = static_cast<std::uint16_t>(m_sequence + 5);
    const Frame second = output(0);
    m_sequence = static_cast<std::uint16_t>(m_sequence + 32766); // over the end of the circle at one of three
    const Frame third = output(0);
    m_sequence = static_cast<std::uint16_t>(m_sequence + 32766);
    const Frame fourth = output(0);
    if (!m_line.send({first, second, third, fourth}) || !answered(on) || !counters(after))
        return silent();
    const std::uint32_t lost = after.lost_outputs - before.lost_outputs;
    if (lost != 5 + 32766 + 32766)
        return QStringLiteral("counts %1 lost outputs").arg(lost);
    return {};
}

QString StationConformance::clampsEfforts() {
    float least = 1e9f;
    for (const station_axis& axis : m_axes)
        if (axis.rating > 0.0f)
            least = std::min(least, axis.rating);
    if (least > 1e8f)
        return {}; // no motors
    for (int i = 0; i < kMostArmings; ++i) {
        station_input on{};
        if (const QString wrong = arm(on); !wrong.isEmpty())
            return wrong;
        station_input beyond{}, none{};
        if (!exchange(STATION_OUTPUT_ENABLE, beyond, 20, 2147483647) ||
            !exchange(STATION_OUTPUT_ENABLE, none, 20, 0))
            return silent();
        if (!armed(beyond) || !armed(none))
            continue; // the host was late
        if (!(beyond.status & STATION_STATUS_AT_LIMIT))
            return told("an effort beyond the rating is not flagged", beyond);
        if (none.status & STATION_STATUS_AT_LIMIT)
            return told("no effort, and flagged", none);
        return rest();
    }
    return QStringLiteral("the host is too slow to keep it armed");
}

QString StationConformance::takesANewHost() {
    station_input on{}, later{};
    if (!exchange(0, on))
        return silent();
    for (int i = 0; i < kMostInputs; ++i) { // half a second of the station's
        if (!input(later))
            return silent();
        if (later.time_us - on.time_us > 600000u)
            break;
    }
    if (later.applied_age_ms != 255)
        return told("the age of its last output", later);
    m_sequence = static_cast<std::uint16_t>(m_sequence - 1000);
    if (!exchange(STATION_OUTPUT_ENABLE, on))
        return QStringLiteral("it does not take an older number of a new host");
    if (!exchange(0, on))
        return silent();
    return rest();
}

QString StationConformance::findsItsStepAgain() {
    station_counters before{}, after{};
    if (!counters(before))
        return silent();
    QByteArray damaged;
    for (int i = 0; i < 200; ++i)
        damaged += static_cast<char>(1 + (i * 37) % 255);
    damaged += '\0';
    damaged += QByteArray(10, 'x') + '\0' + QByteArray(2, '\0');
    if (!m_line.sendBytes(damaged))
        return {};
    if (const QString wrong = rest(); !wrong.isEmpty())
        return QStringLiteral("out of step: ") + wrong;
    if (!m_line.sendBytes("cut")) // and a good frame right behind, which is lost with it
        return silent();
    station_input on{};
    if (!m_line.send({output(0), output(0)}) || !answered(on) || !counters(after))
        return silent();
    if (after.bad_crc != before.bad_crc + 3)
        return QStringLiteral("counts %1 of 3 broken blocks").arg(after.bad_crc - before.bad_crc);
    return rest();
}

QString StationConformance::all() {
    using Check = QString (StationConformance::*)();
    const std::pair<const char*, Check> checks[] = {
        {"pages", &StationConformance::pagesDescribeIt},
        {"inputs", &StationConformance::inputsFollowEachOther},
        {"homing", &StationConformance::becomesHomed},
        {"arming", &StationConformance::armsOnlyAfterAnOutputWithoutEnable},
        {"hold time", &StationConformance::letsGoWhenTheHostIsSilent},
        {"bad frames", &StationConformance::ignoresAndCountsWhatIsBad},
        {"lost frames", &StationConformance::countsWhatIsLost},
        {"limits", &StationConformance::clampsEfforts},
        {"a new host", &StationConformance::takesANewHost},
        {"serial line", &StationConformance::findsItsStepAgain},
    };
    for (const auto& [name, check] : checks)
        if (const QString wrong = (this->*check)(); !wrong.isEmpty())
            return QLatin1String(name) + QStringLiteral(": ") + wrong;
    return {};
}

} // namespace chiron::test
