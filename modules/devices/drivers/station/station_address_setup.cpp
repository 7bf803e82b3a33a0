// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/station/station_address.h"

#include <charconv>

namespace chiron::devices {

namespace {

tl::unexpected<core::Error> notAnAddress(std::string_view text) {
    return core::fail(
        core::ErrorCode::badInput,
        "station: \"" + std::string(text) +
            "\" is no address; expected tcp:HOST:PORT, serial:/dev/NAME or hid:VVVV:PPPP[:SERIAL], "
            "with the four hexadecimal digits of USB's vendor and product");
}

/// Reads the whole of `text` as a number from 1 to 65535.
bool readPort(std::string_view text, std::uint16_t& number) {
    const char* const end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, number);
    return error == std::errc() && stopped == end && number > 0;
}

bool readTcp(std::string_view text, StationAddress& address) {
    address.kind = StationAddress::Kind::tcp;
    const std::size_t colon = text.rfind(':');
    if (colon == std::string_view::npos || !readPort(text.substr(colon + 1), address.port))
        return false;
    std::string_view host = text.substr(0, colon);
    if (host.size() > 2 && host.front() == '[' && host.back() == ']')
        host = host.substr(1, host.size() - 2);
    else if (host.find(':') != std::string_view::npos)
        return false;
    address.host = std::string(host);
    return !host.empty();
}

/// Reads four hexadecimal digits.
bool readId(std::string_view text, std::uint16_t& number) {
    const char* const end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, number, 16);
    return text.size() == 4 && error == std::errc() && stopped == end;
}

bool readHid(std::string_view text, StationAddress& address) {
    constexpr std::size_t kIds = 9; // VVVV:PPPP
    address.kind = StationAddress::Kind::hid;
    if (text.size() < kIds || text[4] != ':' || !readId(text.substr(0, 4), address.vendor) ||
        !readId(text.substr(5, 4), address.product))
        return false;
    if (text.size() == kIds)
        return true;
    address.serialNumber = std::string(text.substr(kIds + 1));
    return text[kIds] == ':' && !address.serialNumber.empty();
}

} // namespace

core::Result<StationAddress> readStationAddress(std::string_view text) {
    constexpr std::string_view kTcp = "tcp:", kSerial = "serial:", kHid = "hid:";
    StationAddress address;
    bool right = false;
    if (text.starts_with(kTcp)) {
        right = readTcp(text.substr(kTcp.size()), address);
    } else if (text.starts_with(kSerial)) {
        address.kind = StationAddress::Kind::serial;
        address.path = std::string(text.substr(kSerial.size()));
        right = address.path.starts_with('/');
    } else if (text.starts_with(kHid)) {
        right = readHid(text.substr(kHid.size()), address);
    }
    if (!right)
        return notAnAddress(text);
    return address;
}

} // namespace chiron::devices
