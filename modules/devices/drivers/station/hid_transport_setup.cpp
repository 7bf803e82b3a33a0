// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/station/hid_transport.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <hidapi.h>
#include <string>
#include <unistd.h>
#include <vector>

namespace chiron::devices {

namespace {

/// The first of the usage pages that makers define for themselves.
constexpr unsigned kVendorDefined = 0xFF00;
constexpr std::int64_t kMillisecond_ns = 1'000'000;
/// hidapi waits for whole milliseconds; shorter waits look at the device this often.
constexpr std::int64_t kLook_ns = 50'000;

class HidTransport final : public IStationTransport {
public:
    explicit HidTransport(hid_device* device) noexcept : m_device(device) {}
    ~HidTransport() override { closeIt(); }

    station::Sent send(const station::FrameBytes& frame) noexcept override {
        if (m_device == nullptr)
            return station::Sent::gone;
        std::array<unsigned char, station::kFrameBytes + 1> report{}; // begins with the report's number: none
        std::copy(frame.begin(), frame.end(), report.begin() + 1);
        return ::hid_write(m_device, report.data(), report.size()) < 0 ? station::Sent::gone
                                                                       : station::Sent::sent;
    }
    station::Received receive(station::FrameBytes& frame, std::int64_t deadline_ns) noexcept override {
        if (m_device == nullptr)
            return station::Received::gone;
        for (;;) {
            const std::int64_t left_ns = deadline_ns - station::steadyNow_ns();
            const auto wait_ms =
                static_cast<int>(std::clamp<std::int64_t>(left_ns / kMillisecond_ns, 0, 1000));
            const int got = ::hid_read_timeout(m_device, frame.data(), frame.size(), wait_ms);
            if (got < 0)
                return station::Received::gone;
            if (got == static_cast<int>(frame.size()))
                return station::Received::frame;
            if (got > 0)
                ++m_malformed;
            if (left_ns <= 0)
                return station::Received::nothing;
            if (got > 0)
                continue;
            if (wait_ms == 0) {
                const timespec rest{0, std::min(left_ns, kLook_ns)};
                (void)::clock_nanosleep(CLOCK_MONOTONIC, 0, &rest, nullptr);
            }
        }
    }
    void close() noexcept override { closeIt(); }
    std::uint64_t malformed() const noexcept override { return m_malformed; }

private:
    void closeIt() noexcept {
        if (m_device != nullptr)
            ::hid_close(m_device);
        m_device = nullptr;
    }

    hid_device* m_device;
    std::uint64_t m_malformed = 0;
};

/// A node of the kernel's that reaches a device with these numbers.
struct PluggedIn {
    std::string path;
    std::string serialNumber;
    bool vendorDefined = false;
};

/// Serial numbers that USB gives are Unicode; what is not ASCII is shown as "?".
std::string asciiOf(const wchar_t* text) {
    std::string ascii;
    for (; text != nullptr && *text != 0; ++text)
        ascii += *text > 0x20 && *text < 0x7F ? static_cast<char>(*text) : '?';
    return ascii;
}

/// What is plugged in with these numbers, each node once. Nothing is opened.
std::vector<PluggedIn> pluggedIn(const StationAddress& address) {
    std::vector<PluggedIn> found;
    hid_device_info* const all = ::hid_enumerate(address.vendor, address.product);
    for (const hid_device_info* each = all; each != nullptr; each = each->next) {
        PluggedIn one{each->path, asciiOf(each->serial_number), each->usage_page >= kVendorDefined};
        if (!address.serialNumber.empty() && one.serialNumber != address.serialNumber)
            continue;
        const auto known = std::find_if(found.begin(), found.end(),
                                        [&one](const PluggedIn& other) { return other.path == one.path; });
        if (known == found.end())
            found.push_back(std::move(one));
        else
            known->vendorDefined = known->vendorDefined || one.vendorDefined;
    }
    ::hid_free_enumeration(all);
    // A device with a keyboard or a mouse of its own has a node for each.
    if (std::any_of(found.begin(), found.end(), [](const PluggedIn& one) { return one.vendorDefined; }))
        std::erase_if(found, [](const PluggedIn& one) { return !one.vendorDefined; });
    return found;
}

std::string nameOf(const StationAddress& address) {
    char ids[16];
    (void)std::snprintf(ids, sizeof ids, "%04x:%04x", unsigned{address.vendor}, unsigned{address.product});
    return std::string("station at hid:") + ids +
           (address.serialNumber.empty() ? "" : ":" + address.serialNumber);
}

} // namespace

core::Result<std::unique_ptr<IStationTransport>> openHid(const StationAddress& address) {
    const auto refuse = [&address](const std::string& why) {
        return core::fail(core::ErrorCode::device, nameOf(address) + ": " + why);
    };
    if (::hid_init() != 0)
        return refuse("USB HID is not available on this computer");
    const std::vector<PluggedIn> found = pluggedIn(address);
    if (found.empty())
        return refuse("no such USB device is plugged in; check that it is plugged in and switched on");
    if (found.size() > 1) {
        std::string serials;
        for (const PluggedIn& one : found)
            serials +=
                (serials.empty() ? "" : ", ") + (one.serialNumber.empty() ? "(none)" : one.serialNumber);
        return refuse("several are plugged in, with the serial numbers " + serials +
                      "; add the one that is meant, as hid:VVVV:PPPP:SERIAL");
    }
    const std::string& path = found.front().path;
    if (hid_device* const device = ::hid_open_path(path.c_str()); device != nullptr)
        return std::make_unique<HidTransport>(device);
    if (::access(path.c_str(), R_OK | W_OK) != 0 && errno == EACCES)
        return refuse("this person may not open " + path +
                      "; install the rule of packaging/udev, then plug the station in again");
    return refuse(path + " cannot be opened; plug the station in again");
}

} // namespace chiron::devices
